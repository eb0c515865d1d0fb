#pragma once

#include "ui/kit/message_strip.h"
#include "ui/kit/progress_job.h"
#include "ui/sprites/sprite_drawer.h"
#include "ui/sprites/sprite_setup.h"

#include <QDialog>
#include <QTimer>

class QComboBox;
class QLabel;

namespace vitrine::ui {

class ExportBar;
class ParameterPanel;
class SpritePreview;

/// Makes sheets of sprites: what is set on the left, the sprite turning on the right, and the export, which is the same
/// to the byte as that of `vitrine sprite`.
class SpriteDialog final : public QDialog {
    Q_OBJECT

public:
    /// `look`: values of `spriteLookName`, in whose look the sprite is drawn. The others must outlive it.
    SpriteDialog(ParameterValues look, Renderers&, RenderThread&, QWidget* parent);
    ~SpriteDialog() override;

    [[nodiscard]] SpriteSetup& setup() { return setup_; }
    [[nodiscard]] SpritePreview& preview() { return *preview_; }
    void setPath(const QString&);
    [[nodiscard]] QString path() const;
    [[nodiscard]] bool exporting() const { return exporting_; }
    /// The preview shows what is set, or nothing can be shown.
    [[nodiscard]] bool settled() const;
    /// As its button: asks before files are replaced.
    void startExport();

    void done(int result) override;
    void reject() override;

signals:
    /// `written`: the files are there.
    void exportEnded(bool written);

private:
    void build();
    void buildUndo();
    void connectParts();
    void recall();
    void remember();
    void follow();
    void readObject();
    void takeObject(const std::shared_ptr<const SpriteSubject>&);
    void showAnimations();
    void showButtons();
    void lookAgain();
    void showDraft(const SpriteDrawer::Frames&);
    void begin();
    void write(const SpriteDrawer::Frames&);
    void endExport(const QString& words);
    void complain(const QString&);
    [[nodiscard]] std::string whyNot() const;

    ParameterValues look_;
    SpriteSetup setup_;
    SpriteDrawer draft_, full_;
    ProgressJob read_, sheet_, write_;
    QTimer soon_;  ///< Not at every step of a slider.
    std::shared_ptr<const SpriteSubject> subject_;
    std::string model_ = "?";  ///< That was read last; no file has this name at first.
    bool exporting_ = false;
    bool remembered_ = false;

    MessageStrip* messages_;
    ParameterPanel* panel_;
    QComboBox* animation_;
    QLabel* numbers_;
    SpritePreview* preview_;
    ExportBar* export_;
};

}  // namespace vitrine::ui

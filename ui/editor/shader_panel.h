#pragma once

#include "ui/editor/code_view.h"
#include "ui/editor/pass_texts.h"

#include <QWidget>

#include <cstddef>
#include <future>
#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

class DocumentFile;
class FindBar;
class LiveText;
class ShaderCopy;
class Workbench;

/// Panel with the shader of the visited exhibit. A visitor's shader is edited; the shaders of all passes are shown. The
/// view of the text is opened when the panel is first shown.
class ShaderPanel final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the panel.
    ShaderPanel(Workbench&, DocumentFile&, QWidget* parent = nullptr);
    ~ShaderPanel() override;

    void setSubject(std::size_t exhibit);
    [[nodiscard]] LiveText& live() const { return *live_; }
    [[nodiscard]] ShaderCopy& copy() const { return *copy_; }
    /// Returns the view of the text; null before the panel was shown, or if its module is missing.
    [[nodiscard]] CodeView* view() const { return view_.get(); }
    /// Box with the edited text, if there is one, and the shaders of the passes.
    [[nodiscard]] QComboBox& choice() const { return *choice_; }
    [[nodiscard]] QString stateText() const;

protected:
    void showEvent(QShowEvent*) override;
    void changeEvent(QEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    [[nodiscard]] QWidget* bar();
    void fillTemplates();
    void openView();
    void dress();
    [[nodiscard]] bool isEdited() const;
    /// Shows the chosen text.
    void showChosen();
    void showFindings();
    void setState(const QString&);
    void showReplaced();
    void askForPasses();
    void takePasses(std::size_t exhibit, std::vector<PassText>, const QString& whyNoCopy);
    void fillChoice();
    void openOutside();
    void openMenu(const QPoint&);
    void find(const QString& words, bool forward);

    Workbench& window_;
    DocumentFile& file_;
    LiveText* live_;
    ShaderCopy* copy_;
    std::unique_ptr<CodeView> view_;
    std::size_t subject_ = 0;
    std::vector<PassText> passes_;
    std::future<void> planning_;
    QVBoxLayout* layout_;
    QComboBox* choice_;
    QToolButton *templates_ = nullptr, *save_ = nullptr, *outside_ = nullptr, *copyButton_ = nullptr;
    QLabel* state_;
    FindBar* find_;
};

}  // namespace vitrine::ui

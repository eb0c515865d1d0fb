#pragma once

#include "ui/record/film_maker.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace vitrine::ui {

class Bookmarks;
class ExportBar;
class Workbench;

/// Asks how the camera moves, for how long and into what file, and records it beside the window, which goes on.
class RecordDialog final : public QDialog {
    Q_OBJECT

public:
    /// How the camera moves, in the order of the list.
    enum class Way : std::uint8_t { bookmarks, round, tour, still };

    /// Both must outlive it.
    RecordDialog(Workbench&, const Bookmarks&, QWidget* parent);

    void setWay(Way);
    void setPath(const QString&);
    [[nodiscard]] QString path() const;
    [[nodiscard]] QString status() const;
    [[nodiscard]] bool recording() const { return maker_.running(); }
    /// As its button: asks before a file is replaced.
    void startRecording();

    void done(int result) override;
    void reject() override;

signals:
    /// `written`: the film is there.
    void recordingEnded(bool written);

private:
    void build();
    void layOut();
    void recall();
    void remember() const;
    void showPossible();
    void begin();
    void endRecording(const QString& words, bool written);
    [[nodiscard]] Way way() const;
    [[nodiscard]] RecordingRequest request() const;
    [[nodiscard]] FilmWish wish() const;

    Workbench& window_;
    const Bookmarks& bookmarks_;
    FilmMaker maker_;
    QComboBox* way_;
    QDoubleSpinBox *angle_, *seconds_, *rate_, *shutter_;
    QSpinBox *width_, *height_, *samples_;
    QLabel* about_;
    ExportBar* export_;
};

}  // namespace vitrine::ui

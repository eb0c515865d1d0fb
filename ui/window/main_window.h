#pragma once

#include "render/plan/diagnostics.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/renderers.h"

#include <QMainWindow>

#include <memory>

namespace vitrine::jobs {
class Job;
}

namespace vitrine::ui {

class Bookmarks;
class CloseGuard;
class CompareDesk;
class ExportAgain;
class FileOpener;
class GamepadControl;
class LessonDesk;
class MessageStrip;
class ParameterPanel;
class PresetShelf;
class SessionKeeper;
class StatusLine;
class StudyDock;
class Viewport;
class WindowDocks;
class WindowPreferences;
struct WindowActions;

/// The workbench: the picture in the middle, everything else around it.
class MainWindow final : public QMainWindow, public Workbench {
    Q_OBJECT

public:
    /// Both must outlive it.
    MainWindow(const Museum&, Renderers&, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] const Museum& museum() const override { return museum_; }
    [[nodiscard]] Renderers& renderers() const override { return renderers_; }
    [[nodiscard]] History& history() override { return history_; }
    [[nodiscard]] Viewport& viewport() const override { return *viewport_; }
    [[nodiscard]] std::size_t chosen() const override { return chosen_; }
    [[nodiscard]] std::size_t shown() const override;
    void choose(std::size_t exhibit) override;
    void say(MessageStrip::Mood, const QString& text, const QString& several = {}, const QString& what = {},
             const QString& file = {}) override;
    void setProblems(const QString& cause, const QStringList& texts) override;

    /// Chooses an exhibit and goes there.
    void visit(std::size_t exhibit);
    /// Nothing but the picture is shown.
    [[nodiscard]] bool bare() const { return bare_; }
    [[nodiscard]] ParameterPanel& panel() const;
    [[nodiscard]] StudyDock& study() const;
    [[nodiscard]] PresetShelf& shelf() const { return *shelf_; }
    [[nodiscard]] FileOpener& files() const { return *files_; }
    [[nodiscard]] ExportAgain& again() const { return *again_; }
    [[nodiscard]] WindowDocks& docks() const { return *docks_; }
    [[nodiscard]] CompareDesk& comparison() const { return *comparison_; }
    [[nodiscard]] Bookmarks& bookmarks() const { return *bookmarks_; }
    [[nodiscard]] LessonDesk& lessons() const { return *lessons_; }
    [[nodiscard]] WindowPreferences& preferences() const { return *preferences_; }
    [[nodiscard]] GamepadControl& gamepad() const { return *gamepad_; }

    /// Of a first window on a screen with this much room, its frame left out: as large as is useful, never larger.
    [[nodiscard]] static QSize firstSize(const QSize& room);

    // What the actions do.
    void hidePanels(bool hidden);
    void findParameter();
    void openAbout();
    void setFullScreen(bool);
    void openScreenshotDialog();
    void openPrintDialog(const QString& print = {});
    void openJobDialog(const jobs::Job&);
    void openRecordDialog();
    /// Asks for a file, and writes the bookmarks to it.
    void saveTour();
    void resetEverything();
    void openPalette();
    void openShortcutSheet();
    /// What is behind this subject: its page.
    void openPage(std::size_t subject);
    /// Shows the page of this name: an exhibit's, or "syllabus".
    void openPage(const QString& page);

protected:
    bool event(QEvent*) override;
    void closeEvent(QCloseEvent*) override;
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    void buildMiddle();
    void connectParts();
    void connectViewport();
    void addLessons();
    void addGamepad();
    void showRow(const QString& name);
    void showShippedThumbnails();
    void showTitle();
    void noteFrame(const render::FrameReport&, const QSize& pixels);
    void showComplaints(const std::vector<render::CulledPass>&);
    void keepThumbnail();

    const Museum& museum_;
    Renderers& renderers_;
    History history_;
    Viewport* viewport_;
    MessageStrip* messages_;
    StatusLine* status_;
    WindowDocks* docks_ = nullptr;
    PresetShelf* shelf_ = nullptr;
    FileOpener* files_ = nullptr;
    CompareDesk* comparison_ = nullptr;
    Bookmarks* bookmarks_ = nullptr;
    LessonDesk* lessons_ = nullptr;
    GamepadControl* gamepad_ = nullptr;
    SessionKeeper* keeper_ = nullptr;
    CloseGuard* guard_ = nullptr;
    ExportAgain* again_ = nullptr;
    WindowPreferences* preferences_;
    render::Diagnostics complaints_;  // Those that are in the log already.
    std::unique_ptr<WindowActions> actions_;
    bool bare_ = false;  // Panels, menu and status line are hidden.
    std::size_t chosen_ = hallIndex;
};

}  // namespace vitrine::ui

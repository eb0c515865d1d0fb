#pragma once

#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/renderers.h"
#include "ui/window/window_commands.h"

#include <QMainWindow>

#include <memory>
#include <vector>

namespace vitrine::ui {

class Bookmarks;
class CloseGuard;
class CompareController;
class Controllers;
class ExportAgain;
class FileOpener;
class LessonController;
class MessageStrip;
class ParameterPanel;
class PresetController;
class SessionKeeper;
class StatusLine;
class Viewport;
class VisitCard;
struct VisitOffer;
class WindowDialogs;
class WindowDocks;
class WindowPreferences;

/// Returns the size of a first window on a screen with this much room, without its frame: as large as is useful.
[[nodiscard]] QSize firstWindowSize(const QSize& room);

/// The workbench, with more than 15 members because it owns each of its parts once. The picture is in the middle,
/// everything else around it. The window connects its parts, which do the work.
class MainWindow final : public QMainWindow, public Workbench {
    Q_OBJECT

public:
    /// Museum and renderers must outlive it.
    MainWindow(const Museum&, Renderers&, const MakesCommands&);
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
    /// Returns whether panels and bars are hidden, so that only the picture is shown.
    [[nodiscard]] bool bare() const { return bare_; }
    [[nodiscard]] ParameterPanel& panel() const;
    [[nodiscard]] PresetController& presetController() const { return *presetController_; }
    [[nodiscard]] FileOpener& files() const { return *files_; }
    [[nodiscard]] ExportAgain& again() const { return *again_; }
    [[nodiscard]] WindowDocks& docks() const { return *docks_; }
    [[nodiscard]] CompareController& comparison() const { return *comparison_; }
    [[nodiscard]] Bookmarks& bookmarks() const { return *bookmarks_; }
    [[nodiscard]] LessonController& lessons() const { return *lessons_; }
    [[nodiscard]] WindowPreferences& preferences() const { return *preferences_; }
    [[nodiscard]] WindowDialogs& dialogs() const { return *dialogs_; }

    void hidePanels(bool hidden);
    /// Shows the panel with this parameter, which gets the focus. Visits the subject if the panel has no tab for it.
    void showParameter(std::size_t subject, std::string_view name);

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
    void addControllers();
    void showRow(const QString& name);
    void showTitle();
    [[nodiscard]] std::vector<VisitOffer> visitOffers(std::size_t exhibit);

    const Museum& museum_;
    Renderers& renderers_;
    History history_;
    Viewport* viewport_;
    MessageStrip* messages_;
    StatusLine* status_;
    WindowDocks* docks_ = nullptr;
    PresetController* presetController_ = nullptr;
    FileOpener* files_ = nullptr;
    CompareController* comparison_ = nullptr;
    Bookmarks* bookmarks_ = nullptr;
    LessonController* lessons_ = nullptr;
    SessionKeeper* keeper_ = nullptr;
    CloseGuard* guard_ = nullptr;
    ExportAgain* again_ = nullptr;
    WindowDialogs* dialogs_ = nullptr;
    WindowPreferences* preferences_;
    std::unique_ptr<WindowCommands> commands_;
    VisitCard* visitCard_ = nullptr;
    bool bare_ = false;  // Panels, menu and status line are hidden.
    std::size_t chosen_ = hallIndex;
};

}  // namespace vitrine::ui

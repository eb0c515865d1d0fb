#pragma once

#include "render/plan/complaints.h"
#include "ui/viewport/gallery.h"
#include "ui/window/message_strip.h"
#include "ui/window/undo.h"

#include <QMainWindow>
#include <QPixmap>
#include <QPointer>

class QMessageBox;
class QTabBar;

namespace vitrine::ui {

class ExhibitList;
class LedgerDock;
class LogView;
class ParameterPanel;
class PresetList;
class PresetShelf;
class SessionKeeper;
class StatusLine;
class StudyDock;
class Viewport;
struct WindowActions;

/// The workbench: the picture in the middle, everything else around it.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    /// The gallery must outlive it.
    explicit MainWindow(Gallery&, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// As `MessageStrip::say`.
    void say(MessageStrip::Mood, const QString& text, const QString& several = {}, const QString& what = {});
    /// Shows this exhibit's parameters and presets; 0 is the hall.
    void choose(std::size_t exhibit);
    /// Whose parameters the panel shows: the chosen exhibit, or the hall beside it.
    [[nodiscard]] std::size_t shown() const;
    /// ... and goes there.
    void visit(std::size_t exhibit);
    /// A picture, preset, model or panorama: what a drop on the window does.
    void openFile(const QString& path);
    /// What it reads: "*.json", "*.glb", ...
    [[nodiscard]] static QStringList openable();

    /// Nothing but the picture is shown.
    [[nodiscard]] bool bare() const { return bare_; }
    [[nodiscard]] std::size_t chosen() const { return chosen_; }
    [[nodiscard]] Gallery& gallery() const { return gallery_; }
    [[nodiscard]] History& history() { return history_; }
    [[nodiscard]] Viewport& viewport() const { return *viewport_; }
    [[nodiscard]] ParameterPanel& panel() const { return *panel_; }
    [[nodiscard]] StudyDock& study() const { return *study_; }
    [[nodiscard]] PresetShelf& shelf() const { return *shelf_; }

    /// Of a first window on a screen with this much room, its frame left out: as large as is useful, never larger.
    [[nodiscard]] static QSize firstSize(const QSize& room);
    /// Cut to the shape of the lists' pictures.
    [[nodiscard]] static QPixmap thumbnailOf(const QImage&);

    // What the actions do.
    void hidePanels(bool hidden);
    void findParameter();
    void openAbout();
    [[nodiscard]] const QList<QDockWidget*>& docks() const { return docks_; }
    void setFullScreen(bool);
    void saveScreenshotNow();
    void openScreenshotDialog();
    void openPrintDialog(const QString& print = {});
    void resetEverything();
    void openPalette();
    void openShortcutSheet();

protected:
    void closeEvent(QCloseEvent*) override;
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    void buildDocks();
    void connectParts();
    void showValues();
    void showTitle();
    /// What of the other tab matches the filter.
    void searchElsewhere();
    void keepThumbnail();
    void setHallFile(const char* parameter, const QString& path);
    void openPicture(const QString& path);
    void askBeforeClosing();
    void closeWhenDone();
    void closeIfDone();

    Gallery& gallery_;
    History history_;
    Viewport* viewport_;
    MessageStrip* messages_;
    StatusLine* status_;
    QTabBar* tabs_ = nullptr;
    ParameterPanel* panel_ = nullptr;
    ExhibitList* exhibits_ = nullptr;
    PresetList* presets_ = nullptr;
    PresetShelf* shelf_ = nullptr;
    SessionKeeper* keeper_ = nullptr;
    LedgerDock* ledger_ = nullptr;
    LogView* log_ = nullptr;
    StudyDock* study_ = nullptr;
    render::Complaints complaints_;  // What the log has been told of.
    std::unique_ptr<WindowActions> actions_;
    QList<QDockWidget*> docks_, hiddenDocks_;
    bool bare_ = false;          // Panels, menu and status line are hidden.
    bool closeAnyway_ = false;   // The visitor gave up what is being written.
    QPointer<QMessageBox> closing_;
    std::size_t chosen_ = 0;
};

}  // namespace vitrine::ui

#include "ui/window/main_window.h"

#include "render/files/assets.h"
#include "ui/charts/charts_dock.h"
#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_desk.h"
#include "ui/explore/explore_dock.h"
#include "ui/gamepad/gamepad_control.h"
#include "ui/jobs/job_dialog.h"
#include "ui/kit/context_key.h"
#include "ui/kit/focus_ring.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/language.h"
#include "ui/kit/picture_file.h"
#include "ui/kit/tab_order.h"
#include "ui/kit/text.h"
#include "ui/kit/tile_delegate.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/lessons/lesson_desk.h"
#include "ui/lessons/page_dialog.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/preset_shelf.h"
#include "ui/print/print_dialog.h"
#include "ui/print/shown_views.h"
#include "ui/record/bookmarks.h"
#include "ui/record/record_dialog.h"
#include "ui/study/study_dock.h"
#include "ui/study/table_export.h"
#include "ui/tree/tree_file.h"
#include "ui/viewport/row_drag.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"
#include "ui/window/clock_bar.h"
#include "ui/window/close_guard.h"
#include "ui/window/command_palette.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/export_again.h"
#include "ui/window/file_opener.h"
#include "ui/window/heap_trimmer.h"
#include "ui/window/ledger_dock.h"
#include "ui/window/log_view.h"
#include "ui/window/palette_entries.h"
#include "ui/window/parameter_tabs.h"
#include "ui/window/picture_export.h"
#include "ui/window/recent_files.h"
#include "ui/window/screenshot_dialog.h"
#include "ui/window/session_keeper.h"
#include "ui/window/status_line.h"
#include "ui/window/table_reader.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_preferences.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QUrl>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

QString thumbnailPath(const Subject& subject)
{
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    return cache + QStringLiteral("/vitrine/thumbnails/") + text(subject.name()) + QStringLiteral(".png");
}

}  // namespace

MainWindow::MainWindow(const Museum& museum, Renderers& renderers, QWidget* parent)
    : QMainWindow(parent), museum_(museum), renderers_(renderers), history_(museum.initialSceneState()),
      preferences_(new WindowPreferences(*this))
{
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    resize(firstSize(screen()->availableSize()));
    new IdleUndo(this);
    new ContextKey(this);
    new TabOrder(this);
    new FocusRing(this);
    buildMiddle();
    docks_ = new WindowDocks(*this, *this);
    shelf_ = new PresetShelf(*this, docks_->presets(), PresetStore::standard(render::asset("presets")));
    docks_->addExplore(*shelf_);
    files_ = new FileOpener(*this, *shelf_, this);
    guard_ = new CloseGuard(*this);
    again_ = new ExportAgain(*this, *this);
    new RowDrag(
        museum_, history_, *viewport_, [this] { return chosen_; }, this);
    // After all others that take the picture's events: side by side, they get them as of the whole picture.
    comparison_ = new CompareDesk(*this, *shelf_, this);
    centralWidget()->layout()->addWidget(&comparison_->bar());
    bookmarks_ = new Bookmarks(*this, this);
    addLessons();
    actions_ = std::make_unique<WindowActions>(*this);
    statusBar()->addPermanentWidget(new ClockBar(*viewport_, *actions_->pause));
    docks_->presets().setActions(actions_->savePreset, actions_->savePresetAs, actions_->presetMenu);
    connectParts();
    connectViewport();
    addGamepad();
    new TableReader(*this, this);
    showShippedThumbnails();
    choose(hallIndex);
    keeper_ = new SessionKeeper(*this);
    if (!keeper_->restore()) viewport_->showHint(tr("W A S D to walk, click an exhibit to tune it"));
    keeper_->watch();
    preferences_->follow(*actions_);
    viewport_->setFocus();
}

void MainWindow::buildMiddle()
{
    auto* middle = new QWidget;
    auto* layout = new QVBoxLayout(middle);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    messages_ = new MessageStrip;
    viewport_ = new Viewport(museum_, renderers_, history_);
    layout->addWidget(viewport_, 1);
    messages_->lieOver(viewport_);
    setCentralWidget(middle);

    status_ = new StatusLine;
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(status_, 1);
}

void MainWindow::showShippedThumbnails()
{
    for (std::size_t i = 0; i < museum_.subjects().size(); ++i) {
        // The shipped one shows the exhibit's best view; one kept from the screen serves those that ship none.
        const std::string shipped = "thumbnails/" + std::string(museum_.subject(i).name()) + ".png";
        QPixmap kept(QString::fromStdString(render::asset(shipped).string()));
        if (kept.isNull()) kept.load(thumbnailPath(museum_.subject(i)));
        if (!kept.isNull()) docks_->exhibits().setThumbnail(i, kept);
    }
}

void MainWindow::addLessons()
{
    lessons_ = new LessonDesk(*this, this);
    static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, &lessons_->bar());
    connect(lessons_, &LessonDesk::rowAsked, this, &MainWindow::showRow);
    connect(lessons_, &LessonDesk::syllabusAsked, this, [this] { openPage(QStringLiteral("syllabus")); });
    connect(lessons_, &LessonDesk::opened, this, &addRecentFile);
    connect(files_, &FileOpener::lessonFound, lessons_, &LessonDesk::open);
}

void MainWindow::addGamepad()
{
    gamepad_ = new GamepadControl(*viewport_, this);
    connect(gamepad_, &GamepadControl::failed, this,
            [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    connect(gamepad_, &GamepadControl::pauseAsked, this, [this] { actions_->pause->trigger(); });
    connect(gamepad_, &GamepadControl::exhibitAsked, this, [this](int step) {
        const auto count = static_cast<int>(museum_.subjects().size());
        visit(static_cast<std::size_t>((static_cast<int>(chosen_) + step + count) % count));
    });
    connect(gamepad_, &GamepadControl::rowAsked, this, [this](int step) {
        hidePanels(false);
        docks_->showParameters();
        panel().stepRow(step);
    });
    connect(gamepad_, &GamepadControl::changeAsked, this, [this](int step, bool again) { panel().nudge(step, again); });
}

MainWindow::~MainWindow()
{
    // Pictures in the making end while the viewport, its render thread and the message strip are still there.
    qDeleteAll(findChildren<PreferencesDialog*>());
    qDeleteAll(findChildren<PrintDialog*>());
    qDeleteAll(findChildren<JobDialog*>());
    qDeleteAll(findChildren<RecordDialog*>());
    qDeleteAll(findChildren<TableExport*>());
    qDeleteAll(findChildren<PictureExport*>());
    study().stop();
}

void MainWindow::connectParts()
{
    connect(&docks_->parameters(), &ParameterTabs::turned, shelf_, &PresetShelf::refresh);
    connect(&panel(), &ParameterPanel::filterLeft, viewport_, [this] { viewport_->setFocus(); });
    connect(shelf_, &PresetShelf::marked, this, &MainWindow::showTitle);
    connect(files_, &FileOpener::documentOpened, this, &MainWindow::visit);
    connect(&docks_->treeFile(), &TreeFile::saved, this, &addRecentFile);
    guard_->setUnsaved([this] { return docks_->treeFile().unsaved(); }, [this] { return docks_->treeFile().save(); });
    connect(files_, &FileOpener::printFound, this, &MainWindow::openPrintDialog);
    connect(&docks_->exhibits(), &ExhibitList::chosen, this, &MainWindow::visit);
    connect(&study(), &StudyDock::failed, this,
            [this](const QString& why) { setProblems(QStringLiteral("study"), {why}); });
    connect(&study(), &StudyDock::finished, this, [this] { setProblems(QStringLiteral("study"), {}); });
    panel().setOther(&comparison_->other());
    connect(comparison_, &CompareDesk::ledgerChanged, &docks_->ledger(), &LedgerDock::noteOther);
    connect(messages_, &MessageStrip::said, &docks_->log(), &LogView::add);
}

void MainWindow::connectViewport()
{
    connect(viewport_, &Viewport::visited, this, &MainWindow::choose);
    connect(viewport_, &Viewport::pressed, this, [this](std::size_t exhibit) {
        SceneState next = history_.sceneState();
        const Subject& subject = museum_.subject(exhibit);
        if (const auto* button = capability<HasButton>(subject); button && button->press(next.values[exhibit]))
            history_.change(tr("Press the button of %1").arg(said(subject.title())), next);
    });
    connect(viewport_, &Viewport::failed, this,
            [this](const QString& message) { setProblems(QStringLiteral("drawing"), {message}); });
    connect(&viewport_->renderThread(), &RenderThread::failed, this,
            [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    connect(viewport_, &Viewport::drawn, this, [this](const render::FrameReport& report, const QSize& pixels) {
        setProblems(QStringLiteral("drawing"), {});
        noteFrame(report, pixels);
    });
    new HeapTrimmer(*viewport_, this);
}

void MainWindow::noteFrame(const render::FrameReport& report, const QSize& pixels)
{
    status_->note(report, pixels, viewport_->reason());
    docks_->ledger().note(report);
    panel().showMoment(museum_.motionMoment(history_.sceneState(), shown(), viewport_->shownRequest()));
    showComplaints(report.skipped);
    keepThumbnail();
}

void MainWindow::showComplaints(const std::vector<render::CulledPass>& skipped)
{
    for (const render::CulledPass& complaint : complaints_.begun(skipped))
        if (complaint.unreadable.empty()) docks_->log().add(said(lineOf(complaint)));
    QStringList unreadable;  // What the strip lists goes into the log, too.
    for (const render::CulledPass& complaint : skipped)
        if (complaint.complaint && !complaint.unreadable.empty()) unreadable << said(lineOf(complaint));
    setProblems(QStringLiteral("files that are drawn"), unreadable);
}

void MainWindow::say(MessageStrip::Mood mood, const QString& words, const QString& several, const QString& what,
                     const QString& file)
{
    messages_->say(mood, words, several, what, file);
}

void MainWindow::setProblems(const QString& cause, const QStringList& texts)
{
    messages_->setProblems(cause, texts);
}

void MainWindow::choose(std::size_t exhibit)
{
    if (chosen_ != exhibit) panel().clearFilter();
    chosen_ = exhibit;
    docks_->exhibits().choose(exhibit);
    viewport_->setSubject(exhibit);
    docks_->parameters().choose(exhibit);
    study().setSubject(exhibit);
    docks_->charts().setSubject(exhibit);
    docks_->setTreeSubject(exhibit);
    comparison_->actions().refreshOffers();
    shelf_->refresh();
    docks_->explore().follow();
    if (keeper_) keeper_->noteLayout();
}

void MainWindow::visit(std::size_t exhibit)
{
    choose(exhibit);
    viewport_->visit(exhibit);
    viewport_->setFocus();
}

std::size_t MainWindow::shown() const
{
    return docks_->parameters().shown();
}

ParameterPanel& MainWindow::panel() const
{
    return docks_->parameters().panel();
}

StudyDock& MainWindow::study() const
{
    return docks_->study();
}

QSize MainWindow::firstSize(const QSize& room)
{
    // Title bar and borders, as large as desktops draw them.
    return QSize(1400, 860).boundedTo(room - QSize(16, 48));
}

void MainWindow::showTitle()
{
    const QString use = shelf_->titleOfUse();
    QStringList parts{said(museum_.subject(shown()).title())};
    if (!use.isEmpty()) parts << use;
    setWindowTitle(tr("%1 — Vitrine").arg(parts.join(QStringLiteral(": "))));
}

void MainWindow::resetEverything()
{
    const Subject& subject = museum_.subject(shown());
    SceneState next = history_.sceneState();
    next.values[shown()] = subject.parameters().initial();
    history_.change(tr("Reset %1").arg(said(subject.title())), next);
}

void MainWindow::keepThumbnail()
{
    if (!viewport_->schedule().still()) return;
    QMetaObject::invokeMethod(shelf_, &PresetShelf::keepMissingThumbnail, Qt::QueuedConnection);
    if (docks_->exhibits().hasThumbnail(chosen_)) return;
    const auto posed = chosen_ == hallIndex ? CameraControl::Mode::walk : CameraControl::Mode::orbit;
    if (viewport_->mode() != posed) return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            const QImage& picture = viewport_->shown();
            if (picture.isNull()) return;
            const QPixmap small = thumbnailOf(picture);
            docks_->exhibits().setThumbnail(chosen_, small);
            saveThumbnail(thumbnailPath(museum_.subject(chosen_)), small.toImage());
        },
        Qt::QueuedConnection);
}

void MainWindow::hidePanels(bool hidden)
{
    if (hidden == bare_) return;
    if (hidden && keeper_) keeper_->saveLayout();  // What comes back next time is what was there before.
    bare_ = hidden;
    if (hidden)
        docks_->hideAll();
    else
        docks_->showAgain();
    menuBar()->setVisible(!hidden);
    statusBar()->setVisible(!hidden);
    messages_->setBanned(hidden);
    comparison_->bar().setBanned(hidden);
    lessons_->bar().setBanned(hidden);
    if (actions_) actions_->panels->setChecked(hidden);
    viewport_->setFocus();
}

void MainWindow::findParameter()
{
    hidePanels(false);
    docks_->showParameters();
    panel().focusFilter();
}

void MainWindow::showRow(const QString& name)
{
    if (!lessons_->lesson()) return;
    const bool ofHall = name.startsWith(QLatin1String("hall."));
    const std::size_t subject = ofHall ? hallIndex : *museum_.find(lessons_->lesson()->exhibit);
    const ParameterValues& values = history_.sceneState().values[subject];
    const auto row = values.table().find((ofHall ? name.mid(5) : name).toStdString());
    if (!row) return;
    if (!ofHall) choose(subject);
    findParameter();
    panel().find(said(label(values.rows()[*row])));
}

void MainWindow::setFullScreen(bool on)
{
    setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() != QEvent::StatusTip) return QMainWindow::event(event);
    // In place of the first words of the status line only: its numbers stay.
    status_->showHelp(static_cast<QStatusTipEvent*>(event)->tip());
    return true;
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!guard_->mayClose()) {
        event->ignore();
        return;
    }
    lessons_->leave();  // What comes back next time is what was open before.
    keeper_->close();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) files_->open(url.toLocalFile());
    event->acceptProposedAction();
}

void MainWindow::openScreenshotDialog()
{
    auto* dialog = new ScreenshotDialog(*this, this);
    connect(dialog, &ScreenshotDialog::begun, again_, &ExportAgain::note);
    dialog->show();
}

void MainWindow::openPrintDialog(const QString& print)
{
    auto* dialog = findChild<PrintDialog*>();
    if (!dialog) dialog = new PrintDialog(new ShownViews(*this, this), this);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
    if (!print.isEmpty()) dialog->open({print});
}

void MainWindow::openJobDialog(const jobs::Job& job)
{
    const std::optional<std::size_t> subject = museum_.find(job.needs().subject);
    if (!subject) return;  // Its action is not enabled then.
    JobDialog* dialog = nullptr;
    for (JobDialog* open : findChildren<JobDialog*>())
        if (&open->job() == &job) dialog = open;
    if (!dialog)
        dialog = new JobDialog(job, {&museum_, history_.sceneState(), *subject, {}}, renderers_,
                               viewport_->renderThread(), this);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void MainWindow::openRecordDialog()
{
    auto* dialog = findChild<RecordDialog*>();
    if (!dialog) dialog = new RecordDialog(*this, *bookmarks_, this);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void MainWindow::saveTour()
{
    auto* dialog = new QFileDialog(this, tr("Save as a tour"), QStringLiteral("tour.json"), tr("Tours (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    connect(dialog, &QFileDialog::fileSelected, bookmarks_, &Bookmarks::saveAs);
    dialog->open();
}

void MainWindow::openPalette()
{
    auto* owner = new QObject(this);
    auto* palette = new CommandPalette(paletteEntries(*this, actions_->all, *owner), this);
    connect(palette, &QObject::destroyed, owner, &QObject::deleteLater);
    palette->show();
}

void MainWindow::openAbout()
{
    (new AboutDialog(this))->show();
}

void MainWindow::openShortcutSheet()
{
    (new ShortcutSheet(actions_->all, this))->show();
}

void MainWindow::openPage(std::size_t subject)
{
    openPage(text(museum_.subject(subject).name()));
}

void MainWindow::openPage(const QString& page)
{
    auto* dialog = findChild<PageDialog*>();
    if (!dialog) {
        dialog = new PageDialog(this, [this](const QString& name) -> const Parameters* {
            const auto found = museum_.find(name.toStdString());
            return found ? &history_.sceneState().values[*found].table() : nullptr;
        });
        connect(dialog, &PageDialog::lessonAsked, this, [this](const QString& exhibit) {
            if (const auto found = museum_.find(exhibit.toStdString())) lessons_->start(*found);
        });
    }
    dialog->showPage(page);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

}  // namespace vitrine::ui

#include "moc_main_window.cpp"

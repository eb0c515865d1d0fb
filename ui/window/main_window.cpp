#include "ui/window/main_window.h"

#include "ui/window/job_scene.h"

#include "exhibits/framework/files/lesson.h"
#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/takes_input.h"
#include "render/files/assets.h"
#include "ui/charts/charts_dock.h"
#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_controller.h"
#include "ui/controllers/controllers.h"
#include "ui/editor/document_file.h"
#include "ui/explore/explore_dock.h"
#include "ui/gamepad/gamepad_control.h"
#include "ui/jobs/export_again.h"
#include "ui/kit/context_key.h"
#include "ui/kit/focus_ring.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/language.h"
#include "ui/kit/tab_order.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/parameters/parameter_menus.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/preset_list.h"
#include "ui/record/bookmarks.h"
#include "ui/report/frame_report_dock.h"
#include "ui/report/log_view.h"
#include "ui/study/study_dock.h"
#include "ui/viewport/crosshair.h"
#include "ui/viewport/parameter_drag.h"
#include "ui/viewport/picture_input.h"
#include "ui/viewport/pixel_inspector.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"
#include "ui/window/clock_bar.h"
#include "ui/window/close_guard.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/exhibit_thumbnails.h"
#include "ui/window/file_opener.h"
#include "ui/window/frame_reporter.h"
#include "ui/window/heap_trimmer.h"
#include "ui/window/parameter_tabs.h"
#include "ui/window/recent_files.h"
#include "ui/window/session_keeper.h"
#include "ui/window/status_line.h"
#include "ui/window/table_reader.h"
#include "ui/window/visit_card.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_preferences.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QUrl>
#include <QVBoxLayout>

#include <filesystem>
#include <system_error>

namespace vitrine::ui {

QSize firstWindowSize(const QSize& room)
{
    // Title bar and borders, as large as desktops draw them.
    return QSize(1400, 860).boundedTo(room - QSize(16, 48));
}

MainWindow::MainWindow(const Museum& museum, Renderers& renderers, const MakesCommands& makesCommands)
    : museum_(museum), renderers_(renderers), history_(museum.readTables(museum.initialSceneState()).sceneState),
      preferences_(new WindowPreferences(*this))
{
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    resize(firstWindowSize(screen()->availableSize()));
    new IdleUndo(this);
    new ContextKey(this);
    new TabOrder(this);
    new FocusRing(this);
    buildMiddle();
    docks_ = new WindowDocks(*this, *this);
    presetController_ = new PresetController(*this, docks_->presets(), PresetStore::standard(render::asset("presets")));
    docks_->addExplore(*presetController_);
    files_ = new FileOpener(*this, *presetController_, this);
    guard_ = new CloseGuard(*this);
    again_ = new ExportAgain(
        *this, [this](const jobs::Job& job) { return jobSceneOf(*this, comparison_->other(), job); }, *this);
    new ParameterDrag(
        museum_, history_, *viewport_, [this] { return chosen_; }, this);
    new PictureInput(
        museum_, history_, *viewport_, [this] { return chosen_; }, this);
    panel().menus().setPush([this](std::size_t row) -> std::optional<ParameterChanges> {
        const std::size_t exhibit = panel().exhibit();
        const auto* takes = capability<TakesInput>(museum_.subject(exhibit));
        if (!takes) return std::nullopt;
        return takes->pushed({history_.sceneState().values[exhibit], viewport_->clock().time()}, row);
    });
    new PixelInspector(museum_, history_, renderers, *viewport_, this);
    new Crosshair(*viewport_);
    // After all others that take the picture's events: side by side, they get them as of the whole picture.
    comparison_ = new CompareController(*this, *presetController_, this);
    centralWidget()->layout()->addWidget(&comparison_->bar());
    bookmarks_ = new Bookmarks(*this, this);
    addLessons();
    dialogs_ = new WindowDialogs(*this, *this, comparison_->other(), *bookmarks_, *lessons_, *again_);
    commands_ = makesCommands(*this);
    statusBar()->addPermanentWidget(new ClockBar(*viewport_, *commands_->pause));
    docks_->presets().setActions(commands_->savePreset, commands_->savePresetAs, commands_->presetMenu);
    connectParts();
    connectViewport();
    addGamepad();
    addControllers();
    new TableReader(*this, this);
    new ExhibitThumbnails(*this, docks_->exhibits(), this);
    visitCard_ = new VisitCard(*viewport_, history_, [this](std::size_t exhibit) { return visitOffers(exhibit); });
    choose(hallIndex);
    keeper_ = new SessionKeeper(*this);
    if (!keeper_->restore()) viewport_->notices().sayHint(tr("W A S D to walk, click an exhibit to tune it"));
    keeper_->watch();
    preferences_->follow(*commands_);
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

void MainWindow::addLessons()
{
    lessons_ = new LessonController(*this, this);
    static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, &lessons_->bar());
    connect(lessons_, &LessonController::parameterRequested, this, &MainWindow::showRow);
    connect(lessons_, &LessonController::syllabusAsked, this,
            [this] { dialogs_->openPage(QStringLiteral("syllabus")); });
    connect(lessons_, &LessonController::opened, this, &addRecentFile);
    connect(files_, &FileOpener::lessonFound, lessons_, &LessonController::open);
}

void MainWindow::addGamepad()
{
    auto* gamepad = new GamepadControl(*viewport_, this);
    connect(gamepad, &GamepadControl::failed, this,
            [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    connect(gamepad, &GamepadControl::pauseAsked, this, [this] { commands_->pause->trigger(); });
    connect(gamepad, &GamepadControl::exhibitAsked, this, [this](int step) {
        const auto count = static_cast<int>(museum_.subjects().size());
        visit(static_cast<std::size_t>((static_cast<int>(chosen_) + step + count) % count));
    });
    connect(gamepad, &GamepadControl::parameterRequested, this, [this](int step) {
        hidePanels(false);
        docks_->showParameters();
        panel().stepRow(step);
    });
    connect(gamepad, &GamepadControl::changeAsked, this, [this](int step, bool again) { panel().nudge(step, again); });
}

void MainWindow::addControllers()
{
    auto* controllers = new Controllers(museum_, history_, preferences_->values(), this);
    panel().menus().setControllers(controllers);
    connect(controllers, &Controllers::noteChanged, this, [this](const QString& key) { panel().showController(key); });
    connect(controllers, &Controllers::problemsChanged, this,
            [this](const QStringList& texts) { setProblems(QStringLiteral("controllers"), texts); });
    connect(controllers, &Controllers::nothingListens, this, [this] {
        say(MessageStrip::Mood::notice, tr("No controller is listened to. Set an OSC port or switch on MIDI in Edit > "
                                           "Preferences > Controllers, then choose “Learn controller” again."));
    });
    auto* line = new QLabel;
    line->setTextFormat(Qt::PlainText);
    line->setContentsMargins(4, 0, 8, 0);
    line->hide();
    statusBar()->addPermanentWidget(line);
    connect(controllers, &Controllers::listeningChanged, this, [controllers, line] {
        const QString text = controllers->listening().join(QStringLiteral(", "));
        line->setText(text);
        line->setVisible(!text.isEmpty());
        line->setAccessibleName(tr("Controllers: %1").arg(text));
        QStringList tip{tr("Controllers that can move parameters (Edit > Preferences > Controllers).")};
        tip << controllers->devices();
        line->setToolTip(tip.join(QLatin1Char('\n')));
    });
}

MainWindow::~MainWindow()
{
    // Exports end while the viewport, its render thread and the message strip are still there.
    dialogs_->closeAll();
    docks_->study().stop();
}

void MainWindow::connectParts()
{
    connect(&docks_->parameters(), &ParameterTabs::turned, presetController_, &PresetController::refresh);
    connect(presetController_, &PresetController::marked, this, &MainWindow::showTitle);
    connect(presetController_, &PresetController::visitAsked, this, [this](std::size_t exhibit) {
        // The hall has a tab beside each exhibit: its presets do not end a visit.
        if (exhibit != hallIndex || !docks_->parameters().turnTo(exhibit)) visit(exhibit);
    });
    connect(files_, &FileOpener::documentOpened, this, &MainWindow::visit);
    connect(&docks_->documentFile(), &DocumentFile::saved, this, &addRecentFile);
    guard_->setUnsaved([this] { return docks_->documentFile().unsaved(); },
                       [this] { return docks_->documentFile().save(); });
    connect(files_, &FileOpener::printFound, dialogs_, &WindowDialogs::openPrint);
    connect(&docks_->exhibits(), &ExhibitList::chosen, this, &MainWindow::visit);
    connect(&docks_->exhibits(), &ExhibitList::lessonAsked, lessons_, qOverload<std::size_t>(&LessonController::start));
    connect(&docks_->exhibits(), &ExhibitList::pageAsked, dialogs_, qOverload<std::size_t>(&WindowDialogs::openPage));
    connect(&docks_->study(), &StudyDock::failed, this,
            [this](const QString& why) { setProblems(QStringLiteral("study"), {why}); });
    connect(&docks_->study(), &StudyDock::finished, this, [this] { setProblems(QStringLiteral("study"), {}); });
    panel().menus().setOther(&comparison_->other());
    docks_->study().offerBoth(comparison_->other());
    connect(comparison_, &CompareController::reportChanged, &docks_->frameReport(), &FrameReportDock::noteOther);
    connect(messages_, &MessageStrip::said, &docks_->log(), &LogView::add);
}

void MainWindow::connectViewport()
{
    connect(&viewport_->visitor(), &Visitor::visited, this, &MainWindow::choose);
    connect(&viewport_->interaction(), &Interaction::pressed, this, [this](std::size_t exhibit) {
        SceneState next = history_.sceneState();
        const SceneObject& subject = museum_.subject(exhibit);
        if (const auto* button = capability<HasButton>(subject); button && button->press(next.values[exhibit]))
            history_.change(tr("Press the button of %1").arg(translatedText(subject.title())), next);
    });
    connect(&viewport_->renderThread(), &RenderThread::failed, this,
            [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    new FrameReporter(*this, *docks_, *status_, this);
    connect(&viewport_->pictures(), &ViewportPictures::drawn, this, [this](const render::FrameReport& report) {
        noteDrawn(museum_, report);
        if (viewport_->pictures().schedule().still())
            QMetaObject::invokeMethod(presetController_, &PresetController::keepMissingThumbnail, Qt::QueuedConnection);
    });
    new HeapTrimmer(*viewport_, renderers(), this);
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
    chosen_ = exhibit;
    docks_->exhibits().choose(exhibit);
    viewport_->visitor().setSubject(exhibit);
    docks_->parameters().choose(exhibit);
    docks_->study().setSubject(exhibit);
    docks_->charts().setSubject(exhibit);
    docks_->setDocumentSubject(exhibit);
    comparison_->actions().refreshOffers();
    presetController_->refresh();
    docks_->explore().follow();
    if (visitCard_) visitCard_->follow(exhibit, museum_.subject(exhibit));
    if (keeper_) keeper_->noteLayout();
}

std::vector<VisitOffer> MainWindow::visitOffers(std::size_t exhibit)
{
    if (exhibit == hallIndex || lessons_->lesson()) return {};
    std::vector<VisitOffer> offers;
    const QString title = translatedText(museum_.subject(exhibit).title());
    std::error_code ignored;
    if (std::filesystem::exists(shippedLesson(museum_.subject(exhibit).name()), ignored))
        offers.push_back(
            {tr("Lesson"), tr("Start the lesson on %1").arg(title), [this, exhibit] { lessons_->start(exhibit); }});
    if (QAction* offer = comparison_->actions().firstOffer())
        offers.push_back({tr("Compare"), offer->text().remove(QLatin1Char('&')), [offer] { offer->trigger(); }});
    offers.push_back(
        {tr("Variations"), tr("Show nine variations of the present settings"), [this] { docks_->showExplore(); }});
    offers.push_back({tr("About"), tr("About %1").arg(title), [this, exhibit] { dialogs_->openPage(exhibit); }});
    return offers;
}

void MainWindow::visit(std::size_t exhibit)
{
    choose(exhibit);
    viewport_->visitor().visit(exhibit);
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

void MainWindow::showTitle()
{
    const QString use = presetController_->titleOfUse();
    QStringList parts{translatedText(museum_.subject(shown()).title())};
    if (!use.isEmpty()) parts << use;
    setWindowTitle(tr("%1 — Vitrine").arg(parts.join(QStringLiteral(": "))));
}

void MainWindow::hidePanels(bool hidden)
{
    if (hidden == bare_) return;
    if (hidden && keeper_) keeper_->saveLayout();  // The next start restores the panels that are visible now.
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
    visitCard_->setBanned(hidden);
    if (commands_) commands_->panels->setChecked(hidden);
    viewport_->setFocus();
}

void MainWindow::showParameter(std::size_t subject, std::string_view name)
{
    hidePanels(false);
    if (!docks_->parameters().turnTo(subject)) visit(subject);
    docks_->showParameters();
    panel().reveal(name);
}

void MainWindow::showRow(const QString& name)
{
    if (!lessons_->lesson()) return;
    const bool ofHall = name.startsWith(QLatin1String("hall."));
    const std::size_t subject = ofHall ? hallIndex : *museum_.find(lessons_->lesson()->exhibit);
    if (!ofHall) choose(subject);
    showParameter(subject, (ofHall ? name.mid(5) : name).toStdString());
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
    lessons_->leave();  // The next start restores the state before the lesson.
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

}  // namespace vitrine::ui

#include "moc_main_window.cpp"

#include "ui/window/window_docks.h"

#include "ui/charts/charts_dock.h"
#include "ui/editor/document_file.h"
#include "ui/editor/shader_panel.h"
#include "ui/explore/explore_dock.h"
#include "ui/kit/language.h"
#include "ui/kit/tab_order.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/preset_list.h"
#include "ui/report/frame_report_dock.h"
#include "ui/report/frame_report_view.h"
#include "ui/report/log_view.h"
#include "ui/study/study_dock.h"
#include "ui/tree/tree_dock.h"
#include "ui/tree/tree_editor.h"
#include "ui/tree/tree_overlay.h"
#include "ui/viewport/renderers.h"
#include "ui/viewport/viewport.h"
#include "ui/window/dock_title.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/parameter_tabs.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {

WindowDocks::WindowDocks(QMainWindow& window, Workbench& workbench)
    : QObject(&window), window_(window), workbench_(workbench)
{
    window_.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
    window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    addLists();
    parameters_ = new ParameterTabs(workbench_.museum().subjects(), workbench_.history());
    parametersDock_ = add(tr("Parameters"), "parameters", parameters_, Qt::RightDockWidgetArea);
    addTree();
    addStudy();
    addFrameReportAndLog();
    window_.resizeDocks({docks_[0], docks_[1]}, {400, 300}, Qt::Vertical);
    // Wide enough for the longest label, up to 30 % of the window, or 42 % with a large font.
    const int most = window_.width() * std::clamp(3 * grown(10, window_), 30, 42) / 100;
    const int labels = std::clamp(parameters_->widthForLabels(), 360, std::max(360, most));
    window_.resizeDocks({docks_[0], parametersDock_}, {widthOfLists(), labels}, Qt::Horizontal);
    ui::followType(window_, [this] { followType(); });
}

int WindowDocks::widthOfLists() const
{
    return std::clamp(grown(240, window_), 240, std::max(240, window_.width() * 26 / 100));
}

void WindowDocks::followType()
{
    // A larger font makes docks wider. They would keep that width when the font becomes smaller again.
    const int before = std::exchange(typeHeight_, window_.fontMetrics().height());
    if (before > 0 && before < typeHeight_)
        QTimer::singleShot(0, this, [this] {
            if (docks_[0]->width() < widthOfLists()) window_.resizeDocks({docks_[0]}, {widthOfLists()}, Qt::Horizontal);
        });
    if (before <= typeHeight_) return;
    QTimer::singleShot(0, this, [this, part = static_cast<double>(typeHeight_) / before] {
        QList<QDockWidget*> besides;
        QList<int> widths;
        for (QDockWidget* dock : docks_) {
            const Qt::DockWidgetArea area = window_.dockWidgetArea(dock);
            if (area != Qt::LeftDockWidgetArea && area != Qt::RightDockWidgetArea) continue;
            besides << dock;
            widths << static_cast<int>(std::lround(dock->width() * part));
        }
        window_.resizeDocks(besides, widths, Qt::Horizontal);
    });
}

QTabWidget* WindowDocks::tabs(std::initializer_list<std::pair<QString, QWidget*>> pages)
{
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    tabs->tabBar()->setDrawBase(false);
    QStringList titles;
    for (const auto& [title, page] : pages) {
        tabs->addTab(page, title);
        titles << title;
    }
    tabs->setAccessibleName(titles.join(QStringLiteral(", ")));
    return tabs;
}

QDockWidget* WindowDocks::add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, &window_);
    dock->setObjectName(QLatin1String(name));
    dock->setAccessibleName(title);
    dock->setTitleBarWidget(new DockTitle(dock));  // Set first, so that Tab goes on from it into the dock.
    dock->setWidget(content);
    tabAsLaidOut(*content);
    window_.addDockWidget(area, dock);
    docks_ << dock;
    connect(dock, &QDockWidget::visibilityChanged, this, &WindowDocks::nameStacks);
    return dock;
}

void WindowDocks::addLists()
{
    exhibits_ = new ExhibitList;
    presets_ = new PresetList;
    add(tr("Exhibits"), "exhibits", exhibits_, Qt::LeftDockWidgetArea);
    add(tr("Presets"), "presets", presets_, Qt::LeftDockWidgetArea);
    exhibits_->fill(workbench_.museum());
}

void WindowDocks::addTree()
{
    auto* editor = new TreeEditor(workbench_, this);
    documentFile_ = new DocumentFile(workbench_, this);
    tree_ =
        new TreeDock(*editor, *new TreeOverlay(workbench_.museum(), *editor, workbench_.viewport()), *documentFile_);
    treeDock_ = add(tr("Tree"), "tree", tree_, Qt::RightDockWidgetArea);
    window_.tabifyDockWidget(parametersDock_, treeDock_);
    treeDock_->hide();
    connect(treeDock_->toggleViewAction(), &QAction::triggered, this, [this](bool on) { treeWanted_ = on; });
    connect(editor, &TreeEditor::shown, this, [this] {
        treeDock_->show();
        treeDock_->raise();
    });
    // A restored layout may show the dock although there is no tree.
    connect(treeDock_, &QDockWidget::visibilityChanged, this, [this, editor](bool visible) {
        if (visible && !editor->source()) treeDock_->hide();
    });
}

void WindowDocks::setDocumentSubject(std::size_t exhibit)
{
    documentFile_->setSubject(exhibit);
    shader_->setSubject(exhibit);
    tree_->editor().setSubject(exhibit);
    const bool some = tree_->editor().source() != nullptr;
    treeDock_->toggleViewAction()->setEnabled(some);
    const bool comes = some && treeDock_->isHidden();
    if (hidden_.isEmpty()) treeDock_->setVisible(some && treeWanted_);
    if (comes) parametersDock_->raise();
}

void WindowDocks::addStudy()
{
    study_ = new StudyDock(workbench_.museum(), workbench_.renderers(), workbench_.history(),
                           workbench_.viewport().renderThread());
    auto* room = new QScrollArea;  // A small window need not grow for the chart.
    room->setWidget(study_);
    room->setWidgetResizable(true);
    room->setFrameShape(QFrame::NoFrame);
    charts_ = new ChartsDock(workbench_.museum(), workbench_.history());
    studyTabs_ = tabs({{tr("Accuracy and cost"), room}, {tr("Charts"), charts_}});
    studyDock_ = add(tr("Study"), "study", studyTabs_, Qt::BottomDockWidgetArea);
    studyDock_->hide();
    ParameterPanel& panel = parameters_->panel();
    connect(&panel, &ParameterPanel::accuracyAsked, this,
            [this](std::size_t row) { measureAccuracy(parameters_->shown(), row); });
    connect(study_, &StudyDock::saved, this, [this](const QString& file) {
        workbench_.say(MessageStrip::Mood::notice, tr("Saved %1.").arg(file), {}, {}, file);
    });
    panel.setGaugesShown(true);
}

void WindowDocks::measureAccuracy(std::size_t exhibit, std::size_t row)
{
    showStudy();
    study_->ask(exhibit, row);
}

void WindowDocks::measureIntoFigure(std::size_t exhibit, std::size_t row)
{
    showStudy();
    study_->ask(exhibit, row, StudyDock::Then::saveFigure);
}

void WindowDocks::addFrameReportAndLog()
{
    Viewport& viewport = workbench_.viewport();
    frameReport_ = new FrameReportDock([&viewport] { return viewport.pictures().reason(); });
    QHash<QString, QString> titles;
    for (const auto& exhibit : workbench_.museum().subjects())
        titles.insert(text(exhibit->name()), translatedText(exhibit->title()));
    frameReport_->view().setTitles(titles);
    connect(frameReport_, &FrameReportDock::runEverythingAsked, &viewport.scene(), &PresentScene::setRunEverything);
    log_ = new LogView;
    shader_ = new ShaderPanel(workbench_, *documentFile_);
    reportTabs_ = tabs({{tr("Passes"), frameReport_}, {tr("Log"), log_}, {tr("Shader"), shader_}});
    reportDock_ = add(tr("Frame report"), "frame-report", reportTabs_, Qt::BottomDockWidgetArea);
    window_.tabifyDockWidget(studyDock_, reportDock_);
    reportDock_->hide();
    // Passes are timed only while their list is visible, because that is slower.
    const auto time = [this, &viewport] {
        const bool on = reportDock_->isVisible() && reportTabs_->currentWidget() == frameReport_;
        viewport.renderThread().post([&renderers = workbench_.renderers(), on] {
            renderers.timeSteps(on);
            return std::function<void()>();
        });
    };
    connect(reportDock_, &QDockWidget::visibilityChanged, this, time);
    connect(reportTabs_, &QTabWidget::currentChanged, this, time);
}

void WindowDocks::addExplore(PresetController& presetController)
{
    explore_ = new ExploreDock(workbench_, presetController, parameters_->panel());
    auto* room = new QScrollArea;  // A small window need not grow for it.
    room->setWidget(explore_);
    room->setWidgetResizable(true);
    room->setFrameShape(QFrame::NoFrame);
    room->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    exploreDock_ = add(tr("Explore"), "explore", room, Qt::RightDockWidgetArea);
    window_.tabifyDockWidget(parametersDock_, exploreDock_);
    exploreDock_->hide();
    exploreDock_->toggleViewAction()->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_X));
    connect(exploreDock_->toggleViewAction(), &QAction::triggered, exploreDock_, [this](bool on) {
        if (on) exploreDock_->raise();
    });
    connect(parameters_, &ParameterTabs::turned, explore_, &ExploreDock::follow);
}

void WindowDocks::showExplore()
{
    exploreDock_->show();
    exploreDock_->raise();
}

void WindowDocks::nameStacks()
{
    // Qt makes the tab bars of stacked docks when needed.
    for (QTabBar* bar : window_.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        bar->setAccessibleName(tr("Stacked panels"));
        bar->setFocusPolicy(bar->count() > 1 ? Qt::TabFocus : Qt::NoFocus);  // Qt lets empty ones take the focus, too.
    }
}

void WindowDocks::hideAll()
{
    for (QDockWidget* dock : docks_)
        if (!dock->isHidden()) hidden_ << dock;
    for (QDockWidget* dock : hidden_) dock->hide();
}

void WindowDocks::showAgain()
{
    for (QDockWidget* dock : hidden_) dock->show();
    hidden_.clear();
}

void WindowDocks::showParameters()
{
    parametersDock_->show();
    parametersDock_->raise();
}

void WindowDocks::showStudy()
{
    studyTabs_->setCurrentIndex(0);
    studyDock_->show();
    studyDock_->raise();
    // High enough for the chart with its axes, but not above half of the window.
    if (studyDock_->height() < 300)
        window_.resizeDocks({studyDock_}, {std::clamp(window_.height() * 45 / 100, 320, 420)}, Qt::Vertical);
}

void WindowDocks::showCharts()
{
    showStudy();
    studyTabs_->setCurrentWidget(charts_);
}

void WindowDocks::showShader()
{
    reportTabs_->setCurrentWidget(shader_);
    reportDock_->show();
    reportDock_->raise();
    if (reportDock_->height() < 260)
        window_.resizeDocks({reportDock_}, {std::clamp(window_.height() * 40 / 100, 260, 420)}, Qt::Vertical);
}

void WindowDocks::showLog()
{
    reportTabs_->setCurrentWidget(log_);
    reportDock_->show();
    reportDock_->raise();
}

}  // namespace vitrine::ui

#include "moc_window_docks.cpp"

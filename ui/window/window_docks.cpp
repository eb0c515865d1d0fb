// The docks around the picture: what is in them and where they start.
#include "ui/window/main_window.h"

#include "render/files/assets.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/preset_shelf.h"
#include "ui/study/study_dock.h"
#include "ui/viewport/viewport.h"
#include "ui/window/dock_title.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/ledger_dock.h"
#include "ui/window/ledger_view.h"
#include "ui/window/log_view.h"
#include "ui/window/session_keeper.h"
#include "ui/window/status_line.h"
#include "ui/window/window_actions.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QStatusBar>
#include <QTabBar>
#include <QVBoxLayout>

namespace vitrine::ui {

void MainWindow::buildDocks()
{
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    const auto dock = [this](const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
        auto* made = new QDockWidget(title, this);
        made->setObjectName(QLatin1String(name));
        made->setAccessibleName(title);
        made->setWidget(content);
        made->setTitleBarWidget(new DockTitle(made));
        addDockWidget(area, made);
        docks_ << made;
        return made;
    };

    exhibits_ = new ExhibitList;
    presets_ = new PresetList;
    QDockWidget* exhibits = dock(tr("Exhibits"), "exhibits", exhibits_, Qt::LeftDockWidgetArea);
    QDockWidget* presets = dock(tr("Presets"), "presets", presets_, Qt::LeftDockWidgetArea);
    exhibits_->fill(gallery_.exhibits(), gallery_.emptyPlaces());
    shelf_ = new PresetShelf(*this, *presets_, PresetStore::standard(render::asset("presets")));

    auto* right = new QWidget;
    auto* rightLayout = new QVBoxLayout(right);
    rightLayout->setContentsMargins(0, 0, 0, 0);
    rightLayout->setSpacing(0);
    tabs_ = new QTabBar;
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setAccessibleName(tr("Whose parameters"));
    panel_ = new ParameterPanel;
    rightLayout->addWidget(tabs_);
    rightLayout->addWidget(panel_, 1);
    dock(tr("Parameters"), "parameters", right, Qt::RightDockWidgetArea);

    study_ = new StudyDock(gallery_, history_, viewport_->renderThread());
    auto* studyRoom = new QScrollArea;  // So that a small window need not grow for the chart.
    studyRoom->setWidget(study_);
    studyRoom->setWidgetResizable(true);
    studyRoom->setFrameShape(QFrame::NoFrame);
    QDockWidget* study = dock(tr("Study"), "study", studyRoom, Qt::BottomDockWidgetArea);
    ledger_ = new LedgerDock([this] { return viewport_->reason(); });
    QHash<QString, QString> titles;
    for (const auto& exhibit : gallery_.exhibits())
        titles.insert(QString::fromUtf8(exhibit->name().data(), static_cast<qsizetype>(exhibit->name().size())), QString::fromUtf8(exhibit->title().data(), static_cast<qsizetype>(exhibit->title().size())));
    ledger_->view().setTitles(titles);
    connect(ledger_, &LedgerDock::runEverythingAsked, viewport_, &Viewport::setRunEverything);
    log_ = new LogView;
    QDockWidget* ledger = dock(tr("Ledger"), "ledger", ledger_, Qt::BottomDockWidgetArea);
    QDockWidget* log = dock(tr("Log"), "log", log_, Qt::BottomDockWidgetArea);
    tabifyDockWidget(study, ledger);
    tabifyDockWidget(ledger, log);
    study->hide();
    ledger->hide();
    log->hide();
    // Steps are timed one by one, which costs time, only while someone looks.
    connect(ledger, &QDockWidget::visibilityChanged, viewport_, [this](bool visible) { viewport_->setStepsTimed(visible); });

    connect(panel_, &ParameterPanel::accuracyAsked, this, [this, study](std::size_t row) {
        study->show();
        study->raise();
        if (study->height() < 300) resizeDocks({study}, {320}, Qt::Vertical);
        study_->ask(shown(), row);
    });
    panel_->setGaugesShown(true);

    // The tab bars of stacked docks are Qt's own, made when needed.
    for (const QDockWidget* each : docks_)
        connect(each, &QDockWidget::visibilityChanged, this, [this] {
            for (QTabBar* bar : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
                bar->setAccessibleName(tr("Stacked panels"));
                bar->setFocusPolicy(bar->count() > 1 ? Qt::TabFocus : Qt::NoFocus);  // Qt gives it to empty ones, too.
            }
        });
    resizeDocks({exhibits, presets}, {400, 300}, Qt::Vertical);
    resizeDocks({exhibits, docks_[2]}, {240, 360}, Qt::Horizontal);
}

void MainWindow::hidePanels(bool hidden)
{
    if (hidden == bare_) return;
    if (hidden) {
        if (keeper_) keeper_->saveLayout();  // What comes back next time is what was there before.
        bare_ = true;
        for (QDockWidget* dock : docks_)
            if (dock->isVisible()) hiddenDocks_ << dock;
        for (QDockWidget* dock : hiddenDocks_) dock->hide();
    } else {
        for (QDockWidget* dock : hiddenDocks_) dock->show();
        hiddenDocks_.clear();
        bare_ = false;
    }
    menuBar()->setVisible(!hidden);
    statusBar()->setVisible(!hidden);
    messages_->setBanned(hidden);
    if (actions_) actions_->panels->setChecked(hidden);
    viewport_->setFocus();
}

void MainWindow::findParameter()
{
    hidePanels(false);
    QDockWidget* parameters = findChild<QDockWidget*>(QStringLiteral("parameters"));
    parameters->show();
    parameters->raise();  // In front, where it is stacked with others.
    panel_->focusFilter();
}

void MainWindow::setFullScreen(bool on)
{
    setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

}  // namespace vitrine::ui

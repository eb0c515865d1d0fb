#include "ui/window/main_window.h"

#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/preset_shelf.h"
#include "ui/print/print_dialog.h"
#include "ui/study/study_dock.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"
#include "ui/window/command_palette.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/idle_undo.h"
#include "ui/window/ledger_dock.h"
#include "ui/window/log_view.h"
#include "ui/window/picture_export.h"
#include "ui/window/session_keeper.h"
#include "ui/window/status_line.h"
#include "ui/window/window_actions.h"

#include "render/files/assets.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

QString text(std::string_view s)
{
    return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

QString thumbnailPath(const Exhibit& exhibit)
{
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    return cache + QStringLiteral("/vitrine/thumbnails/") + text(exhibit.name()) + QStringLiteral(".png");
}

}  // namespace

MainWindow::MainWindow(Gallery& gallery, QWidget* parent)
    : QMainWindow(parent), gallery_(gallery), history_(gallery.initialLook())
{
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    resize(firstSize(screen()->availableSize()));
    new IdleUndo(this);

    auto* middle = new QWidget;
    auto* layout = new QVBoxLayout(middle);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    messages_ = new MessageStrip;
    viewport_ = new Viewport(gallery_, history_);
    layout->addWidget(viewport_, 1);
    messages_->lieOver(viewport_);
    setCentralWidget(middle);

    status_ = new StatusLine;
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(status_, 1);

    buildDocks();
    actions_ = std::make_unique<WindowActions>(*this);
    presets_->setActions(actions_->savePreset, actions_->savePresetAs, actions_->presetMenu);
    connectParts();
    for (std::size_t i = 0; i < gallery_.exhibits().size(); ++i) {
        // The shipped one shows the exhibit's best view; one kept from the screen serves those that ship none.
        const std::string shipped = "thumbnails/" + std::string(gallery_.exhibits()[i]->name()) + ".png";
        QPixmap kept(QString::fromStdString(render::asset(shipped).string()));
        if (kept.isNull()) kept.load(thumbnailPath(*gallery_.exhibits()[i]));
        if (!kept.isNull()) exhibits_->setThumbnail(i, kept);
    }
    choose(0);
    keeper_ = new SessionKeeper(*this);
    if (!keeper_->restore()) viewport_->showHint(tr("W A S D to walk, click an exhibit to tune it"));
    connect(&history_, &History::changed, keeper_, &SessionKeeper::noteChange);
    keeper_->watchLayout();
    viewport_->setFocus();
}

MainWindow::~MainWindow()
{
    // Pictures in the making end while the viewport, its render thread and the message strip are still there.
    qDeleteAll(findChildren<PrintDialog*>());
    qDeleteAll(findChildren<PictureExport*>());
    study_->stop();
}

void MainWindow::connectParts()
{
    connect(panel_, &ParameterPanel::edited, this, [this](const ParameterValues& values, int gesture, const QString& step) {
        Look next = history_.look();
        next.values[shown()] = values;
        history_.change(step, std::move(next), gesture);
    });
    connect(&history_, &History::changed, this, &MainWindow::showValues);
    connect(tabs_, &QTabBar::currentChanged, this, [this] {
        showValues();
        shelf_->refresh();
        searchElsewhere();
    });
    connect(panel_, &ParameterPanel::filtered, this, &MainWindow::searchElsewhere);
    connect(panel_, &ParameterPanel::elsewhereAsked, this, [this] { tabs_->setCurrentIndex(1 - tabs_->currentIndex()); });
    connect(panel_, &ParameterPanel::filterLeft, viewport_, [this] { viewport_->setFocus(); });
    connect(shelf_, &PresetShelf::marked, this, &MainWindow::showTitle);
    connect(exhibits_, &ExhibitList::chosen, this, [this](std::size_t exhibit) {
        visit(exhibit);
    });
    connect(viewport_, &Viewport::visited, this, &MainWindow::choose);
    connect(viewport_, &Viewport::pressed, this, [this](std::size_t exhibit) {
        Look next = history_.look();
        if (gallery_.exhibits()[exhibit]->press(next.values[exhibit]))
            history_.change(tr("Press the button of %1").arg(text(gallery_.exhibits()[exhibit]->title())), std::move(next));
    });
    connect(viewport_, &Viewport::failed, this, [this](const QString& message) { say(MessageStrip::Mood::problem, message); });
    connect(viewport_, &Viewport::drawn, this, [this](const render::FrameReport& report, const QSize& pixels) {
        status_->note(report, pixels, viewport_->reason());
        ledger_->note(report);
        for (const render::Skipped& complaint : complaints_.begun(report.skipped)) {
            const QString line = text(lineOf(complaint));
            if (complaint.unreadable.empty()) log_->add(line);
            else say(MessageStrip::Mood::problem, line);  // The log hears what the strip says.
        }
        keepThumbnail();
    });
    connect(study_, &StudyDock::failed, this, [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    connect(messages_, &MessageStrip::said, log_, &LogView::add);
}

void MainWindow::say(MessageStrip::Mood mood, const QString& words, const QString& several, const QString& what)
{
    messages_->say(mood, words, several, what);
}

void MainWindow::choose(std::size_t exhibit)
{
    if (chosen_ != exhibit) panel_->clearFilter();
    chosen_ = exhibit;
    exhibits_->choose(exhibit);
    viewport_->setSubject(exhibit);
    {
        const QSignalBlocker quiet(tabs_);
        while (tabs_->count() > 0) tabs_->removeTab(0);
        for (const std::size_t i : exhibit == 0 ? std::vector<std::size_t>{0} : std::vector<std::size_t>{exhibit, 0}) {
            const int tab = tabs_->addTab(text(gallery_.exhibits()[i]->title()));
            tabs_->setTabData(tab, static_cast<qulonglong>(i));
            tabs_->setTabToolTip(tab, text(gallery_.exhibits()[i]->summary()));
        }
        tabs_->updateGeometry();  // A tab bar that is not shown yet does not tell its layout that it has grown.
    }
    showValues();
    study_->setSubject(exhibit);
    shelf_->refresh();
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
    return static_cast<std::size_t>(tabs_->tabData(tabs_->currentIndex()).toULongLong());
}

QSize MainWindow::firstSize(const QSize& room)
{
    // Title bar and borders, as large as desktops draw them.
    return QSize(1400, 860).boundedTo(room - QSize(16, 48));
}

void MainWindow::showTitle()
{
    const QString use = shelf_->titleOfUse();
    QStringList parts{text(gallery_.exhibits()[shown()]->title())};
    if (!use.isEmpty()) parts << use;
    setWindowTitle(tr("%1 – Vitrine").arg(parts.join(QStringLiteral(": "))));
}

void MainWindow::searchElsewhere()
{
    QStringList found;
    const QString words = panel_->filterText();
    if (tabs_->count() > 1 && !words.isEmpty()) {
        const auto other = static_cast<std::size_t>(tabs_->tabData(1 - tabs_->currentIndex()).toULongLong());
        for (const ParameterInfo& row : gallery_.exhibits()[other]->parameters().rows())
            if (ParameterRow::matches(row, words)) found << QString::fromStdString(label(row));
        if (!found.isEmpty()) {
            const QString title = text(gallery_.exhibits()[other]->title());
            const QString more = found.size() > 3 ? tr(" and %1 more").arg(found.size() - 3) : QString();
            panel_->offerElsewhere(tr("%1: %2%3").arg(title, found.mid(0, 3).join(QStringLiteral(", ")), more));
            return;
        }
    }
    panel_->offerElsewhere({});
}

void MainWindow::showValues()
{
    panel_->showValues(history_.look().values[shown()], text(gallery_.exhibits()[shown()]->name()));
}

void MainWindow::resetEverything()
{
    const Exhibit& exhibit = *gallery_.exhibits()[shown()];
    Look next = history_.look();
    next.values[shown()] = exhibit.parameters().initial();
    history_.change(tr("Reset %1").arg(text(exhibit.title())), std::move(next));
}

void MainWindow::keepThumbnail()
{
    if (!viewport_->schedule().still()) return;
    QMetaObject::invokeMethod(shelf_, &PresetShelf::keepMissingThumbnail, Qt::QueuedConnection);
    if (exhibits_->hasThumbnail(chosen_)) return;
    const auto posed = chosen_ == 0 ? CameraControl::Mode::walk : CameraControl::Mode::orbit;
    if (viewport_->mode() != posed) return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            const QImage& picture = viewport_->shown();
            if (picture.isNull()) return;
            const QPixmap small = thumbnailOf(picture);
            exhibits_->setThumbnail(chosen_, small);
            const QString path = thumbnailPath(*gallery_.exhibits()[chosen_]);
            if (QDir().mkpath(QFileInfo(path).path())) small.save(path, "PNG");  // A cache: the next visit makes another.
        },
        Qt::QueuedConnection);
}

QPixmap MainWindow::thumbnailOf(const QImage& picture)
{
    const QSize size = TileDelegate::picture * 2;
    const QImage scaled = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    return QPixmap::fromImage(
        scaled.copy(QRect(QPoint((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2), size)));
}

void MainWindow::openPalette()
{
    (new CommandPalette(actions_->all, this))->show();
}

void MainWindow::openAbout()
{
    (new AboutDialog(this))->show();
}

void MainWindow::openShortcutSheet()
{
    (new ShortcutSheet(actions_->all, this))->show();
}

}  // namespace vitrine::ui

#include "moc_main_window.cpp"

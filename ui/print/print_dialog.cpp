#include "ui/print/print_dialog.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/printing/print_json.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/language.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/scroll_room.h"
#include "ui/kit/window_place.h"
#include "ui/print/place_bar.h"
#include "ui/print/print_export_bar.h"
#include "ui/print/print_numbers.h"
#include "ui/print/print_results.h"
#include "ui/print/print_side.h"
#include "ui/print/sheet_bar.h"
#include "ui/print/shown_views.h"
#include "ui/print/source_bar.h"

#include <QAction>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMimeData>
#include <QSettings>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

QString placesPath()
{
    return QString::fromStdString((stateFolder() / "print.ini").string());
}

/// Returns the cause of problems of an export. They are removed by the next one.
QString printExportCause()
{
    return QStringLiteral("export");
}

/// Returns the cause of problems of reading or rendering views.
QString printViewsCause()
{
    return QStringLiteral("views");
}

QStringList localFiles(const QMimeData& data)
{
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    return paths;
}

}  // namespace

PrintDialog::PrintDialog(ShownViews* shown, QWidget* parent)
    : QDialog(parent), setup_(shown != nullptr, this), loader_(shown, this), planner_(this), write_(this)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export lenticular print"));
    setAcceptDrops(true);
    build(shown != nullptr);
    buildUndo();
    connectSetup();
    connectViews();
    connectExport();
    recall();
}

PrintDialog::~PrintDialog()
{
    if (!remembered_) remember();  // The dialog is destroyed with the window, without having been closed.
}

QWidget* PrintDialog::buildRight()
{
    results_ = new PrintResults;
    export_ = new PrintExportBar(this);
    return scrolledAboveBar(results_, export_, this);
}

void PrintDialog::build(bool canShow)
{
    auto* sides = new QHBoxLayout;
    sides->setContentsMargins(0, 0, 0, 0);
    sides->setSpacing(8);
    side_ = new PrintSide(canShow, setup_, this);
    sides->addWidget(side_);
    QWidget* right = buildRight();
    sides->addWidget(right, 1);
    messages_ = new MessageStrip(this);
    messages_->lieOver(right);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(sides, 1);
    resize(1200, 680);  // Fits 1280 x 720 with a title bar.
}

void PrintDialog::buildUndo()
{
    undo_ = setup_.stack().createUndoAction(this);
    undo_->setShortcuts(QKeySequence::Undo);
    redo_ = setup_.stack().createRedoAction(this);
    redo_->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    addActions({undo_, redo_});
    new IdleUndo(this);
}

void PrintDialog::connectSetup()
{
    connect(&setup_, &PrintSetup::changed, this, &PrintDialog::showState);
    connect(side_, &PrintSide::chartChosen, this, &PrintDialog::setChart);
    connect(&side_->source(), &SourceBar::originChosen, this, [this](printing::ViewOrigin origin) {
        ParameterValues values = this->values();
        for (const auto& old : {printing::printTable().files, printing::printTable().quilt})
            values.set(old, std::string());
        values.set(printing::printTable().origin, origin);
        values.set(printing::printTable().places, std::string());
        setup_.change(tr("Change the origin of the views"), values);
    });
    connect(&side_->source(), &SourceBar::filesChosen, this, &PrintDialog::openFiles);
    connect(&side_->sheets(), &SheetBar::failed, this,
            [this](const QString& why) { messages_->setProblems(QStringLiteral("sheets"), {why}); });
    connect(&results_->numbers(), &PrintNumbersView::fitAsked, this, [this](double strength) {
        ParameterValues values = this->values();
        values.set(printing::printTable().baselineScale, strength);
        setup_.change(tr("Fit depth"), values);
    });
}

void PrintDialog::connectViews()
{
    connect(&side_->source(), &SourceBar::renderAsked, this, [this] { loader_.load(values()); });
    connect(&loader_, &ViewLoader::said, &side_->source(), &SourceBar::say);
    connect(&loader_, &ViewLoader::changed, this, [this] {
        side_->source().places().showViews(loader_.views().get());
        messages_->setProblems(printViewsCause(), {});
        refresh();
    });
    connect(&loader_, &ViewLoader::progressed, this,
            [this](double part, double secondsLeft) { export_->showProgress(part, secondsLeft); });
    connect(&loader_, &ViewLoader::readyForPrint, this, [this] { write(loader_.views()); });
    connect(&loader_, &ViewLoader::failed, this, [this](const QString& why) {
        messages_->setProblems(printViewsCause(), {why});
        if (exporting_) endExport(tr("Nothing was written."));
        refresh();
    });
    connect(&planner_, &PrintPlanner::failed, this,
            [this](const QString& why) { messages_->setProblems(QStringLiteral("preview"), {why}); });
    connect(&planner_, &PrintPlanner::planned, this, &PrintDialog::showPlan);
    connect(&planner_, &PrintPlanner::previewed, this,
            [this](const std::shared_ptr<const printing::PrintPreview>& preview, double distance) {
                results_->showPreview(preview, distance, chart_);
            });
}

void PrintDialog::connectExport()
{
    connect(export_, &ExportBar::pathChanged, this, &PrintDialog::refresh);
    connect(export_, &ExportBar::exportAsked, this, &PrintDialog::begin);
    connect(export_, &ExportBar::stopAsked, this, &PrintDialog::reject);
    connect(export_, &PrintExportBar::settingsLoaded, this, &PrintDialog::loadSettings);
    connect(export_, &PrintExportBar::settingsSaved, this, &PrintDialog::saveSettings);
    connect(&write_, &ProgressJob::progressed, export_, &ExportBar::showProgress);
    connect(&write_, &ProgressJob::stopped, this, [this] { endExport(tr("Canceled; no file was written.")); });
    connect(&write_, &ProgressJob::failed, this, [this](const QString& why) {
        endExport(tr("Nothing was written."));
        messages_->setProblems(printExportCause(), {why});
    });
}

void PrintDialog::recall()
{
    const QSettings places(iniPath(placesPath()), QSettings::IniFormat);
    restorePlace(*this, places.value(QStringLiteral("geometry")).toByteArray());
    QString folder = places.value(QStringLiteral("folder")).toString();
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    export_->suggest(folder);
    trySaying([this] {
        for (const QString& note : setup_.recall()) say(MessageStrip::Mood::notice, note);
    });
}

void PrintDialog::remember()
{
    remembered_ = true;
    try {
        setup_.remember();
        QSettings places(iniPath(placesPath()), QSettings::IniFormat);
        places.setValue(QStringLiteral("geometry"), saveGeometry());
        places.setValue(QStringLiteral("folder"), QFileInfo(path()).absolutePath());
    } catch (const std::exception& failure) {
        qWarning("%s", failure.what());  // The dialog is closing; nothing else depends on it.
    }
}

bool PrintDialog::trySaying(const std::function<void()>& work)
{
    try {
        work();
        messages_->setProblems(QStringLiteral("settings"), {});
        return true;
    } catch (const std::exception& failure) {
        messages_->setProblems(QStringLiteral("settings"), {translatedText(failure.what())});
        return false;
    }
}

void PrintDialog::say(MessageStrip::Mood mood, const QString& text, const QString& file)
{
    messages_->say(mood, text, {}, {}, file);
}

void PrintDialog::setValues(const ParameterValues& values)
{
    setup_.change(tr("Change settings"), values);
}

void PrintDialog::change(const QString& undoText, const ParameterValues& values)
{
    if (exporting_)
        say(MessageStrip::Mood::notice, tr("The settings of a print cannot change while it is written."));
    else
        setup_.change(undoText, values);
}

bool PrintDialog::fromWindow() const
{
    return values()[printing::printTable().origin] == printing::ViewOrigin::shown;
}

ParameterValues PrintDialog::printed() const
{
    return chart_ ? printing::chartValues(values()) : values();
}

void PrintDialog::showState(bool views)
{
    side_->showChart(chart_);
    side_->source().showOrigin(values()[printing::printTable().origin]);
    if (views) loader_.load(values());
    refresh();
}

void PrintDialog::setChart(bool chart)
{
    chart_ = chart;
    export_->setChart(chart);
    side_->showChart(chart);
    results_->showChart(chart);
    refresh();
}

void PrintDialog::setPath(const QString& path)
{
    export_->setPath(path);
}

QString PrintDialog::path() const
{
    return export_->path();
}

bool PrintDialog::settled() const
{
    return planner_.settled() && !loader_.busy();
}

void PrintDialog::refresh()
{
    const std::shared_ptr<const printing::PrintViews> views = chart_ ? nullptr : loader_.views();
    // Views still to be rendered follow the values, so the present ones are not counted.
    planner_.refresh({printed(), path().toStdString(), chart_, views, fromWindow() ? nullptr : views});
    showButtons();
}

void PrintDialog::showPlan()
{
    const printing::PrintPlan& plan = planner_.plan();
    results_->numbers().showPlan(plan, chart_ ? std::nullopt : loader_.depth());
    showButtons();
    loader_.setPossible(plan.refusal.empty() && !chart_);
}

void PrintDialog::showButtons()
{
    const bool hasViews = chart_ || loader_.views() || fromWindow();
    export_->showPossible(exporting_, planner_.plan().refusal.empty() && hasViews && !loader_.reading());
    side_->setEnabled(!exporting_);
    undo_->setEnabled(!exporting_ && setup_.stack().canUndo());
    redo_->setEnabled(!exporting_ && setup_.stack().canRedo());
}

void PrintDialog::loadSettings(const QString& path)
{
    trySaying([&] { loadPrint(path.toStdString()); });
}

void PrintDialog::loadPrint(const std::string& path)
{
    std::vector<std::string> doubts;
    for (const QString& note : setup_.load(printing::settingsIn(path, &doubts), path))
        say(MessageStrip::Mood::notice, note);
    for (const std::string& doubt : doubts) say(MessageStrip::Mood::problem, translatedText(doubt));
}

void PrintDialog::saveSettings(const QString& path)
{
    trySaying([&] {
        render::atomicWriteMakingFolder(path.toStdString(), setup_.text());
        say(MessageStrip::Mood::notice, tr("Settings saved to %1.").arg(path), path);
    });
}

void PrintDialog::openFiles(const QStringList& paths)
{
    if (paths.isEmpty() || exporting_) return;
    if (paths.size() == 1 && QFileInfo(paths.front()).isFile()) {
        if (QFileInfo(paths.front()).suffix().toLower() == QLatin1String("json")) {
            loadSettings(paths.front());
            return;
        }
        try {
            loadPrint(paths.front().toStdString());
            return;
        } catch (const std::exception&) {  // Not a print: opened as a picture.
        }
    }
    if (chart_) setChart(false);
    ParameterValues values = this->values();
    if (files() != paths) values.set(printing::printTable().places, std::string());  // Places go with files.
    if (fromWindow()) values.set(printing::printTable().origin, printing::ViewOrigin::files);
    values = printing::withPictures(values, textsOf(paths));
    if (values == this->values())
        loader_.load(values);  // The files may have changed on disk.
    else
        setup_.change(tr("Choose views"), values);
}

void PrintDialog::dragEnterEvent(QDragEnterEvent* event)
{
    if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void PrintDialog::dropEvent(QDropEvent* event)
{
    openFiles(localFiles(*event->mimeData()));
    event->acceptProposedAction();
}

void PrintDialog::startExport()
{
    if (!exporting_) export_->askForPrint();
}

void PrintDialog::begin(const QString&)
{
    if (exporting_) return;
    exporting_ = true;
    messages_->setProblems(printExportCause(), {});
    export_->showStatus(tr("Starting"));
    showButtons();
    if (chart_)
        write(nullptr);
    else if (!fromWindow() || loader_.inFull())
        write(loader_.views());
    else
        loader_.renderInFull();
}

void PrintDialog::stopExport()
{
    if (!exporting_) return;
    if (write_.running()) {
        export_->showStatus(tr("Stopping"));
        write_.stop();
        return;
    }
    loader_.stop();
    endExport(tr("Canceled; no file was written."));
}

void PrintDialog::write(std::shared_ptr<const printing::PrintViews> views)
{
    write_.start([this, views = std::move(views), file = std::filesystem::path(path().toStdString()),
                  values = printed()](const ProgressJob::Progress& progress) -> ProgressJob::Outcome {
        printing::PrintFile print = printing::printFile(values, file);
        print.json = printing::printText(values, views.get(), file);
        print.progress = progress;
        const printing::StagedPrint staged = printing::stagedPrint(values, views.get(), print);
        staged.publish();
        return [this, written = staged.pictures] {
            const QString first = QString::fromStdString(written.front().string());
            export_->setPath(nextFreePath(path()));
            say(MessageStrip::Mood::notice,
                written.size() == 1 ? tr("Saved %1, and its settings beside it.").arg(first)
                                    : tr("Saved %1 files, the first %2, and their settings beside them.")
                                          .arg(written.size())
                                          .arg(first),
                first);
            endExport(QString());
        };
    });
}

void PrintDialog::endExport(const QString& words)
{
    exporting_ = false;
    export_->showStatus(words);
    showButtons();
    emit exportEnded(words.isEmpty());
}

void PrintDialog::reject()
{
    if (exporting_)
        stopExport();
    else
        QDialog::reject();
}

void PrintDialog::done(int result)
{
    loader_.stop();
    write_.stop();
    remember();
    QDialog::done(result);
}

}  // namespace vitrine::ui

#include "moc_print_dialog.cpp"

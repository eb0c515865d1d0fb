#include "ui/jobs/job_dialog.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/jobs/kit/command_line.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/failure.h"
#include "render/files/shell_word.h"
#include "ui/jobs/job_preview.h"
#include "ui/jobs/make_preview.h"
#include "ui/kit/export_bar.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/numbers.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/scroll_room.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_panel.h"

#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int jobPanelWidth = 376;
constexpr int planShareOfScreen = 38;  // Percent of the screen that the panel takes at most.
constexpr double leastExpected = 3;    // Seconds from which the expected time is a number.

// Cause of a problem in the message list. Problems of different causes are removed separately.
QString jobExportCause()
{
    return QStringLiteral("export");
}
QString jobInputCause()
{
    return QStringLiteral("inputs");
}

QString jobPlaces()
{
    return QString::fromStdString((stateFolder() / "jobs.ini").string());
}

bool writesFolder(const jobs::Job& job)
{
    return job.needs().extensions.empty();
}

/// Returns the usual extension; empty for a folder.
QString extensionOf(const jobs::Job& job)
{
    return writesFolder(job) ? QString() : text(job.needs().extensions.front());
}

/// Returns the filter of a file dialog: "PNG (*.png);;TIF (*.tif)".
QString filtersOf(const jobs::Job& job)
{
    QStringList filters;
    for (const std::string_view extension : job.needs().extensions)
        filters << QStringLiteral("%1 (*.%2)").arg(text(extension).toUpper(), text(extension));
    return filters.join(QStringLiteral(";;"));
}

}  // namespace

JobDialog::JobDialog(const jobs::Job& job, SceneSource scene, Renderers& renderers, RenderThread& thread,
                     QWidget* parent)
    : QDialog(parent), job_(job), setup_(job, this), planner_(job, std::move(scene), setup_, this),
      full_(renderers, thread, this), preview_(makePreview(job, this)), draft_(job, renderers, thread, preview_, this)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(translatedText(job_.title()));
    build();
    buildUndo();
    connectParts();
    recall();
}

JobDialog::~JobDialog()
{
    if (!remembered_) remember();  // The window took it along.
}

void JobDialog::build()
{
    panel_ = new ParameterPanel(setup_.history(), this);
    panel_->showExhibit(0, text(job_.name()));
    if (preview_)
        growWidth(*panel_, jobPanelWidth, planShareOfScreen);
    else
        growMinimumWidth(*panel_, jobPanelWidth);
    // Without a preview, the settings use its space.
    auto* sides = new QBoxLayout(preview_ ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    sides->setSpacing(8);
    sides->addWidget(panel_, preview_ ? 0 : 1);
    QWidget* right = buildRight();
    sides->addWidget(right, preview_ ? 1 : 0);
    messages_ = new MessageStrip(this);
    messages_->lieOver(right);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(sides, 1);
    resize(preview_ ? 1000 : 600, 680);  // With a title bar it fits 1280 x 720.
}

QWidget* JobDialog::buildRight()
{
    facts_ = new QLabel(this);
    facts_->setObjectName(QStringLiteral("facts"));
    facts_->setTextFormat(Qt::PlainText);
    facts_->setWordWrap(true);
    auto* content = new QWidget;
    auto* results = new QVBoxLayout(content);
    results->setContentsMargins(8, 8, 16, 8);
    results->setSpacing(8);
    if (preview_) results->addWidget(preview_, 1);
    results->addWidget(facts_);
    buildBar();
    return scrolledAboveBar(content, export_, this);
}

void JobDialog::buildBar()
{
    export_ = new ExportBar({writesFolder(job_)
                                 ? tr("Output folder. The settings lie beside it.")
                                 : tr("Output file. Further files take its name, and the settings lie beside it."),
                             translatedText(job_.title()), filtersOf(job_), extensionOf(job_), writesFolder(job_)},
                            this);
    if (!job_.needs().carriesSettings) {
        QPushButton* load = export_->addButton(
            tr("Load settings…"),
            tr("Loads all settings from a settings document, or from an exported file that has one beside it."));
        connect(load, &QPushButton::clicked, this, &JobDialog::chooseDocument);
    }
    QPushButton* copy =
        export_->addButton(tr("Copy command"), tr("A line for a terminal, which writes the same files."));
    connect(copy, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(commandLine());
        messages_->say(MessageStrip::Mood::notice, tr("A line for a terminal is on the clipboard."));
    });
}

void JobDialog::buildUndo()
{
    QUndoStack& stack = setup_.history().stack();
    QAction* undo = stack.createUndoAction(this);
    undo->setShortcuts(QKeySequence::Undo);
    QAction* redo = stack.createRedoAction(this);
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    addActions({undo, redo});
    new IdleUndo(this);
}

void JobDialog::connectParts()
{
    connect(&setup_, &JobSetup::changed, this, &JobDialog::follow);
    connect(&planner_, &JobPlanner::planned, this, &JobDialog::showPlan);
    connect(&planner_, &JobPlanner::failed, this, [this](const QString& why) {
        draft_.clear();
        facts_->clear();
        complain(why);
        showButtons();
    });
    connect(&draft_, &JobDraft::failed, this, &JobDialog::complain);
    connect(&draft_, &JobDraft::shown, this, [this](const jobs::JobReport& report, const jobs::JobForecast& forecast) {
        if (!planner_.plan()) return;
        draftSays_ = forecast.seconds;
        std::vector<jobs::Fact> facts = planner_.plan()->facts;
        facts.insert(facts.end(), forecast.facts.begin(), forecast.facts.end());
        // A draft without facts of its own only shows what there will be.
        if (!report.facts.empty() && planner_.drawsAll(forecast))
            showFacts(report.facts, report.warnings, false);
        else
            showFacts(facts, {}, true);
    });
    connect(&full_, &JobRunner::progressed, export_, &ExportBar::showProgress);
    connect(&full_, &JobRunner::finished, this, [this](const JobRunner::Run& run) {
        const auto& files = run->report().files;
        const QString name = QString::fromStdString(files.front().string());
        const QString saved = files.size() > 1 ? tr("Saved %1. Files beside it: %2.").arg(name).arg(files.size() - 1)
                                               : tr("Saved %1.").arg(name);
        const QString page = name + QStringLiteral("/index.html");
        messages_->say(MessageStrip::Mood::notice, saved, {}, {}, QFileInfo::exists(page) ? page : name);
        export_->setPath(nextFreePath(path()));
        endExport(QString());
        if (!preview_ && planner_.plan()) showFacts(run->report().facts, run->report().warnings, false);
    });
    connect(&full_, &JobRunner::failed, this, [this](const QString& why) {
        endExport(tr("Nothing was written."));
        messages_->setProblems(jobExportCause(), {why});
    });
    connect(export_, &ExportBar::pathChanged, this, [this] {
        if (!exporting() && QFileInfo(path()).suffix() != suffix_) follow();
    });
    connect(export_, &ExportBar::goAsked, this, &JobDialog::startExport);
    connect(export_, &ExportBar::exportAsked, this, &JobDialog::begin);
    connect(export_, &ExportBar::stopAsked, this, &JobDialog::reject);
}

void JobDialog::recall()
{
    QSettings places(iniPath(jobPlaces()), QSettings::IniFormat);
    places.beginGroup(text(job_.name()));
    QString folder = places.value(QStringLiteral("folder")).toString();
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    // A recording is named after what it shows, a sprite sheet or mesh after the job.
    const jobs::JobScene scene = planner_.scene();
    const bool chooses = job_.needs().choosesSubject();
    const std::string_view name = chooses ? scene.museum->subject(scene.subject).name() : job_.name();
    const QString ending = writesFolder(job_) ? QString() : QLatin1Char('.') + extensionOf(job_);
    const QString path = QDir(folder).filePath(text(name) + ending);
    export_->setPath(QFileInfo::exists(path) ? nextFreePath(path) : path);
    setup_.recall();
}

void JobDialog::remember()
{
    remembered_ = true;
    setup_.remember();
    QSettings places(iniPath(jobPlaces()), QSettings::IniFormat);
    places.beginGroup(text(job_.name()));
    places.setValue(QStringLiteral("folder"), QFileInfo(path()).absolutePath());
}

void JobDialog::complain(const QString& why)
{
    messages_->setProblems(jobInputCause(), why.isEmpty() ? QStringList() : QStringList(why));
}

void JobDialog::follow()
{
    draftSays_ = 0;
    draftIsDue_ = false;
    draft_.cancel();
    planner_.follow();
    showButtons();
}

void JobDialog::refresh()
{
    draft_.cancel();
    draftIsDue_ = false;
    planner_.refresh();
    showButtons();
}

std::filesystem::path JobDialog::output() const
{
    return path().toStdString();
}

void JobDialog::showPlan()
{
    complain({});
    const jobs::JobPlan& plan = *planner_.plan();
    panel_->setOffers(plan.offers);
    showButtons();
    showFacts(plan.facts, {}, false);
    suffix_ = QFileInfo(path()).suffix();
    if (plan.refusal.empty())
        startDraft();
    else
        draft_.clear();
}

void JobDialog::startDraft()
{
    // A page that is not shown draws nothing; it catches up when it is shown.
    draftIsDue_ = !isVisible();
    if (draftIsDue_) return;
    draft_.start(planner_.order(planner_.drawn()), job_.withScene(setup_.values(), planner_.scene()), output());
}

void JobDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (draftIsDue_ && !planner_.busy() && planner_.plan()) startDraft();
}

void JobDialog::showFacts(const std::vector<jobs::Fact>& facts, const std::vector<std::string>& warnings, bool partly)
{
    const jobs::JobPlan& plan = *planner_.plan();
    if (!plan.refusal.empty()) {
        facts_->setText(translatedText(plan.refusal));
        return;
    }
    QStringList texts;
    for (const jobs::Fact& fact : facts)
        texts << translatedText(fact.label) + QLatin1Char(' ') +
                     withDecimalSign(QString::fromStdString(valueText(fact)));
    QStringList lines{texts.join(QStringLiteral(" · "))};
    if (partly) lines << translatedText(std::string(job_.draftNote()));
    if (const double seconds = secondsExpected(); seconds >= leastExpected)
        lines << (seconds < 90 ? tr("It will take about %1 s.").arg(std::ceil(seconds))
                               : tr("It will take about %1 min.").arg(std::round(seconds / 60)));
    else if (seconds > 0)
        lines << tr("It will take less than %1 s.").arg(leastExpected);
    for (const std::string& warning : plan.warnings) lines << translatedText(warning);
    for (const std::string& warning : warnings) lines << translatedText(warning);
    facts_->setText(lines.join(QLatin1Char('\n')));
}

double JobDialog::secondsExpected() const
{
    if (draftSays_ > 0) return draftSays_;
    const jobs::JobScene scene = planner_.scene();
    return scene.usual.secondsPerSample * job_.effort(setup_.values(), scene);
}

void JobDialog::showButtons()
{
    const auto& plan = planner_.plan();
    export_->showPossible(exporting(), planner_.hasInputs() && plan && plan->refusal.empty());
    panel_->setEnabled(!exporting());
}

bool JobDialog::settled() const
{
    return !planner_.busy() && !draft_.busy();
}

void JobDialog::setPath(const QString& path)
{
    export_->setPath(path);
}

QString JobDialog::path() const
{
    return export_->path();
}

QString JobDialog::commandLine() const
{
    jobs::JobOrder all = planner_.order(setup_.values());
    all.out = output();
    QString line = QStringLiteral("vitrine");
    for (const std::string& word : commandOf(job_, all))
        line += QLatin1Char(' ') + QString::fromStdString(render::shellWord(word));
    return line;
}

void JobDialog::chooseDocument()
{
    auto* dialog = new QFileDialog(this, tr("Load settings"), QFileInfo(path()).absolutePath());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Settings of jobs (*.vitrine-job.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &JobDialog::load);
    dialog->open();
}

void JobDialog::load(const QString& file)
{
    try {
        const jobs::JobDocument document = jobs::readDocument(file.toStdString(), job_, planner_.scene().museum);
        messages_->setProblems(jobExportCause(), {});
        for (const std::string& note : document.notes) messages_->say(MessageStrip::Mood::notice, translatedText(note));
        setup_.change(tr("Load settings"), document.values);
    } catch (const Failure& failure) {
        messages_->setProblems(jobExportCause(), {messageOf(failure)});
    }
}

void JobDialog::startExport()
{
    if (exporting() || !planner_.hasInputs()) return;
    const jobs::JobPlan plan = planner_.planFor(output());
    if (refuse(plan)) return;
    ifStopped_ = plan.ifStopped.empty() ? tr("Canceled; no file was written.") : translatedText(plan.ifStopped);
    QStringList beside;
    for (const jobs::PlannedFile& file : plan.files) beside << QString::fromStdString(file.path.string());
    beside.removeFirst();
    export_->ask(beside);
}

bool JobDialog::refuse(const jobs::JobPlan& plan)
{
    const bool refused = !plan.refusal.empty();
    messages_->setProblems(jobExportCause(), refused ? QStringList(translatedText(plan.refusal)) : QStringList());
    return refused;
}

void JobDialog::begin()
{
    if (exporting() || !planner_.hasInputs()) return;
    // The scene or its files may have changed while the question about replacing a file was open.
    if (refuse(planner_.planFor(output()))) return;
    jobs::JobOrder all = planner_.order(setup_.values());
    all.out = output();
    export_->showStatus(tr("Starting"));
    full_.start(job_, std::move(all));
    showButtons();
    emit exportBegun();
}

void JobDialog::endExport(const QString& words)
{
    export_->showStatus(words);
    showButtons();
    emit exportEnded(words.isEmpty());
}

void JobDialog::reject()
{
    if (!exporting()) {
        QDialog::reject();
    } else if (!full_.publishing()) {
        full_.cancel();
        endExport(ifStopped_);
    }
}

void JobDialog::done(int result)
{
    full_.cancel();
    draft_.cancel();
    remember();
    QDialog::done(result);
}

}  // namespace vitrine::ui

#include "moc_job_dialog.cpp"

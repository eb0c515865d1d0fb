#include "ui/jobs/job_dialog.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/jobs/kit/command_line.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/failure.h"
#include "render/files/shell_word.h"
#include "ui/jobs/job_preview.h"
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
constexpr int planAfter = 250;       // Milliseconds.
constexpr double leastExpected = 3;  // Seconds from which the expected time is shown.

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

QString extensionOf(const jobs::Job& job)
{
    return text(job.needs().extensions.front());
}

/// Returns the filter of a file dialog: "PNG (*.png);;TIF (*.tif)".
QString filtersOf(const jobs::Job& job)
{
    QStringList filters;
    for (const std::string_view extension : job.needs().extensions)
        filters << QStringLiteral("%1 (*.%2)").arg(text(extension).toUpper(), text(extension));
    return filters.join(QStringLiteral(";;"));
}

/// Returns the files of parameters that have an effect.
std::vector<std::string> filesOf(const ParameterValues& values)
{
    std::vector<std::string> files;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (values.rows()[i].kind == Kind::file)
            files.push_back(acts(values, i) ? std::get<std::string>(values.row(i)) : std::string());
    return files;
}

}  // namespace

/// Outcome of planning on another thread.
struct JobDialog::Planned {
    ParameterValues values, draft;
    std::shared_ptr<const jobs::JobInputs> inputs;
    jobs::JobPlan plan;
};

JobDialog::JobDialog(const jobs::Job& job, SceneSource scene, Renderers& renderers, RenderThread& thread,
                     QWidget* parent)
    : QDialog(parent), job_(job), scene_(std::move(scene)), setup_(job, this), draft_(renderers, thread, this),
      full_(renderers, thread, this), plan_(this), show_(this)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(translatedText(job_.title()));
    soon_.setSingleShot(true);
    soon_.setInterval(planAfter);
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
    facts_ = new QLabel(this);
    facts_->setTextFormat(Qt::PlainText);
    facts_->setWordWrap(true);
    preview_ = makePreview(job_.name(), this);
    buildBar();

    if (preview_)
        growWidth(*panel_, jobPanelWidth);
    else
        growMinimumWidth(*panel_, jobPanelWidth);
    auto* content = new QWidget;
    auto* right = new QVBoxLayout(content);
    right->setContentsMargins(8, 8, 16, 16);
    right->setSpacing(8);
    if (preview_) right->addWidget(preview_, 1);
    right->addWidget(facts_);
    right->addWidget(export_);
    // Without a preview, the settings use its space.
    auto* sides = new QBoxLayout(preview_ ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    sides->setSpacing(8);
    sides->addWidget(panel_, preview_ ? 0 : 1);
    auto* room = new ScrollRoom(content, this);
    sides->addWidget(room, preview_ ? 1 : 0);
    messages_ = new MessageStrip(this);
    messages_->lieOver(room);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(sides, 1);
    resize(preview_ ? 1000 : 600, 680);  // With a title bar it fits 1280 x 720.
}

void JobDialog::buildBar()
{
    export_ = new ExportBar({tr("Output file. Further files take its name, and the settings lie beside it."),
                             translatedText(job_.title()), filtersOf(job_), extensionOf(job_)},
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
    connect(&soon_, &QTimer::timeout, this, &JobDialog::plan);
    connect(&plan_, &ProgressJob::failed, this, [this](const QString& why) {
        inputs_.reset();
        planned_.reset();
        if (preview_) preview_->clear();
        facts_->clear();
        messages_->setProblems(jobInputCause(), {why});
        showButtons();
    });
    connect(&draft_, &JobRunner::finished, this, &JobDialog::showDraft);
    connect(&draft_, &JobRunner::failed, this, &JobDialog::complain);
    connect(&show_, &ProgressJob::failed, this, &JobDialog::complain);
    connect(&full_, &JobRunner::progressed, export_, &ExportBar::showProgress);
    connect(&full_, &JobRunner::finished, this, [this](const JobRunner::Run& run) {
        const auto& files = run->report().files;
        const QString name = QString::fromStdString(files.front().string());
        const QString saved = files.size() > 1 ? tr("Saved %1. Files beside it: %2.").arg(name).arg(files.size() - 1)
                                               : tr("Saved %1.").arg(name);
        messages_->say(MessageStrip::Mood::notice, saved, {}, {}, name);
        export_->setPath(nextFreePath(path()));
        endExport(QString());
        if (!preview_ && planned_) showFacts(run->report(), false);
    });
    connect(&full_, &JobRunner::failed, this, [this](const QString& why) {
        endExport(tr("Nothing was written."));
        messages_->setProblems(jobExportCause(), {why});
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
    const jobs::JobScene scene = scene_();
    const bool chooses = job_.needs().choosesSubject();
    const std::string_view name = chooses ? scene.museum->subject(scene.subject).name() : job_.name();
    const QString path = QDir(folder).filePath(text(name) + QLatin1Char('.') + extensionOf(job_));
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
    if (filesOf(setup_.values()) != files_) inputs_.reset();
    draft_.cancel();
    show_.stop();
    soon_.start();
    showButtons();
}

void JobDialog::refresh()
{
    inputs_.reset();
    follow();
}

std::filesystem::path JobDialog::output() const
{
    return path().toStdString();
}

jobs::JobOrder JobDialog::order(const ParameterValues& values) const
{
    const jobs::JobScene scene = scene_();
    return {job_.withScene(values, scene), job_.sceneFor(values, scene), inputs_, {}, {}};
}

void JobDialog::plan()
{
    const ParameterValues values = setup_.values();
    plan_.start([this, values, inputs = inputs_, scene = scene_(),
                 &job = job_](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        const auto read = inputs ? inputs : job.read(job.withScene(values, scene));
        const Planned planned{values, job.draft(values, *read), read, job.plan(values, scene, *read, {})};
        return [this, planned] { takePlan(planned); };
    });
}

void JobDialog::takePlan(const Planned& planned)
{
    if (!(planned.values == setup_.values())) return;  // Another one is on its way.
    complain({});
    inputs_ = planned.inputs;
    files_ = filesOf(planned.values);
    planned_ = planned.plan;
    drawn_ = planned.draft;
    panel_->setOffers(planned_->offers);
    showButtons();
    showFacts({{}, planned_->facts, {}}, false);
    if (!planned_->refusal.empty()) {
        if (preview_) preview_->clear();
        return;
    }
    if (preview_) draft_.start(job_, order(*drawn_));
}

void JobDialog::showDraft(const JobRunner::Run& run)
{
    const bool whole = job_.plan(*drawn_, scene_(), *inputs_, {}).facts == planned_->facts;
    show_.start([this, run, whole, all = setup_.values(), drawn = *drawn_,
                 preview = preview_](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        return [this, run, whole, show = preview->prepare(*run, all, drawn)] {
            show();
            if (planned_) showFacts(whole ? run->report() : jobs::JobReport{{}, planned_->facts, {}}, !whole);
        };
    });
}

void JobDialog::showFacts(const jobs::JobReport& report, bool partly)
{
    if (!planned_->refusal.empty()) {
        facts_->setText(translatedText(planned_->refusal));
        return;
    }
    QStringList texts;
    for (const jobs::Fact& fact : report.facts)
        texts << translatedText(fact.label) + QLatin1Char(' ') +
                     withDecimalSign(QString::fromStdString(valueText(fact)));
    QStringList lines{texts.join(QStringLiteral(" · "))};
    if (partly) lines << translatedText(std::string(job_.draftNote()));
    if (const double seconds = secondsExpected(); seconds >= leastExpected)
        lines << (seconds < 90 ? tr("It will take about %1 s.").arg(std::ceil(seconds))
                               : tr("It will take about %1 min.").arg(std::round(seconds / 60)));
    for (const std::string& warning : planned_->warnings) lines << translatedText(warning);
    for (const std::string& warning : report.warnings) lines << translatedText(warning);
    facts_->setText(lines.join(QLatin1Char('\n')));
}

double JobDialog::secondsExpected() const
{
    const jobs::JobScene scene = scene_();
    return scene.usual.secondsPerSample * job_.effort(setup_.values(), scene);
}

void JobDialog::showButtons()
{
    export_->showPossible(exporting(), inputs_ && planned_ && planned_->refusal.empty());
    panel_->setEnabled(!exporting());
}

bool JobDialog::settled() const
{
    return !plan_.running() && !soon_.isActive() && !draft_.running() && !show_.running();
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
    jobs::JobOrder all = order(setup_.values());
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
        const jobs::JobDocument document = jobs::readDocument(file.toStdString(), job_, scene_().museum);
        messages_->setProblems(jobExportCause(), {});
        for (const std::string& note : document.notes) messages_->say(MessageStrip::Mood::notice, translatedText(note));
        setup_.change(tr("Load settings"), document.values);
    } catch (const Failure& failure) {
        messages_->setProblems(jobExportCause(), {messageOf(failure)});
    }
}

void JobDialog::startExport()
{
    if (exporting() || !inputs_) return;
    const jobs::JobPlan plan = job_.plan(setup_.values(), scene_(), *inputs_, output());
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
    if (exporting() || !inputs_) return;
    // The scene or its files may have changed while the question about replacing a file was open.
    if (refuse(job_.plan(setup_.values(), scene_(), *inputs_, output()))) return;
    jobs::JobOrder all = order(setup_.values());
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

#include "ui/study/study_dock.h"

#include "exhibits/jobs.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/measure/memory.h"
#include "ui/kit/flow_layout.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/text.h"
#include "ui/kit/time_left.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/study/both_settings_button.h"
#include "ui/study/kept_studies.h"
#include "ui/study/study_export.h"
#include "ui/study/study_finder.h"
#include "ui/study/study_view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int shortTile = 96;        ///< Pixels, so that no step delays the next picture of the viewport for long.
constexpr qint64 refreshTime = 200;  ///< Milliseconds between two updates of the chart while measuring.
constexpr int leastToKeep = 3;       ///< Number of measured settings from which a stopped study is kept.

}  // namespace

StudyDock::StudyDock(const Museum& museum, Renderers& renderers, History& history, RenderThread& thread,
                     StudyStore store, QWidget* parent)
    : QWidget(parent), museum_(museum), renderers_(renderers), history_(history), thread_(thread),
      setup_(*jobs::findJob("study"), this), measuring_(new QHBoxLayout), parameter_(new QComboBox(this)),
      go_(new QPushButton(this)), copy_(new QToolButton(this)), save_(new QToolButton(this)),
      list_(new QToolButton(this)), progress_(new QProgressBar(this)), doing_(new QLabel(this)),
      finder_(new StudyFinder(this)), shown_(new StudyView(museum, history, this)),
      kept_(new KeptStudies(museum.subjects(), history, std::move(store), this)),
      settings_(new ParameterPanel(setup_.history(), this))
{
    setTexts();
    settings_->showExhibit(0, QStringLiteral("study"));
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 8, 8, 8);
    all->setSpacing(8);
    layOutMeasuring();
    all->addLayout(measuring_);
    all->addLayout(choosing());
    all->addWidget(studies(), 1);
    connectParts();
    setup_.recall();
    showIdle();
}

void StudyDock::setTexts()
{
    parameter_->setAccessibleName(tr("What to measure"));
    // Long names of parameters must not widen the window.
    parameter_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    parameter_->setMinimumContentsLength(14);
    parameter_->setPlaceholderText(tr("As in the settings"));
    progress_->setAccessibleName(tr("Progress"));
    go_->setAccessibleName(tr("Measure, or stop measuring"));
    growWidth(*progress_, 120);
    progress_->setTextVisible(false);
    // Widgets that are shown only while measuring must not move the picture above.
    QSizePolicy keepsItsPlace = progress_->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(keepsItsPlace);
    growWidth(*go_, 80);
    copy_->setText(tr("Copy"));
    copy_->setAccessibleName(tr("Copy the measurements"));
    copy_->setToolTip(tr("Copies what was measured as a table (CSV)."));
    save_->setText(tr("Save…"));
    save_->setAccessibleName(tr("Save the measurements"));
    save_->setToolTip(tr("Saves what was measured as a table (CSV) or JSON, or the chart as PNG, SVG or PDF."));
    list_->setText(tr("History"));
    list_->setCheckable(true);
    list_->setAccessibleName(tr("Show the history of studies"));
    list_->setToolTip(
        tr("Shows the studies that were kept: to look at again, compare, rename, delete, open and save."));
    doing_->setTextFormat(Qt::PlainText);
    doing_->setMinimumWidth(40);
    doing_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void StudyDock::layOutMeasuring()
{
    measuring_->setSpacing(8);
    measuring_->addWidget(parameter_);
    measuring_->addWidget(go_);
    measuring_->addWidget(progress_);
    measuring_->addWidget(doing_, 1);
}

QLayout* StudyDock::choosing()
{
    auto* choose = new FlowLayout;
    choose->setSpacing(8);
    for (QWidget* sentence : finder_->sentences()) choose->addWidget(sentence);
    auto* set = new QToolButton(this);
    set->setText(tr("Settings"));
    set->setCheckable(true);
    set->setAccessibleName(tr("Show the settings of studies"));
    set->setToolTip(tr("Shows everything that can be set for a study: metric, views, size, values and more."));
    connect(set, &QToolButton::toggled, settings_, &QWidget::setVisible);
    for (QToolButton* button : {set, copy_, save_, list_}) {
        button->setFocusPolicy(Qt::StrongFocus);
        growHeight(*button, 26);
        choose->addWidget(button);
    }
    return choose;
}

QWidget* StudyDock::studies()
{
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(kept_);
    split->addWidget(shown_);
    split->addWidget(settings_);
    split->setStretchFactor(0, 0);
    split->setStretchFactor(1, 1);
    split->setStretchFactor(2, 0);
    split->setChildrenCollapsible(false);
    split->setSizes({260, 740, 360});
    kept_->hide();
    settings_->hide();
    return split;
}

void StudyDock::connectParts()
{
    connect(go_, &QPushButton::clicked, this, [this] { running() ? stop() : measurePresent(); });
    connect(finder_, &StudyFinder::asked, this, &StudyDock::find);
    connect(finder_, &StudyFinder::refused, shown_, &StudyView::say);
    connect(parameter_, &QComboBox::activated, this, [this] { vary(parameter_->currentData().toString()); });
    connect(&setup_, &JobSetup::changed, this, &StudyDock::showVaried);
    connect(copy_, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(QString::fromUtf8(exported(QStringLiteral("csv")))); });
    connect(save_, &QToolButton::clicked, this, &StudyDock::save);
    connect(list_, &QToolButton::toggled, kept_, &QWidget::setVisible);
    connect(kept_, &KeptStudies::failed, this, &StudyDock::failed);
    connect(kept_, &KeptStudies::showAsked, this, [this](const KeptStudy& study, const std::string& json) {
        shown_->showKept(study, json, kept_->titleOf(study));
        showIdle();
    });
    connect(kept_, &KeptStudies::picturesRead, shown_, &StudyView::showKeptPictures);
    connect(shown_, &StudyView::refused, this, &StudyDock::failed);
    connect(&history_, &History::replaced, this, [this] {
        if (table_ && !table_->hasParametersOf(history_.sceneState().values[subject_].table())) setSubject(subject_);
    });
}

StudyDock::~StudyDock()
{
    stop();
    setup_.remember();
}

StudyChart& StudyDock::chart() const
{
    return shown_->chart();
}

const StudyResult& StudyDock::result() const
{
    return shown_->result();
}

void StudyDock::setSubject(std::size_t exhibit)
{
    const bool isNew = !table_ || exhibit != subject_;
    subject_ = exhibit;
    table_ = history_.sceneState().values[exhibit].sharedTable();
    parameter_->clear();
    parameter_->addItem(tr("All parameters together"), QString());
    std::vector<std::string> names;
    for (const ParameterInfo& parameter : table_->rows()) {
        if (!parameter.qualityReference) continue;
        names.emplace_back(parameter.name);
        parameter_->addItem(translatedText(label(parameter)), text(parameter.name));
    }
    settings_->setOffers({{"parameters", names}});
    showVaried();
    if (isNew || parameter_->currentIndex() < 0) vary(parameter_->itemData(names.empty() ? 0 : 1).toString());
    go_->setEnabled(running() || !names.empty());
}

void StudyDock::vary(const QString& parameters)
{
    const StudyTable& t = studyTable();
    ParameterValues values = setup_.values();
    values.set(t.varied, parameters.toStdString());
    values.set(t.values, std::string());  // The old values belong to another parameter.
    if (!(values == setup_.values())) setup_.change(tr("What to measure"), values);
    showVaried();
}

void StudyDock::showVaried()
{
    parameter_->setCurrentIndex(parameter_->findData(QString::fromStdString(setup_.values()[studyTable().varied])));
}

void StudyDock::ask(std::size_t exhibit, std::size_t row)
{
    if (exhibit != subject_) setSubject(exhibit);
    vary(text(table_->rows()[row].name));
    measurePresent();
}

void StudyDock::offerBoth(const SettingsB& other)
{
    measuring_->insertWidget(2, new BothSettingsButton(*this, other, this));
}

void StudyDock::measurePresent()
{
    measure(setup_.values(), history_.sceneState());
}

void StudyDock::measureWith(const SceneState& sceneState)
{
    measure(setup_.values(), sceneState);
}

void StudyDock::measure(const ParameterValues& values, const SceneState& sceneState)
{
    try {
        StudyRequest request = studyRequest(values, museum_, sceneState, subject_);
        request.largestTile = shortTile;
        start(std::move(request));
    } catch (const Failure& failure) {
        shown_->say(messageOf(failure));
    }
}

void StudyDock::find(StudyFind wanted, double limit)
{
    const StudyTable& t = studyTable();
    ParameterValues values = setup_.values();
    for (const Text& parameter : {t.varied, t.values}) values.set(parameter, std::string());
    values.set(t.choosing, wanted);
    values.set(wanted == StudyFind::cheapest ? t.maxError : t.maxMilliseconds, limit);
    values.set(t.modelError, false);
    measure(values, history_.sceneState());
}

struct StudyDock::Work {
    Renderers& renderers;
    StudyRequest request;
    StudyJob job;
    QElapsedTimer shown;
};

bool StudyDock::step(Work& work, const RenderThread::Notify& notify,
                     const std::function<void(std::shared_ptr<Progress>)>& take)
{
    if (!work.job.study) {
        work.job = work.renderers.makeStudy(work.request);
        work.shown.start();
        if (!work.job.study) throw Failure(ErrorKind::openGl, "Nothing can be measured: there is no graphics context.");
    }
    Study& study = *work.job.study;
    study.step();
    const bool done = study.finished();
    if (done || work.shown.elapsed() >= refreshTime) {
        auto progress =
            std::make_shared<Progress>(Progress{done ? study.takeResult() : study.result(),
                                                done ? 1.0 : study.progress(), study.doing(), work.job.machine});
        notify([take, progress = std::move(progress)] { take(progress); });
        work.shown.start();
    }
    if (done) {
        work.job = {};
        render::trimHeap();
    }
    return !done;
}

void StudyDock::start(StudyRequest request)
{
    stop();
    running_ = request;
    isRunning_ = true;
    auto work = std::make_shared<Work>(Work{renderers_, std::move(request), {}, {}});
    go_->setText(tr("Cancel"));
    go_->setEnabled(true);
    progress_->setValue(0);
    progress_->show();
    elapsed_.start();
    doing_->setText(tr("Starting"));
    const auto take = [this](const std::shared_ptr<Progress>& progress) { this->take(std::move(*progress)); };
    task_ = thread_.start([work, take](const RenderThread::Notify& notify) { return step(*work, notify, take); },
                          [this](const QString& failure) { end(failure); });
}

void StudyDock::take(Progress progress)
{
    const bool done = progress.progress >= 1;
    // The earlier result stays until the new one has a point.
    const bool isNew =
        !showsRunning_ && (done || std::any_of(progress.result.points.begin(), progress.result.points.end(), isDrawn));
    showsRunning_ = showsRunning_ || isNew;
    progress_->setValue(static_cast<int>(100 * progress.progress));
    const double left = secondsLeft(progress.progress, elapsed_);
    doing_->setText(translatedText(progress.doing) +
                    (left >= 0 && !done ? QStringLiteral(", ") + timeLeft(left) : QString()));
    if (!showsRunning_) return;
    shown_->showMeasured(running_, std::move(progress.result), progress.machine, isNew);
}

void StudyDock::end(const QString& failure)
{
    const bool succeeded = failure.isEmpty();
    endRun();
    if (!succeeded) emit stopped();
    if (!failure.isEmpty()) {
        shown_->say(failure);
        emit failed(failure);
        return;
    }
    const std::optional<StudyChoice> choice = result().choice;
    if (choice && choice->holds) shown_->applyMeasured(choice->point);
    emit finished();
}

void StudyDock::stop()
{
    const bool ran = running();
    endRun();
    if (ran) emit stopped();
}

void StudyDock::endRun()
{
    task_.cancel();
    if (showsRunning_) {
        shown_->noteStopped();
        keepMeasured();
    }
    isRunning_ = false;
    showsRunning_ = false;
    showIdle();
}

void StudyDock::keepMeasured()
{
    const auto& points = result().points;
    const auto measured = std::count_if(points.begin(), points.end(), isDrawn);
    if (result().complete || measured >= leastToKeep)
        kept_->keep(shown_->json(), result().complete, contactSheet(result()));
}

void StudyDock::showIdle()
{
    go_->setText(running() ? tr("Cancel") : tr("Measure"));
    go_->setEnabled(running() || parameter_->count() > 1);
    progress_->setVisible(running());
    if (!running()) doing_->clear();
    for (QToolButton* button : {copy_, save_}) button->setEnabled(!shown_->empty());
    finder_->suggestTime(result());
    if (shown_->empty())
        shown_->say(tr("Choose a parameter, then Measure. Errors are against its most exact value; costs are time and "
                       "counted work."));
}

QByteArray StudyDock::exported(const QString& suffix) const
{
    return shown_->exported(suffix);
}

void StudyDock::save()
{
    const QString why = askAndSaveStudy(this, [this](const QString& suffix) { return exported(suffix); });
    if (!why.isEmpty()) emit failed(why);
}

}  // namespace vitrine::ui

#include "moc_study_dock.cpp"

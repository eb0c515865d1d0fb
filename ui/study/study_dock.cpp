#include "ui/study/study_dock.h"

#include "exhibits/jobs.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "ui/kit/flow_layout.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/study/both_settings_button.h"
#include "ui/study/kept_studies.h"
#include "ui/study/measuring_bar.h"
#include "ui/study/study_export.h"
#include "ui/study/study_finder.h"
#include "ui/study/study_view.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QSplitter>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int shortTile = 96;   ///< Pixels, so that no step delays the next picture of the viewport for long.
constexpr int leastToKeep = 3;  ///< Number of measured settings from which a stopped study is kept.

}  // namespace

StudyDock::StudyDock(const Museum& museum, Renderers& renderers, History& history, RenderThread& thread,
                     study::StudyStore store, QWidget* parent)
    : QWidget(parent), museum_(museum), history_(history), measurement_(renderers, thread, this),
      setup_(*jobs::findJob("study"), this),
      bar_(new MeasuringBar(this)), keepers_{new QToolButton(this), new QToolButton(this), new QToolButton(this)},
      list_(new QToolButton(this)), finder_(new StudyFinder(this)), shown_(new StudyView(museum, history, this)),
      kept_(new KeptStudies(museum.subjects(), history, std::move(store), this)),
      settings_(new ParameterPanel(setup_.history(), this))
{
    setTexts();
    settings_->showExhibit(0, QStringLiteral("study"));
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 8, 8, 8);
    all->setSpacing(8);
    all->addWidget(bar_);
    all->addLayout(choosing());
    all->addWidget(studies(), 1);
    connectParts();
    setup_.recall();
    showIdle();
}

void StudyDock::setTexts()
{
    const auto& [copy, save, figure] = keepers_;
    copy->setText(tr("Copy"));
    copy->setAccessibleName(tr("Copy the measurements"));
    copy->setToolTip(tr("Copies what was measured as a table (CSV)."));
    save->setText(tr("Save…"));
    save->setAccessibleName(tr("Save the measurements"));
    save->setToolTip(tr("Saves what was measured as a table (CSV) or JSON, or the chart as PNG, SVG or PDF."));
    figure->setText(tr("Save figure"));
    figure->setAccessibleName(tr("Save the chart as a figure"));
    figure->setToolTip(tr("Saves the chart as SVG in your pictures folder, under a free name."));
    list_->setText(tr("History"));
    list_->setCheckable(true);
    list_->setAccessibleName(tr("Show the history of studies"));
    list_->setToolTip(
        tr("Shows the studies that were kept: to look at again, compare, rename, delete, open and save."));
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
    const auto& [copy, save, figure] = keepers_;
    for (QToolButton* button : {set, copy, save, figure, list_}) {
        button->setFocusPolicy(Qt::StrongFocus);
        growHeight(*button, 26);
        if (button != figure) choose->addWidget(button);
    }
    bar_->insert(figure);
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
    connect(bar_, &MeasuringBar::goAsked, this, [this] { running() ? stop() : measurePresent(); });
    connect(bar_, &MeasuringBar::parameterChosen, this, &StudyDock::vary);
    connect(&measurement_, &StudyMeasurement::progressed, this,
            [this](const std::shared_ptr<StudyProgress>& progress) { take(*progress); });
    connect(&measurement_, &StudyMeasurement::ended, this, &StudyDock::end);
    connect(finder_, &StudyFinder::asked, this, &StudyDock::find);
    connect(finder_, &StudyFinder::refused, shown_, &StudyView::say);
    connect(&setup_, &JobSetup::changed, this, &StudyDock::showVaried);
    const auto& [copy, save, figure] = keepers_;
    connect(copy, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(QString::fromUtf8(exported(QStringLiteral("csv")))); });
    connect(save, &QToolButton::clicked, this, &StudyDock::save);
    connect(figure, &QToolButton::clicked, this, &StudyDock::saveFigure);
    connect(list_, &QToolButton::toggled, kept_, &QWidget::setVisible);
    connect(kept_, &KeptStudies::failed, this, &StudyDock::failed);
    connect(kept_, &KeptStudies::showAsked, this, [this](const study::KeptStudy& study, const std::string& json) {
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

const study::StudyResult& StudyDock::result() const
{
    return shown_->result();
}

void StudyDock::setSubject(std::size_t exhibit)
{
    const bool isNew = !table_ || exhibit != subject_;
    subject_ = exhibit;
    table_ = history_.sceneState().values[exhibit].sharedTable();
    std::vector<std::string> names;
    std::vector<std::pair<QString, QString>> offers;
    for (const ParameterInfo& parameter : table_->rows()) {
        if (!parameter.qualityReference) continue;
        names.emplace_back(parameter.name);
        offers.emplace_back(translatedText(label(parameter)), text(parameter.name));
    }
    bar_->setParameters(offers);
    settings_->setOffers({{"parameters", names}});
    showVaried();
    if (isNew || !bar_->hasSelection()) vary(offers.empty() ? QString() : offers.front().second);
    bar_->showIdle(running());
}

void StudyDock::vary(const QString& parameters)
{
    const study::StudyTable& t = study::studyTable();
    ParameterValues values = setup_.values();
    values.set(t.varied, parameters.toStdString());
    values.set(t.values, std::string());  // The old values belong to another parameter.
    if (!(values == setup_.values())) setup_.change(tr("What to measure"), values);
    showVaried();
}

void StudyDock::showVaried()
{
    bar_->select(QString::fromStdString(setup_.values()[study::studyTable().varied]));
}

void StudyDock::ask(std::size_t exhibit, std::size_t row, Then then)
{
    if (exhibit != subject_) setSubject(exhibit);
    vary(text(table_->rows()[row].name));
    measurePresent();
    then_ = running() ? then : Then::nothing;
}

void StudyDock::offerBoth(const SettingsB& other)
{
    bar_->insert(new BothSettingsButton(*this, other, this));
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
        study::StudyRequest request = study::studyRequest(values, museum_, sceneState, subject_);
        request.largestTile = shortTile;
        stop();
        measurement_.start(std::move(request));
        bar_->showStart();
    } catch (const Failure& failure) {
        shown_->say(messageOf(failure));
    }
}

void StudyDock::find(study::StudyFind wanted, double limit)
{
    const study::StudyTable& t = study::studyTable();
    ParameterValues values = setup_.values();
    for (const Text& parameter : {t.varied, t.values}) values.set(parameter, std::string());
    values.set(t.choosing, wanted);
    values.set(wanted == study::StudyFind::cheapest ? t.maxError : t.maxMilliseconds, limit);
    values.set(t.modelError, false);
    measure(values, history_.sceneState());
}

void StudyDock::take(StudyProgress& progress)
{
    const bool done = progress.part >= 1;
    // The earlier result stays until the new one has a point.
    const bool isNew = !showsRunning_ && (done || std::any_of(progress.result.points.begin(),
                                                              progress.result.points.end(), study::isDrawn));
    showsRunning_ = showsRunning_ || isNew;
    bar_->showProgress(progress.part, translatedText(progress.doing));
    if (!showsRunning_) return;
    shown_->showMeasured(measurement_.request(), std::move(progress.result), progress.machine, isNew);
}

void StudyDock::end(const QString& failure)
{
    const bool succeeded = failure.isEmpty();
    const Then then = then_;
    endRun();
    if (!succeeded) emit stopped();
    if (!failure.isEmpty()) {
        shown_->say(failure);
        emit failed(failure);
        return;
    }
    const std::optional<study::StudyChoice> choice = result().choice;
    if (choice && choice->holds) shown_->applyMeasured(choice->point);
    if (then == Then::saveFigure) saveFigure();
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
    measurement_.cancel();
    if (showsRunning_) {
        shown_->noteStopped();
        keepMeasured();
    }
    showsRunning_ = false;
    then_ = Then::nothing;
    showIdle();
}

void StudyDock::keepMeasured()
{
    const auto& points = result().points;
    const auto measured = std::count_if(points.begin(), points.end(), study::isDrawn);
    if (result().complete || measured >= leastToKeep)
        kept_->keep(shown_->json(), result().complete, study::contactSheet(result()));
}

void StudyDock::showIdle()
{
    bar_->showIdle(running());
    for (QToolButton* button : keepers_) button->setEnabled(!shown_->empty());
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

void StudyDock::saveFigure()
{
    const QDir pictures(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    const QString first = pictures.filePath(shown_->fileName() + QStringLiteral(".svg"));
    const QString file = QFileInfo::exists(first) ? nextFreePath(first) : first;
    try {
        render::atomicWrite(file.toStdString(), exported(QStringLiteral("svg")).toStdString());
        emit saved(file);
    } catch (const Failure& failure) {
        emit failed(messageOf(failure));
    }
}

}  // namespace vitrine::ui

#include "moc_study_dock.cpp"

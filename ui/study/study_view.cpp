#include "ui/study/study_view.h"

#include "exhibits/museum/museum.h"
#include "exhibits/study/study_situation.h"
#include "exhibits/study/study_text.h"
#include "render/measure/distance.h"
#include "ui/kit/language.h"
#include "ui/kit/picture_file.h"
#include "ui/kit/text.h"
#include "ui/model/history.h"
#include "ui/study/large_pictures.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_export.h"
#include "ui/study/study_pictures.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace vitrine::ui {
namespace {

QString shortNumber(double x)
{
    return QLocale::c().toString(x, 'g', 3);
}

QString timesText(double median, double low, double high)
{
    return StudyView::tr(", %1 ms (%2 to %3)").arg(shortNumber(median), shortNumber(low), shortNumber(high));
}

/// Formats a counter; empty if there is no such counter.
template <typename Count> QString workText(const std::map<std::string, Count>& counters, const std::string& name)
{
    const auto found = counters.find(name);
    if (found == counters.end()) return {};
    return StudyView::tr(", %1 %2").arg(QLocale::c().toString(static_cast<qlonglong>(found->second)),
                                        translatedText(costTitle(name)));
}

}  // namespace

StudyView::StudyView(const Museum& museum, History& history, QWidget* parent)
    : QWidget(parent), museum_(museum), history_(history), cost_(new QComboBox(this)), right_(new QWidget(this)),
      view_(new QComboBox(this)), words_(new QLabel(this)), caption_(new QLabel(this)), chart_(new StudyChart(this)),
      pictures_(new StudyPictures(this))
{
    cost_->setObjectName(QStringLiteral("cost"));
    view_->setObjectName(QStringLiteral("view"));
    cost_->setAccessibleName(tr("Costs of the chart"));
    cost_->setToolTip(
        tr("Quantity on the lower axis of the chart: time, or counted work, which is the same on every machine."));
    cost_->addItem(tr("Milliseconds"));
    cost_->addItem(tr("Counted work"));
    view_->setAccessibleName(tr("View"));
    // Long names must not widen the window.
    view_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    view_->setMinimumContentsLength(14);
    for (QLabel* label : {words_, caption_}) {
        label->setTextFormat(Qt::PlainText);
        label->setMinimumWidth(40);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        label->setWordWrap(true);
    }
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layOut();
    connectParts();
    hidePictures();
    showCaption({});
}

void StudyView::layOut()
{
    auto* column = new QVBoxLayout(right_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* views = new QWidget(right_);  // Hidden and shown with its label.
    auto* inRow = new QHBoxLayout(views);
    auto* label = new QLabel(tr("&View:"), views);
    label->setBuddy(view_);
    inRow->setContentsMargins(0, 0, 0, 0);
    inRow->addWidget(label);
    inRow->addWidget(view_, 1);
    column->addWidget(views);
    column->addWidget(pictures_, 1);
    column->addWidget(caption_);
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(chartWithCosts());
    split->addWidget(right_);
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 1);
    split->setChildrenCollapsible(false);
    split->setSizes({500, 500});
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(8);
    all->addWidget(split, 1);
    all->addWidget(words_);
}

QWidget* StudyView::chartWithCosts()
{
    auto* left = new QWidget(this);
    auto* label = new QLabel(tr("&Cost:"), left);
    label->setBuddy(cost_);
    auto* top = new QHBoxLayout;
    top->setSpacing(8);
    top->addWidget(label);
    top->addWidget(cost_);
    top->addStretch(1);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(top);
    column->addWidget(chart_, 1);
    return left;
}

CostAxis StudyView::costAxis() const
{
    return cost_->currentIndex() == 0 ? CostAxis::time : CostAxis::work;
}

void StudyView::chooseCostAxis(CostAxis axis)
{
    costChosen_ = true;
    cost_->setCurrentIndex(axis == CostAxis::time ? 0 : 1);
}

void StudyView::decideCostAxis(bool clockTrusted)
{
    if (costChosen_) return;
    const QSignalBlocker quiet(cost_);
    cost_->setCurrentIndex(usualCostAxis(clockTrusted) == CostAxis::time ? 0 : 1);
}

void StudyView::connectParts()
{
    connect(cost_, &QComboBox::activated, this, [this] { costChosen_ = true; });
    connect(cost_, &QComboBox::currentIndexChanged, this, &StudyView::refresh);
    connect(view_, &QComboBox::currentIndexChanged, this, [this] { showPoint(shownPoint_); });
    connect(pictures_, &StudyPictures::enlargeAsked, this, &StudyView::enlarge);
    connect(chart_, &StudyChart::hovered, this, [this](int point) { showPoint(point); });
    connect(chart_, &StudyChart::chosen, this, [this](int point) { apply(static_cast<std::size_t>(point)); });
    connect(&history_, &History::changesSettled, this, [this] {
        if (isVisible()) refresh();
    });
}

void StudyView::showEvent(QShowEvent* event)
{
    refresh();
    QWidget::showEvent(event);
}

void StudyView::showMeasured(const StudyRequest& request, StudyResult result, const render::Json& machine, bool isNew)
{
    if (isNew) {
        kept_.reset();
        request_ = request;
        shownPoint_ = -1;
        stopped_ = false;
        const QSignalBlocker quiet(view_);
        view_->clear();
        for (const std::string& view : result.views) view_->addItem(translatedText(view));
        decideCostAxis(result.clockTrusted);
    }
    machine_ = machine;
    result_ = std::move(result);
    if (kept_) return;  // A kept study is shown at the moment.
    refresh();
}

void StudyView::showKept(KeptStudy study, std::string json, const QString& title)
{
    keptJson_ = std::move(json);
    keptTitle_ = title;
    shownPoint_ = -1;
    const QSignalBlocker quiet(view_);
    view_->clear();
    for (const std::string& view : study.views) view_->addItem(translatedText(view));
    const bool timed = std::any_of(study.points.begin(), study.points.end(),
                                   [](const KeptPoint& point) { return point.time.has_value(); });
    decideCostAxis(study.clockTrusted && timed);
    kept_ = std::move(study);
    keptPictures_ = {};
    refresh();
}

void StudyView::showKeptPictures(const ContactSheet& sheet)
{
    if (!kept_ || sheet.points != kept_->points.size() || sheet.views != kept_->views.size()) return;
    keptPictures_ = sheet;
    showPoint(shownPoint_);
}

void StudyView::noteStopped()
{
    if (result_.complete || result_.points.empty()) return;
    stopped_ = true;
    if (result_.workName.empty()) {
        std::vector<std::map<std::string, double>> counters;
        for (const StudyPoint& point : result_.points)
            if (isDrawn(point)) counters.emplace_back(point.counters.begin(), point.counters.end());
        result_.workName = mostTellingCounter(counters);
    }
    if (!kept_) refresh();
}

void StudyView::say(const QString& words)
{
    words_->setText(words);
    words_->setToolTip(words);
}

render::Json StudyView::json() const
{
    return studyJson(museum_.subjects(), request_, result_, machine_);
}

QByteArray StudyView::exported(const QString& suffix) const
{
    if (kept_ && suffix == QLatin1String("csv")) return QByteArray::fromStdString(keptCsv({*kept_}));
    if (kept_ && suffix == QLatin1String("json")) return QByteArray::fromStdString(keptJson_);
    return studyFile(suffix, museum_.subjects(), request_, result_, machine_, *chart_);
}

std::optional<std::size_t> StudyView::rowNow(const StudyAxis& axis) const
{
    return history_.sceneState().values[axis.subject].table().find(parameterOf(request_.sceneState, axis).name);
}

std::optional<std::size_t> StudyView::presentPoint() const
{
    const SceneState& sceneState = history_.sceneState();
    for (std::size_t i = 0; i < result_.points.size(); ++i) {
        bool same = true;
        for (std::size_t a = 0; a < request_.axes.size(); ++a) {
            const StudyAxis& axis = request_.axes[a];
            const std::optional<std::size_t> row = rowNow(axis);
            same = same && row &&
                   sceneState.values[axis.subject].row(*row) == Value(axis.values[result_.points[i].setting[a]]);
        }
        if (same) return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> StudyView::presentKeptPoint() const
{
    if (!keptParameters_.all()) return std::nullopt;
    const SceneState& sceneState = history_.sceneState();
    for (std::size_t i = 0; i < kept_->points.size(); ++i) {
        std::string wrong;
        const std::optional<std::vector<Value>> values = valuesOf(*kept_, i, keptParameters_, sceneState, wrong);
        bool same = values.has_value();
        for (std::size_t r = 0; same && r < values->size(); ++r)
            same = sceneState.values[keptParameters_.rows[r].subject].row(keptParameters_.rows[r].row) == (*values)[r];
        if (same) return i;
    }
    return std::nullopt;
}

QString StudyView::sentences(const QString& law) const
{
    QStringList sentences{law};
    for (const std::string& sentence : {choiceSentence(museum_.subjects(), request_, result_), result_.convergence})
        sentences << translatedText(sentence);
    for (const std::string& sentence : situationSentences(museum_.subjects(), request_, result_, ParameterNames::shown))
        sentences << translatedText(sentence);
    sentences.removeAll(QString());
    sentences << tr("Clock: %1, %2.")
                     .arg(translatedText(result_.clock), result_.clockTrusted ? tr("trusted") : tr("not trusted"));
    return sentences.join(QLatin1Char(' '));
}

void StudyView::showChart(ChartedStudy study, std::optional<std::size_t> present)
{
    for (std::size_t i = 0; i < study.points.size(); ++i) study.points[i].present = present == i;
    chart_->showStudy(std::move(study));
}

void StudyView::refresh()
{
    if (kept_) return refreshKept();
    if (request_.axes.empty()) return;
    ChartedStudy study = charted(museum_.subjects(), request_, result_, costAxis());
    if (stopped_ && costAxis() == CostAxis::time)
        study.emptyText = tr("The study was stopped before its settings were timed.");
    const QString law = study.law;
    showChart(std::move(study), presentPoint());
    showPoint(shownPoint_);
    if (!result_.clock.empty()) say(sentences(law));
}

QString StudyView::whyNotApplied() const
{
    if (!keptParameters_.missingExhibit.empty())
        return tr("There is no exhibit “%1” here, so its numbers are shown, but cannot be applied.")
            .arg(QString::fromStdString(keptParameters_.missingExhibit));
    if (!keptParameters_.missingParameter.empty())
        return tr("There is no parameter “%1” now, so its numbers are shown, but cannot be applied.")
            .arg(QString::fromStdString(keptParameters_.missingParameter));
    return {};
}

void StudyView::refreshKept()
{
    keptParameters_ = parametersOf(*kept_, museum_.subjects(), history_.sceneState());
    ChartedStudy study = charted(*kept_, keptTitle_, costAxis());
    QStringList sentences{tr("From the history: %1.").arg(keptTitle_), whyNotApplied(), study.law};
    showChart(std::move(study), presentKeptPoint());
    showPoint(shownPoint_);
    for (const std::string& sentence : kept_->sentences) sentences << translatedText(sentence);
    sentences << tr("Clock: %1, %2.")
                     .arg(translatedText(kept_->clock), kept_->clockTrusted ? tr("trusted") : tr("not trusted"));
    sentences.removeAll(QString());
    say(sentences.join(QLatin1Char(' ')));
}

void StudyView::showCaption(const QString& caption)
{
    caption_->setText(caption);
    caption_->setToolTip(caption);
    right_->setVisible(!caption.isEmpty());
}

void StudyView::hidePictures()
{
    shown_ = {};
    pictures_->show({}, {}, {});
    pictures_->hide();
    view_->parentWidget()->hide();
}

QString StudyView::captionOf(const KeptStudy& study, std::size_t point) const
{
    const KeptPoint& p = study.points[point];
    if (!p.measured()) return tr("%1 was not measured.").arg(settingWords(study.settingParts(point)));
    QString text = tr("%1: error %2").arg(settingWords(study.settingParts(point)), shortNumber(p.error));
    if (p.time) text += timesText(p.time->median, p.time->interval.low, p.time->interval.high);
    text += workText(p.counters, costsAlong(CostAxis::work, study).name);
    if (p.modelError) text += tr("; against everything exact %1").arg(shortNumber(*p.modelError));
    return keptPictures_.empty() ? tr("%1. Its pictures were not kept.").arg(text) : text;
}

QString StudyView::captionOf(const StudyPoint& p) const
{
    const QString setting = settingWords(settingParts(museum_.subjects(), request_, p));
    if (!isDrawn(p)) return tr("%1 is not measured yet.").arg(setting);
    QString text = tr("%1: error %2").arg(setting, shortNumber(p.error));
    if (p.time) text += timesText(p.time->median, p.time->interval.low, p.time->interval.high);
    text += workText(p.counters, result_.workName);
    if (p.modelError) text += tr("; against everything exact %1").arg(shortNumber(*p.modelError));
    return text;
}

void StudyView::showKeptPoint(int wanted)
{
    const std::optional<std::size_t> present = presentKeptPoint();
    const std::optional<std::size_t> fallback = present ? present : costsAlong(costAxis(), *kept_).knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    const bool is = point >= 0 && static_cast<std::size_t>(point) < kept_->points.size();
    const auto at = static_cast<std::size_t>(std::max(point, 0));
    const auto view = static_cast<std::size_t>(std::max(view_->currentIndex(), 0));
    if (is && view < keptPictures_.views && kept_->points[at].measured()) {
        showPictures(keptPictures_.picture(at, view), keptPictures_.reference(view), kept_->metric);
    } else {
        hidePictures();
    }
    const QString none = keptPictures_.empty() ? tr("Its pictures were not kept.") : QString();
    showCaption(is ? captionOf(*kept_, at) : none);
    fillLarge();
}

void StudyView::showPoint(int wanted)
{
    shownPoint_ = wanted;
    chart_->emphasize(wanted >= 0 ? std::optional(static_cast<std::size_t>(wanted)) : std::nullopt);
    if (kept_) return showKeptPoint(wanted);
    const std::optional<std::size_t> present = presentPoint();
    // Without a hovered point: the present setting, or else the knee.
    const std::optional<std::size_t> fallback = present ? present : costsAlong(costAxis(), request_, result_).knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    const auto view = static_cast<std::size_t>(std::max(view_->currentIndex(), 0));
    if (point < 0 || static_cast<std::size_t>(point) >= result_.points.size() || view >= result_.references.size()) {
        hidePictures();
        showCaption({});
    } else {
        const StudyPoint& p = result_.points[static_cast<std::size_t>(point)];
        if (isDrawn(p))
            showPictures(p.shots[view].picture, result_.references[view], request_.metric);
        else
            hidePictures();
        showCaption(captionOf(p));
    }
    fillLarge();
}

void StudyView::showPictures(render::Image picture, render::Image reference, render::Metric metric)
{
    shown_.picture = std::move(picture);
    shown_.reference = std::move(reference);
    shown_.errors = render::errorMap(metric, shown_.reference, shown_.picture)
                        .value_or(render::differenceMap(shown_.reference, shown_.picture));
    const bool differ =
        std::any_of(shown_.errors.pixels.begin(), shown_.errors.pixels.end(), [](float error) { return error > 0; });
    if (!differ) shown_.errors = {};  // A black heat map shows nothing, so it is left out.
    shown_.full = differ ? render::fullScale(metric, shown_.errors) : 1;
    shownScale_ =
        differ
            ? tr("The heat map ranges from 0 to %1 (%2).").arg(shortNumber(shown_.full), translatedText(title(metric)))
            : noPixelDiffers();
    pictures_->show(screenImage(shown_.picture), screenImage(shown_.reference),
                    differ ? screenImage(render::heatMap(shown_.errors, shown_.full)) : QImage(),
                    differ ? shortNumber(shown_.full) : QString());
    pictures_->setVisible(true);
    view_->parentWidget()->setVisible(true);
    pictures_->setAccessibleDescription(
        tr("Left of the line the setting, right of it the reference; arrows move the line, Enter opens a large view.") +
        QLatin1Char(' ') + shownScale_);
}

void StudyView::enlarge()
{
    if (shown_.picture.empty()) return;
    if (!large_) {
        large_ = new LargePictures(window());
        connect(large_, &LargePictures::viewChosen, view_, &QComboBox::setCurrentIndex);
    }
    large_->show();
    fillLarge();
    large_->raise();
    large_->activateWindow();
}

void StudyView::fillLarge()
{
    if (!large_ || !large_->isVisible()) return;
    QStringList views;
    for (int i = 0; i < view_->count(); ++i) views << view_->itemText(i);
    large_->setViews(views, view_->currentIndex());
    large_->setPictures(shown_, caption_->text(), shown_.picture.empty() ? QString() : shownScale_);
}

void StudyView::apply(std::size_t point)
{
    kept_ ? applyKept(point) : applyMeasured(point);
}

void StudyView::applyMeasured(std::size_t point)
{
    if (point >= result_.points.size()) return;
    SceneState next = history_.sceneState();
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        const StudyAxis& axis = request_.axes[a];
        if (const auto row = rowNow(axis))
            next.values[axis.subject].setParameter(*row, axis.values[result_.points[point].setting[a]]);
    }
    const bool one = request_.axes.size() == 1;
    history_.change(
        one ? tr("Set %1").arg(settingWords(settingParts(museum_.subjects(), request_, result_.points[point])))
            : tr("Set what the study found"),
        next);
}

void StudyView::applyKept(std::size_t point)
{
    if (point >= kept_->points.size()) return;
    if (const QString why = whyNotApplied(); !why.isEmpty()) {
        emit refused(why);
        return;
    }
    SceneState next = history_.sceneState();
    std::string wrong;
    const std::optional<std::vector<Value>> values = valuesOf(*kept_, point, keptParameters_, next, wrong);
    if (!values) {
        emit refused(tr("This setting was not applied: the parameter no longer accepts its value of “%1”.")
                         .arg(translatedText(wrong)));
        return;
    }
    for (std::size_t i = 0; i < values->size(); ++i)
        next.values[keptParameters_.rows[i].subject].setParameter(keptParameters_.rows[i].row, (*values)[i]);
    history_.change(values->size() == 1 ? tr("Set %1").arg(settingWords(kept_->settingParts(point)))
                                        : tr("Set what the study found"),
                    next);
}

}  // namespace vitrine::ui

#include "moc_study_view.cpp"

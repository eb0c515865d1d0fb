#include "ui/study/study_view.h"

#include "exhibits/museum/museum.h"
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
#include <QLabel>
#include <QLocale>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

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

QString workText(double cost, const std::string& name)
{
    return StudyView::tr(", %1 %2").arg(QLocale::c().toString(static_cast<qlonglong>(cost)), said(costTitle(name)));
}

}  // namespace

StudyView::StudyView(const Museum& museum, History& history, QWidget* parent)
    : QWidget(parent), museum_(museum), history_(history), view_(new QComboBox(this)), words_(new QLabel(this)),
      caption_(new QLabel(this)), chart_(new StudyChart(this)), pictures_(new StudyPictures(this))
{
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
}

void StudyView::layOut()
{
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(view_);
    column->addWidget(pictures_, 1);
    column->addWidget(caption_);
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(chart_);
    split->addWidget(right);
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

void StudyView::connectParts()
{
    connect(view_, &QComboBox::currentIndexChanged, this, [this] { showPoint(shownPoint_); });
    connect(pictures_, &StudyPictures::enlargeAsked, this, &StudyView::enlarge);
    connect(chart_, &StudyChart::hovered, this, [this](int point) { showPoint(point); });
    connect(chart_, &StudyChart::chosen, this, [this](int point) { apply(static_cast<std::size_t>(point)); });
    const auto refreshWhileSeen = [this] {
        if (isVisible()) refresh();
    };
    connect(&history_, &History::changed, this, refreshWhileSeen);
    connect(&history_, &History::replaced, this, refreshWhileSeen);
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
        const QSignalBlocker quiet(view_);
        view_->clear();
        for (const std::string& view : result.views) view_->addItem(said(view));
    }
    machine_ = machine;
    result_ = std::move(result);
    if (kept_) return;  // The visitor looks at another one meanwhile.
    refresh();
}

void StudyView::showKept(KeptStudy study, std::string json, const QString& title)
{
    keptJson_ = std::move(json);
    keptTitle_ = title;
    shownPoint_ = -1;
    const QSignalBlocker quiet(view_);
    view_->clear();
    for (const std::string& view : study.views) view_->addItem(said(view));
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
    return history_.sceneState().values[axis.subject].table().find(rowOf(request_.sceneState, axis).name);
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
    if (!keptRows_.all()) return std::nullopt;
    const SceneState& sceneState = history_.sceneState();
    for (std::size_t i = 0; i < kept_->points.size(); ++i) {
        std::string wrong;
        const std::optional<std::vector<Value>> values = valuesOf(*kept_, i, keptRows_, sceneState, wrong);
        bool same = values.has_value();
        for (std::size_t r = 0; same && r < values->size(); ++r)
            same = sceneState.values[keptRows_.rows[r].subject].row(keptRows_.rows[r].row) == (*values)[r];
        if (same) return i;
    }
    return std::nullopt;
}

QString StudyView::sentences() const
{
    QStringList sentences;
    for (const std::string& sentence :
         {lawSentence(result_), choiceSentence(museum_.subjects(), request_, result_), result_.convergence})
        if (!sentence.empty()) sentences << said(sentence);
    sentences
        << tr("Clock: %1, %2.").arg(said(result_.clock), result_.clockTrusted ? tr("trusted") : tr("not trusted"));
    return sentences.join(QLatin1Char('\n'));
}

void StudyView::refresh()
{
    if (kept_) return refreshKept();
    if (request_.axes.empty()) return;
    const std::optional<std::size_t> present = presentPoint();
    std::vector<ChartPoint> points = chartPoints(museum_.subjects(), request_, result_);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].present = present == i;
    chart_->setTitles(studyCostTitle(result_.costName), said(title(request_.metric)));
    chart_->setPoints(std::move(points));
    showPoint(shownPoint_);
    if (result_.clock.empty()) return;
    say(sentences());
    words_->setText(words_->text().replace(QLatin1Char('\n'), QLatin1Char(' ')));
}

QString StudyView::whyNotApplied() const
{
    if (!keptRows_.missingExhibit.empty())
        return tr("There is no exhibit “%1” here, so its numbers are shown, but cannot be applied.")
            .arg(QString::fromStdString(keptRows_.missingExhibit));
    if (!keptRows_.missingRow.empty())
        return tr("There is no row “%1” now, so its numbers are shown, but cannot be applied.")
            .arg(QString::fromStdString(keptRows_.missingRow));
    return {};
}

void StudyView::refreshKept()
{
    keptRows_ = rowsOf(*kept_, museum_.subjects(), history_.sceneState());
    const std::optional<std::size_t> present = presentKeptPoint();
    std::vector<ChartPoint> points = chartPoints(*kept_);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].present = present == i;
    chart_->setTitles(studyCostTitle(kept_->cost), said(title(kept_->metric)));
    chart_->setPoints(std::move(points));
    showPoint(shownPoint_);
    QStringList sentences{tr("Kept: %1.").arg(keptTitle_), whyNotApplied()};
    for (const std::string& sentence : kept_->sentences) sentences << said(sentence);
    sentences << tr("Clock: %1, %2.").arg(said(kept_->clock), kept_->clockTrusted ? tr("trusted") : tr("not trusted"));
    sentences.removeAll(QString());
    say(sentences.join(QLatin1Char(' ')));
}

void StudyView::showCaption(const QString& caption)
{
    caption_->setText(caption);
    caption_->setToolTip(caption);
}

QString StudyView::captionOf(const KeptStudy& study, std::size_t point) const
{
    const KeptPoint& p = study.points[point];
    QString text = said(study.pointText(point)) + tr(": error %1").arg(shortNumber(p.error));
    if (study.cost != "ms") text += workText(p.cost, study.cost);
    if (p.time) text += timesText(p.time->median, p.time->interval.low, p.time->interval.high);
    return keptPictures_.empty() ? tr("%1. Its pictures were not kept.").arg(text) : text;
}

QString StudyView::captionOf(const StudyPoint& p) const
{
    QString text = said(pointText(museum_.subjects(), request_, p)) + tr(": error %1").arg(shortNumber(p.error));
    if (result_.costName != "ms") text += workText(p.cost, result_.costName);
    if (p.time) text += timesText(p.time->median, p.time->interval.low, p.time->interval.high);
    if (p.modelError > 0) text += tr("; against everything exact %1").arg(shortNumber(p.modelError));
    return text;
}

void StudyView::showKeptPoint(int wanted)
{
    const std::optional<std::size_t> present = presentKeptPoint();
    const std::optional<std::size_t> fallback = present ? present : kept_->knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    const bool is = point >= 0 && static_cast<std::size_t>(point) < kept_->points.size();
    const auto at = static_cast<std::size_t>(std::max(point, 0));
    const auto view = static_cast<std::size_t>(std::max(view_->currentIndex(), 0));
    if (is && view < keptPictures_.views && kept_->points[at].measured()) {
        showPictures(keptPictures_.picture(at, view), keptPictures_.reference(view), kept_->metric);
    } else {
        shown_ = {};
        pictures_->show({}, {}, {});
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
    // Without a pointer on one: what the picture on show is, or where it pays most.
    const std::optional<std::size_t> fallback = present ? present : result_.knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    const auto view = static_cast<std::size_t>(std::max(view_->currentIndex(), 0));
    if (point < 0 || static_cast<std::size_t>(point) >= result_.points.size() || view >= result_.references.size()) {
        shown_ = {};
        pictures_->show({}, {}, {});
        showCaption({});
    } else {
        const StudyPoint& p = result_.points[static_cast<std::size_t>(point)];
        if (p.shots[view].picture.empty()) return;
        showPictures(p.shots[view].picture, result_.references[view], request_.metric);
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
    shown_.full = render::fullScale(metric, shown_.errors);
    shownScale_ = tr("The heat map goes from 0 to %1 (%2).").arg(shortNumber(shown_.full), said(title(metric)));
    pictures_->show(screenImage(shown_.picture), screenImage(shown_.reference),
                    screenImage(render::heatMap(shown_.errors, shown_.full)), shortNumber(shown_.full));
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
            next.values[axis.subject].setRow(*row, axis.values[result_.points[point].setting[a]]);
    }
    const bool one = request_.axes.size() == 1;
    history_.change(one ? tr("Set %1").arg(said(pointText(museum_.subjects(), request_, result_.points[point])))
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
    const std::optional<std::vector<Value>> values = valuesOf(*kept_, point, keptRows_, next, wrong);
    if (!values) {
        emit refused(
            tr("This setting was not applied: its value of “%1” is none that the row takes now.").arg(said(wrong)));
        return;
    }
    for (std::size_t i = 0; i < values->size(); ++i)
        next.values[keptRows_.rows[i].subject].setRow(keptRows_.rows[i].row, (*values)[i]);
    history_.change(
        values->size() == 1 ? tr("Set %1").arg(said(kept_->pointText(point))) : tr("Set what the study found"), next);
}

}  // namespace vitrine::ui

#include "moc_study_view.cpp"

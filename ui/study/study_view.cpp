#include "ui/study/study_view.h"

#include "exhibits/museum/museum.h"
#include "exhibits/study/study_situation.h"
#include "exhibits/study/study_text.h"
#include "ui/kit/language.h"
#include "ui/kit/picture_file.h"
#include "ui/kit/text.h"
#include "ui/model/history.h"
#include "ui/study/point_caption.h"
#include "ui/study/point_pictures.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_export.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace vitrine::ui {
StudyView::StudyView(const Museum& museum, History& history, QWidget* parent)
    : QWidget(parent), museum_(museum), history_(history), cost_(new QComboBox(this)), words_(wrappedLabel(this)),
      chart_(new StudyChart(this)), pictures_(new PointPictures(this))
{
    cost_->setObjectName(QStringLiteral("cost"));
    cost_->setAccessibleName(tr("Costs of the chart"));
    cost_->setToolTip(
        tr("Quantity on the lower axis of the chart: time, or counted work, which is the same on every machine."));
    cost_->addItem(tr("Milliseconds"));
    cost_->addItem(tr("Counted work"));
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layOut();
    connectParts();
}

void StudyView::layOut()
{
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(chartWithCosts());
    split->addWidget(pictures_);
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

study::CostAxis StudyView::costAxis() const
{
    return cost_->currentIndex() == 0 ? study::CostAxis::time : study::CostAxis::work;
}

void StudyView::chooseCostAxis(study::CostAxis axis)
{
    costChosen_ = true;
    cost_->setCurrentIndex(axis == study::CostAxis::time ? 0 : 1);
}

void StudyView::decideCostAxis(bool clockTrusted)
{
    if (costChosen_) return;
    const QSignalBlocker quiet(cost_);
    cost_->setCurrentIndex(study::usualCostAxis(clockTrusted) == study::CostAxis::time ? 0 : 1);
}

void StudyView::connectParts()
{
    connect(cost_, &QComboBox::activated, this, [this] { costChosen_ = true; });
    connect(cost_, &QComboBox::currentIndexChanged, this, &StudyView::refresh);
    connect(pictures_, &PointPictures::viewChosen, this, [this] { showPoint(shownPoint_); });
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

void StudyView::showMeasured(const study::StudyRequest& request, study::StudyResult result, const render::Json& machine,
                             bool isNew)
{
    if (isNew) {
        kept_.reset();
        request_ = request;
        shownPoint_ = -1;
        stopped_ = false;
        pictures_->setViews(result.views);
        decideCostAxis(result.clockTrusted);
    }
    machine_ = machine;
    result_ = std::move(result);
    if (kept_) return;  // A kept study is shown at the moment.
    refresh();
}

void StudyView::showKept(study::KeptStudy study, std::string json, const QString& title)
{
    kept_.emplace(std::move(study), std::move(json), title);
    shownPoint_ = -1;
    pictures_->setViews(kept_->study().views);
    decideCostAxis(kept_->study().clockTrusted && kept_->isTimed());
    refresh();
}

void StudyView::showKeptPictures(const study::ContactSheet& sheet)
{
    if (kept_ && kept_->setPictures(sheet)) showPoint(shownPoint_);
}

void StudyView::noteStopped()
{
    if (result_.complete || result_.points.empty()) return;
    stopped_ = true;
    if (result_.workName.empty()) {
        std::vector<std::map<std::string, double>> counters;
        for (const study::StudyPoint& point : result_.points)
            if (study::isDrawn(point)) counters.emplace_back(point.counters.begin(), point.counters.end());
        result_.workName = study::mostTellingCounter(counters);
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
    return study::studyJson(museum_.subjects(), request_, result_, machine_);
}

QString StudyView::fileName() const
{
    QStringList parts;
    if (kept_) {
        parts << QString::fromStdString(kept_->study().exhibit);
        for (const study::KeptStudy::Parameter& parameter : kept_->study().parameters)
            parts << QString::fromStdString(parameter.name);
    } else {
        parts << text(museum_.subject(request_.subject).name());
        for (const study::StudyAxis& axis : request_.axes)
            parts << text(study::parameterOf(request_.sceneState, axis).name);
    }
    constexpr int mostNamed = 3;  // The exhibit and two parameters: studies of many would have endless names.
    return parts.mid(0, parts.size() > mostNamed ? 1 : mostNamed)
        .join(QLatin1Char('-'))
        .replace(QLatin1Char('/'), QLatin1Char('-'));
}

QByteArray StudyView::exported(const QString& suffix) const
{
    if (kept_ && suffix == QLatin1String("csv")) return QByteArray::fromStdString(study::keptCsv({kept_->study()}));
    if (kept_ && suffix == QLatin1String("json")) return QByteArray::fromStdString(kept_->json());
    return studyFile(suffix, museum_.subjects(), request_, result_, machine_, *chart_);
}

std::optional<std::size_t> StudyView::rowNow(const study::StudyAxis& axis) const
{
    return history_.sceneState().values[axis.subject].table().find(study::parameterOf(request_.sceneState, axis).name);
}

std::optional<std::size_t> StudyView::presentPoint() const
{
    const SceneState& sceneState = history_.sceneState();
    for (std::size_t i = 0; i < result_.points.size(); ++i) {
        bool same = true;
        for (std::size_t a = 0; a < request_.axes.size(); ++a) {
            const study::StudyAxis& axis = request_.axes[a];
            const std::optional<std::size_t> row = rowNow(axis);
            same = same && row &&
                   sceneState.values[axis.subject].row(*row) == Value(axis.values[result_.points[i].setting[a]]);
        }
        if (same) return i;
    }
    return std::nullopt;
}

QString StudyView::sentences(const QString& law) const
{
    QStringList sentences{law};
    for (const std::string& sentence :
         {study::choiceSentence(museum_.subjects(), request_, result_), result_.convergence})
        sentences << translatedText(sentence);
    for (const std::string& sentence :
         study::situationSentences(museum_.subjects(), request_, result_, study::ParameterNames::shown))
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
    if (stopped_ && costAxis() == study::CostAxis::time)
        study.emptyText = tr("The study was stopped before its settings were timed.");
    const QString law = study.law;
    showChart(std::move(study), presentPoint());
    showPoint(shownPoint_);
    if (!result_.clock.empty()) say(sentences(law));
}

void StudyView::refreshKept()
{
    kept_->findParameters(museum_.subjects(), history_.sceneState());
    const study::KeptStudy& kept = kept_->study();
    ChartedStudy study = charted(kept, kept_->title(), costAxis());
    QStringList sentences{tr("From the history: %1.").arg(kept_->title()), kept_->whyNotApplied(), study.law};
    showChart(std::move(study), kept_->presentPoint(history_.sceneState()));
    showPoint(shownPoint_);
    for (const std::string& sentence : kept.sentences) sentences << translatedText(sentence);
    sentences
        << tr("Clock: %1, %2.").arg(translatedText(kept.clock), kept.clockTrusted ? tr("trusted") : tr("not trusted"));
    sentences.removeAll(QString());
    say(sentences.join(QLatin1Char(' ')));
}

QString StudyView::captionOf(const study::StudyPoint& p) const
{
    const QString setting = settingWords(study::settingParts(museum_.subjects(), request_, p));
    if (!study::isDrawn(p)) return tr("%1 is not measured yet.").arg(setting);
    PointNumbers numbers{.error = p.error, .workName = result_.workName, .modelError = p.modelError};
    if (p.time) numbers.time = PointNumbers::Time{p.time->median, p.time->interval.low, p.time->interval.high};
    if (const auto found = p.counters.find(result_.workName); found != p.counters.end()) numbers.work = found->second;
    return pointCaption(setting, numbers);
}

void StudyView::showKeptPoint(int wanted)
{
    const study::KeptStudy& kept = kept_->study();
    const study::ContactSheet& sheet = kept_->pictures();
    const std::optional<std::size_t> present = kept_->presentPoint(history_.sceneState());
    const std::optional<std::size_t> fallback = present ? present : study::costsAlong(costAxis(), kept).knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    const bool is = point >= 0 && static_cast<std::size_t>(point) < kept.points.size();
    const auto at = static_cast<std::size_t>(std::max(point, 0));
    const std::size_t view = pictures_->view();
    if (is && view < sheet.views && kept.points[at].measured())
        pictures_->showPictures(sheet.picture(at, view), sheet.reference(view), kept.metric);
    else
        pictures_->hidePictures();
    const QString none = sheet.empty() ? tr("Its pictures were not kept.") : QString();
    pictures_->setCaption(is ? kept_->captionOf(at) : none);
}

void StudyView::showPoint(int wanted)
{
    shownPoint_ = wanted;
    chart_->emphasize(wanted >= 0 ? std::optional(static_cast<std::size_t>(wanted)) : std::nullopt);
    if (kept_) return showKeptPoint(wanted);
    const std::optional<std::size_t> present = presentPoint();
    // Without a hovered point: the present setting, or else the knee.
    const std::optional<std::size_t> fallback =
        present ? present : study::costsAlong(costAxis(), request_, result_).knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    const std::size_t view = pictures_->view();
    if (point < 0 || static_cast<std::size_t>(point) >= result_.points.size() || view >= result_.references.size()) {
        pictures_->hidePictures();
        pictures_->setCaption({});
        return;
    }
    const study::StudyPoint& p = result_.points[static_cast<std::size_t>(point)];
    if (study::isDrawn(p))
        pictures_->showPictures(p.shots[view].picture, result_.references[view], request_.metric);
    else
        pictures_->hidePictures();
    pictures_->setCaption(captionOf(p));
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
        const study::StudyAxis& axis = request_.axes[a];
        if (const auto row = rowNow(axis))
            next.values[axis.subject].setParameter(*row, axis.values[result_.points[point].setting[a]]);
    }
    const bool one = request_.axes.size() == 1;
    history_.change(
        one ? tr("Set %1").arg(settingWords(study::settingParts(museum_.subjects(), request_, result_.points[point])))
            : tr("Set what the study found"),
        next);
}

void StudyView::applyKept(std::size_t point)
{
    if (point >= kept_->study().points.size()) return;
    if (const QString why = kept_->whyNotApplied(); !why.isEmpty()) {
        emit refused(why);
        return;
    }
    SceneState next = history_.sceneState();
    if (const std::optional<std::string> wrong = kept_->apply(point, next)) {
        emit refused(tr("This setting was not applied: the parameter no longer accepts its value of “%1”.")
                         .arg(translatedText(*wrong)));
        return;
    }
    const std::vector<study::SettingPart> parts = kept_->study().settingParts(point);
    history_.change(parts.size() == 1 ? tr("Set %1").arg(settingWords(parts)) : tr("Set what the study found"), next);
}

}  // namespace vitrine::ui

#include "moc_study_view.cpp"

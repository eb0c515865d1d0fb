#include "ui/study/study_dock.h"

#include "exhibits/framework/expression.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/measure/distance.h"
#include "render/measure/memory.h"
#include "ui/kit/text.h"
#include "ui/kit/time_left.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_export.h"
#include "ui/study/study_pictures.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

constexpr int shortTile = 96;        ///< So that no step holds up the next picture for long.
constexpr qint64 refreshTime = 200;  ///< Milliseconds between two looks of the chart while measuring.

QString shortNumber(double x)
{
    return QLocale::c().toString(x, 'g', 3);
}

QLineEdit* numberField(const QString& name, const QString& start, QWidget* parent)
{
    auto* field = new QLineEdit(start, parent);
    field->setAccessibleName(name);
    field->setFixedWidth(64);
    field->setAlignment(Qt::AlignRight);
    return field;
}

}  // namespace

StudyDock::StudyDock(const Museum& museum, Renderers& renderers, History& history, RenderThread& thread,
                     QWidget* parent)
    : QWidget(parent), museum_(museum), renderers_(renderers), history_(history), thread_(thread),
      parameter_(new QComboBox(this)), view_(new QComboBox(this)), go_(new QPushButton(this)),
      copy_(new QToolButton(this)), save_(new QToolButton(this)), progress_(new QProgressBar(this)),
      doing_(new QLabel(this)), words_(new QLabel(this)), caption_(new QLabel(this)),
      error_(numberField(tr("Largest error"), QStringLiteral("0.02"), this)),
      milliseconds_(numberField(tr("Longest time in milliseconds"), QStringLiteral("10"), this)),
      chart_(new StudyChart(this)), pictures_(new StudyPictures(this))
{
    setTexts();
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 8, 8, 8);
    all->setSpacing(8);
    all->addLayout(measuring());
    all->addLayout(choosing());
    all->addWidget(chartAndPictures(), 1);
    all->addWidget(words_);
    connectParts();
    showIdle();
}

void StudyDock::setTexts()
{
    parameter_->setAccessibleName(tr("What to measure"));
    view_->setAccessibleName(tr("View"));
    for (QComboBox* box : {parameter_, view_}) {
        // Long names of parameters must not widen the window.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(14);
    }
    progress_->setAccessibleName(tr("Progress"));
    go_->setAccessibleName(tr("Measure, or stop measuring"));
    progress_->setFixedWidth(120);
    progress_->setTextVisible(false);
    // What comes and goes while it measures must not move the picture above.
    QSizePolicy keepsItsPlace = progress_->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(keepsItsPlace);
    go_->setFixedWidth(80);
    copy_->setText(tr("Copy"));
    copy_->setAccessibleName(tr("Copy the measurements"));
    copy_->setToolTip(tr("Copies what was measured as a table (CSV)."));
    save_->setText(tr("Save…"));
    save_->setAccessibleName(tr("Save the measurements"));
    save_->setToolTip(tr("Saves what was measured as a table (CSV) or JSON, or the chart as PNG or SVG."));
    for (QLabel* label : {doing_, words_, caption_}) {
        label->setTextFormat(Qt::PlainText);
        label->setMinimumWidth(40);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }
    words_->setWordWrap(true);
    caption_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

QLayout* StudyDock::measuring()
{
    auto* top = new QHBoxLayout;
    top->setSpacing(8);
    for (QWidget* w : std::initializer_list<QWidget*>{parameter_, go_, progress_}) top->addWidget(w);
    top->addWidget(doing_, 1);
    return top;
}

QLayout* StudyDock::choosing()
{
    auto* cheapest = new QPushButton(tr("Find"), this);
    cheapest->setAccessibleName(tr("Find the cheapest within the error"));
    auto* best = new QPushButton(tr("Find"), this);
    best->setAccessibleName(tr("Find the best within the time"));
    connect(cheapest, &QPushButton::clicked, this, [this] { find(true); });
    connect(best, &QPushButton::clicked, this, [this] { find(false); });
    auto* choose = new QHBoxLayout;
    choose->setSpacing(8);
    for (QWidget* w : std::initializer_list<QWidget*>{new QLabel(tr("Cheapest within error"), this), error_, cheapest,
                                                      new QLabel(tr("Best within"), this), milliseconds_,
                                                      new QLabel(tr("ms"), this), best})
        choose->addWidget(w);
    choose->addStretch(1);
    for (QToolButton* button : {copy_, save_}) {
        button->setFocusPolicy(Qt::StrongFocus);
        button->setFixedHeight(26);
        choose->addWidget(button);
    }
    return choose;
}

QWidget* StudyDock::chartAndPictures()
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
    return split;
}

void StudyDock::connectParts()
{
    connect(go_, &QPushButton::clicked, this, [this] { running() ? stop() : measure(); });
    connect(error_, &QLineEdit::returnPressed, this, [this] { find(true); });
    connect(milliseconds_, &QLineEdit::returnPressed, this, [this] { find(false); });
    connect(view_, &QComboBox::currentIndexChanged, this, [this] { showPoint(shownPoint_); });
    connect(copy_, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(QString::fromUtf8(exported(QStringLiteral("csv")))); });
    connect(save_, &QToolButton::clicked, this, &StudyDock::save);
    connect(pictures_, &StudyPictures::enlargeAsked, this, [this] { chart_->setVisible(chart_->isHidden()); });
    connect(chart_, &StudyChart::hovered, this, [this](int point) { showPoint(point); });
    connect(chart_, &StudyChart::chosen, this, [this](int point) { apply(static_cast<std::size_t>(point)); });
    const auto refreshWhileSeen = [this] {
        if (isVisible()) refresh();
    };
    connect(&history_, &History::changed, this, refreshWhileSeen);
    connect(&history_, &History::replaced, this, refreshWhileSeen);
    connect(&history_, &History::replaced, this, [this] {
        if (table_ && !table_->hasRowsOf(history_.sceneState().values[subject_].table())) setSubject(subject_);
    });
}

StudyDock::~StudyDock()
{
    stop();
}

void StudyDock::showEvent(QShowEvent* event)
{
    refresh();
    QWidget::showEvent(event);
}

void StudyDock::setEffort(glm::ivec2 size, int runs)
{
    size_ = size;
    runs_ = runs;
}

void StudyDock::setSubject(std::size_t exhibit)
{
    const QString before = exhibit == subject_ ? parameter_->currentText() : QString();
    subject_ = exhibit;
    parameter_->clear();
    parameter_->addItem(tr("All parameters together"), -1);
    table_ = history_.sceneState().values[exhibit].sharedTable();
    const auto rows = table_->rows();
    for (std::size_t row = 0; row < rows.size(); ++row)
        if (rows[row].qualityReference)
            parameter_->addItem(QString::fromStdString(label(rows[row])), static_cast<int>(row));
    if (parameter_->count() > 1) parameter_->setCurrentIndex(std::max(parameter_->findText(before), 1));
    go_->setEnabled(running() || parameter_->count() > 1);
}

StudyRequest StudyDock::requestFor(std::vector<StudyAxis> axes) const
{
    StudyRequest request;
    request.subject = subject_;
    request.sceneState = history_.sceneState();
    request.axes = std::move(axes);
    request.size = size_;
    request.runs = runs_;
    request.largestTile = shortTile;
    return request;
}

void StudyDock::ask(std::size_t exhibit, std::size_t row)
{
    if (exhibit != subject_) setSubject(exhibit);
    parameter_->setCurrentIndex(parameter_->findData(static_cast<int>(row)));
    measure();
}

void StudyDock::measure()
{
    const int row = parameter_->currentData().toInt();
    if (row < 0) {
        start(requestFor(qualityAxes(history_.sceneState(), subject_)));
        return;
    }
    if (auto axis = studyAxis(history_.sceneState(), subject_, static_cast<std::size_t>(row), usualPoints(1)))
        start(requestFor({std::move(*axis)}));
}

void StudyDock::find(bool byError)
{
    const QLineEdit* field = byError ? error_ : milliseconds_;
    const std::optional<double> limit = evaluate(field->text().trimmed().toStdString(), Unit::none);
    if (!limit || !(*limit > 0)) {
        words_->setText(tr("\"%1\" is no limit; type a number above 0, such as %2.")
                            .arg(field->text(), byError ? QStringLiteral("0.02") : QStringLiteral("10")));
        return;
    }
    StudyRequest request = requestFor(qualityAxes(history_.sceneState(), subject_));
    (byError ? request.maxError : request.maxMilliseconds) = *limit;
    request.modelError = false;
    start(std::move(request));
}

struct StudyDock::Work {
    Renderers& renderers;
    StudyRequest request;
    StudyJob job;
    QElapsedTimer shown;
};

bool StudyDock::step(Work& work, const RenderThread::Tell& tell, const std::function<void(std::shared_ptr<News>)>& take)
{
    if (!work.job.study) {
        work.job = work.renderers.makeStudy(work.request);
        work.shown.start();
        if (!work.job.study) throw Failure(Blame::openGl, "Nothing can be measured: there is no graphics context.");
    }
    Study& study = *work.job.study;
    study.step();
    const bool done = study.finished();
    if (done || work.shown.elapsed() >= refreshTime) {
        auto news = std::make_shared<News>(
            News{done ? study.takeResult() : study.result(), done ? 1.0 : study.progress(), study.doing()});
        tell([take, news = std::move(news)] { take(news); });
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
    const auto take = [this](const std::shared_ptr<News>& news) { this->take(std::move(*news)); };
    task_ = thread_.start([work, take](const RenderThread::Tell& tell) { return step(*work, tell, take); },
                          [this](const QString& failure) { end(failure); });
}

void StudyDock::take(News news)
{
    const auto measured = [](const StudyPoint& p) {
        return p.cost > 0 &&
               std::all_of(p.shots.begin(), p.shots.end(), [](const StudyShot& shot) { return !shot.picture.empty(); });
    };
    const bool done = news.progress >= 1;
    // The former result stays until this one has a point.
    if (!showsRunning_ && (done || std::any_of(news.result.points.begin(), news.result.points.end(), measured))) {
        showsRunning_ = true;
        request_ = running_;
        shownPoint_ = -1;
        const QSignalBlocker quiet(view_);
        view_->clear();
        for (const std::string& view : news.result.views) view_->addItem(QString::fromStdString(view));
    }
    progress_->setValue(static_cast<int>(100 * news.progress));
    const double left = secondsLeft(news.progress, elapsed_);
    doing_->setText(QString::fromStdString(news.doing) +
                    (left >= 0 && !done ? QStringLiteral(", ") + timeLeft(left) : QString()));
    if (!showsRunning_) return;
    result_ = std::move(news.result);
    refresh();
}

void StudyDock::end(const QString& failure)
{
    stop();
    if (!failure.isEmpty()) {
        words_->setText(failure);
        emit failed(failure);
        return;
    }
    const std::optional<StudyChoice> choice = result().choice;
    if (choice && choice->holds) apply(choice->point);
    emit finished();
}

void StudyDock::stop()
{
    task_.cancel();
    isRunning_ = false;
    showsRunning_ = false;
    showIdle();
}

void StudyDock::showIdle()
{
    go_->setText(tr("Measure"));
    go_->setEnabled(parameter_->count() > 1);
    progress_->hide();
    doing_->clear();
    for (QToolButton* button : {copy_, save_}) button->setEnabled(!result_.points.empty());
    suggestTime();
    if (result_.points.empty())
        words_->setText(tr("Choose a parameter and measure it: its errors are those against its most exact value, its "
                           "costs are work and time."));
}

void StudyDock::suggestTime()
{
    // A limit that the present setting misses by half is one to look for; what was typed stays.
    if (milliseconds_->isModified() || !result().present) return;
    const StudyPoint& present = result().points[*result().present];
    if (present.time) milliseconds_->setText(shortNumber(present.time->median / 2));
}

QByteArray StudyDock::exported(const QString& suffix) const
{
    return studyFile(suffix, museum_.subjects(), request_, result(), *chart_);
}

void StudyDock::save()
{
    const QString why = askAndSaveStudy(this, [this](const QString& suffix) { return exported(suffix); });
    if (!why.isEmpty()) emit failed(why);
}

std::optional<std::size_t> StudyDock::rowNow(const StudyAxis& axis) const
{
    return history_.sceneState().values[axis.subject].table().find(rowOf(request_.sceneState, axis).name);
}

std::optional<std::size_t> StudyDock::presentPoint() const
{
    const SceneState& sceneState = history_.sceneState();
    for (std::size_t i = 0; i < result().points.size(); ++i) {
        bool same = true;
        for (std::size_t a = 0; a < request_.axes.size(); ++a) {
            const StudyAxis& axis = request_.axes[a];
            const std::optional<std::size_t> row = rowNow(axis);
            same = same && row &&
                   sceneState.values[axis.subject].row(*row) == Value(axis.values[result().points[i].setting[a]]);
        }
        if (same) return i;
    }
    return std::nullopt;
}

void StudyDock::refresh()
{
    if (request_.axes.empty()) return;
    const std::optional<std::size_t> present = presentPoint();
    std::vector<ChartPoint> points = chartPoints(museum_.subjects(), request_, result());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].present = present == i;
    chart_->setTitles(QString::fromStdString(costTitle(result().costName.empty() ? "ms" : result().costName)),
                      text(title(request_.metric)));
    chart_->setPoints(std::move(points));
    showPoint(shownPoint_);
    if (result().clock.empty()) return;
    QStringList sentences;
    for (const std::string& sentence :
         {lawSentence(result()), choiceSentence(museum_.subjects(), request_, result()), result().convergence})
        if (!sentence.empty()) sentences << QString::fromStdString(sentence);
    sentences << tr("Clock: %1, %2.")
                     .arg(QString::fromStdString(result().clock),
                          result().clockTrusted ? tr("trusted") : tr("not trusted"));
    words_->setText(sentences.join(QLatin1Char(' ')));
    words_->setToolTip(sentences.join(QLatin1Char('\n')));
}

void StudyDock::showPoint(int wanted)
{
    const std::optional<std::size_t> present = presentPoint();
    // Without a pointer on one: what the picture on show is, or where it pays most.
    const std::optional<std::size_t> fallback = present ? present : result().knee;
    const int point = wanted >= 0 ? wanted : fallback ? static_cast<int>(*fallback) : -1;
    shownPoint_ = wanted;
    chart_->emphasize(wanted >= 0 ? std::optional(static_cast<std::size_t>(wanted)) : std::nullopt);
    const auto view = static_cast<std::size_t>(std::max(view_->currentIndex(), 0));
    if (point < 0 || static_cast<std::size_t>(point) >= result().points.size() || view >= result().references.size()) {
        pictures_->show({}, {}, {});
        caption_->clear();
        return;
    }
    const StudyPoint& p = result().points[static_cast<std::size_t>(point)];
    const StudyShot& shot = p.shots[view];
    if (shot.picture.empty()) return;
    const render::Image errors = render::errorMap(request_.metric, result().references[view], shot.picture)
                                     .value_or(render::differenceMap(result().references[view], shot.picture));
    const double full = render::fullScale(request_.metric, errors);
    pictures_->show(screenImage(shot.picture), screenImage(result().references[view]),
                    screenImage(render::heatMap(errors, full)), shortNumber(full));
    pictures_->setAccessibleDescription(
        tr("Left of the line the setting, right of it the reference; arrows move the line. The heat map goes from 0 to "
           "%1 (%2).")
            .arg(shortNumber(full), text(title(request_.metric))));
    QString text =
        QString::fromStdString(pointText(museum_.subjects(), request_, p)) + tr(": error %1").arg(shortNumber(p.error));
    if (result().costName != "ms")
        text += tr(", %1 %2").arg(QLocale::c().toString(static_cast<qlonglong>(p.cost)),
                                  QString::fromStdString(costTitle(result().costName)));
    if (p.time)
        text += tr(", %1 ms (%2 to %3)")
                    .arg(shortNumber(p.time->median), shortNumber(p.time->interval.low),
                         shortNumber(p.time->interval.high));
    if (p.modelError > 0) text += tr("; against everything exact %1").arg(shortNumber(p.modelError));
    caption_->setText(text);
    caption_->setToolTip(text);
}

void StudyDock::apply(std::size_t point)
{
    if (point >= result().points.size()) return;
    SceneState next = history_.sceneState();
    for (std::size_t a = 0; a < request_.axes.size(); ++a) {
        const StudyAxis& axis = request_.axes[a];
        if (const auto row = rowNow(axis))
            next.values[axis.subject].setRow(*row, axis.values[result().points[point].setting[a]]);
    }
    const bool one = request_.axes.size() == 1;
    history_.change(
        one ? tr("Set %1").arg(QString::fromStdString(pointText(museum_.subjects(), request_, result().points[point])))
            : tr("Set what the study found"),
        next);
}

}  // namespace vitrine::ui

#include "moc_study_dock.cpp"

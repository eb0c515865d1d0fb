#include "ui/study/study_dock.h"

#include "exhibits/framework/table/expression.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/measure/memory.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/time_left.h"
#include "ui/kit/type_size.h"
#include "ui/study/kept_studies.h"
#include "ui/study/study_export.h"
#include "ui/study/study_view.h"

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

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int shortTile = 96;        ///< Pixels, so that no step delays the next picture of the viewport for long.
constexpr qint64 refreshTime = 200;  ///< Milliseconds between two updates of the chart while measuring.
constexpr int leastToKeep = 3;       ///< Number of measured settings from which a stopped study is kept.

QLineEdit* numberField(const QString& name, const QString& start, QWidget* parent)
{
    auto* field = new QLineEdit(start, parent);
    field->setAccessibleName(name);
    growWidth(*field, 64);
    field->setAlignment(Qt::AlignRight);
    return field;
}

}  // namespace

StudyDock::StudyDock(const Museum& museum, Renderers& renderers, History& history, RenderThread& thread,
                     StudyStore store, QWidget* parent)
    : QWidget(parent), museum_(museum), renderers_(renderers), history_(history), thread_(thread),
      parameter_(new QComboBox(this)), go_(new QPushButton(this)), copy_(new QToolButton(this)),
      save_(new QToolButton(this)), list_(new QToolButton(this)), progress_(new QProgressBar(this)),
      doing_(new QLabel(this)), error_(numberField(tr("Largest error"), QStringLiteral("0.02"), this)),
      milliseconds_(numberField(tr("Longest time in milliseconds"), QStringLiteral("10"), this)),
      shown_(new StudyView(museum, history, this)),
      kept_(new KeptStudies(museum.subjects(), history, std::move(store), this))
{
    setTexts();
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 8, 8, 8);
    all->setSpacing(8);
    all->addLayout(measuring());
    all->addLayout(choosing());
    all->addWidget(studies(), 1);
    connectParts();
    showIdle();
}

void StudyDock::setTexts()
{
    parameter_->setAccessibleName(tr("What to measure"));
    // Long names of parameters must not widen the window.
    parameter_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    parameter_->setMinimumContentsLength(14);
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
    save_->setToolTip(tr("Saves what was measured as a table (CSV) or JSON, or the chart as PNG or SVG."));
    list_->setText(tr("Kept"));
    list_->setCheckable(true);
    list_->setAccessibleName(tr("Show the kept studies"));
    list_->setToolTip(
        tr("Shows the studies that were kept: to look at again, compare, rename, delete, open and save."));
    doing_->setTextFormat(Qt::PlainText);
    doing_->setMinimumWidth(40);
    doing_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
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
    for (QToolButton* button : {copy_, save_, list_}) {
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
    split->setStretchFactor(0, 0);
    split->setStretchFactor(1, 1);
    split->setChildrenCollapsible(false);
    split->setSizes({260, 740});
    kept_->hide();
    return split;
}

void StudyDock::connectParts()
{
    connect(go_, &QPushButton::clicked, this, [this] { running() ? stop() : measure(); });
    connect(error_, &QLineEdit::returnPressed, this, [this] { find(true); });
    connect(milliseconds_, &QLineEdit::returnPressed, this, [this] { find(false); });
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
        if (table_ && !table_->hasRowsOf(history_.sceneState().values[subject_].table())) setSubject(subject_);
    });
}

StudyDock::~StudyDock()
{
    stop();
}

StudyChart& StudyDock::chart() const
{
    return shown_->chart();
}

const StudyResult& StudyDock::result() const
{
    return shown_->result();
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
        if (rows[row].qualityReference) parameter_->addItem(said(label(rows[row])), static_cast<int>(row));
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
        shown_->say(tr("\"%1\" is not a limit; type a number above 0, such as %2.")
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
        auto news = std::make_shared<News>(News{done ? study.takeResult() : study.result(),
                                                done ? 1.0 : study.progress(), study.doing(), work.job.machine});
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
    const bool done = news.progress >= 1;
    // The earlier result stays until the new one has a point.
    const bool isNew =
        !showsRunning_ && (done || std::any_of(news.result.points.begin(), news.result.points.end(), isDrawn));
    showsRunning_ = showsRunning_ || isNew;
    progress_->setValue(static_cast<int>(100 * news.progress));
    const double left = secondsLeft(news.progress, elapsed_);
    doing_->setText(said(news.doing) + (left >= 0 && !done ? QStringLiteral(", ") + timeLeft(left) : QString()));
    if (!showsRunning_) return;
    shown_->showMeasured(running_, std::move(news.result), news.machine, isNew);
}

void StudyDock::end(const QString& failure)
{
    stop();
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
    suggestTime();
    if (shown_->empty())
        shown_->say(tr("Choose a parameter, then Measure. Errors are against its most exact value; costs are time and "
                       "counted work."));
}

void StudyDock::suggestTime()
{
    // Suggests half of the present time as the limit, unless a limit was typed.
    if (milliseconds_->isModified() || !result().present) return;
    const StudyPoint& present = result().points[*result().present];
    if (present.time) milliseconds_->setText(QLocale::c().toString(present.time->median / 2, 'g', 3));
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

#include "ui/print/print_dialog.h"

#include "render/failure.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/print/eyes_preview.h"
#include "ui/print/print_numbers.h"
#include "ui/print/sheet_bar.h"
#include "ui/print/shown_views.h"
#include "ui/print/source_bar.h"
#include "ui/print/strip_preview.h"

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabBar>

#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int renderAfter = 400;  // Milliseconds: not at every step of a slider.

}  // namespace

PrintDialog::PrintDialog(std::unique_ptr<PrintDesk> desk, ShownViews* shown, QWidget* parent)
    : QDialog(parent), desk_(std::move(desk)), live_(shown), look_(this), count_(this), read_(this), write_(this)
{
    if (live_) live_->setParent(this);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export lenticular print"));
    setAcceptDrops(true);
    renderSoon_.setSingleShot(true);
    renderSoon_.setInterval(renderAfter);
    build();
    connectParts();
    recall();
}

PrintDialog::~PrintDialog()
{
    if (!remembered_) remember();  // The window took it along.
}

void PrintDialog::connectParts()
{
    connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) { setChart(tab == 1); });
    connect(source_, &SourceBar::originChosen, this, [this](ViewOrigin origin) {
        files_.clear();
        setValues(desk_->withOrigin(*values_, origin));
    });
    connect(source_, &SourceBar::filesChosen, this, &PrintDialog::open);
    connect(source_, &SourceBar::renderAsked, this, &PrintDialog::getViews);
    connect(sheets_, &SheetBar::chosen, this, [this](const QString& name) {
        try {
            sheet_ = name.toStdString();
            setValues(desk_->withSheet(*values_, sheet_));
        } catch (const std::exception& failure) {
            say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
        }
    });
    const auto changeSheets = [this](const auto& change) {
        try {
            change();
        } catch (const std::exception& failure) {
            say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
        }
        showSheets();
    };
    connect(sheets_, &SheetBar::saveAsked, this,
            [this, changeSheets](const QString& name) {
                changeSheets([&] {
                    desk_->saveSheet(*values_, name.toStdString());
                    sheet_ = name.toStdString();
                });
            });
    connect(sheets_, &SheetBar::removeAsked, this,
            [this, changeSheets](const QString& name) { changeSheets([&] { desk_->removeSheet(name.toStdString()); }); });
    const auto edited = [this] {
        if (values_ && settings_.look().values[0] != *values_) setValues(settings_.look().values[0]);
    };
    connect(&settings_, &History::changed, this, edited);
    connect(&settings_, &History::replaced, this, edited);
    connect(numbers_, &PrintNumbersView::fitAsked, this, [this](double scale) { setValues(desk_->withBaselineScale(*values_, scale)); });
    connect(path_, &QLineEdit::textChanged, this, &PrintDialog::refresh);
    connect(browse_, &QToolButton::clicked, this, &PrintDialog::browse);
    connect(load_, &QPushButton::clicked, this, [this] { askSettings(false); });
    connect(save_, &QPushButton::clicked, this, [this] { askSettings(true); });
    connect(go_, &QPushButton::clicked, this, &PrintDialog::startExport);
    connect(stop_, &QPushButton::clicked, this, &PrintDialog::reject);

    for (NewestJob* job : {&look_, &count_})
        connect(job, &NewestJob::failed, this, [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    connect(&renderSoon_, &QTimer::timeout, this, [this] {
        if (exporting_ || !summary_.refusal.empty()) return;
        wantsViews_ = false;
        live_->start(*desk_, *values_, true);
    });
    connect(&read_, &ProgressJob::progressed, this, [this](double part) { source_->say(tr("Reading, %1 %").arg(std::lround(part * 100))); });
    connect(&read_, &ProgressJob::failed, this, [this](const QString& why) {
        source_->say(tr("No views could be read."));
        say(MessageStrip::Mood::problem, why);
        refresh();
    });
    const auto tell = [this](double part, double secondsLeft) {
        progress_->setValue(static_cast<int>(part * 1000));
        status_->setText(secondsLeft < 0 ? QString() : timeLeft(secondsLeft));
    };
    connect(&write_, &ProgressJob::progressed, this, tell);
    connect(&write_, &ProgressJob::stopped, this, [this] { endExport(tr("Cancelled; no file was written.")); });
    connect(&write_, &ProgressJob::failed, this, [this](const QString& why) {
        endExport(tr("Nothing was written."));
        say(MessageStrip::Mood::problem, why);
    });
    if (!live_) return;
    connect(live_, &ShownViews::progressed, this, [this, tell](double part, double secondsLeft) {
        source_->say(tr("Rendering views, %1 %").arg(std::lround(part * 100)));
        if (exporting_) tell(part, secondsLeft);
    });
    connect(live_, &ShownViews::finished, this, [this](const std::shared_ptr<const PrintViews>& views, const SceneDepth& depth) {
        takeViews(views, depth, !exporting_);
        if (exporting_) write(views);
    });
    connect(live_, &ShownViews::failed, this, [this](const QString& why) {
        source_->say(tr("No views could be rendered."));
        say(MessageStrip::Mood::problem, why);
        if (exporting_) endExport(tr("Nothing was written."));
    });
}

void PrintDialog::say(MessageStrip::Mood mood, const QString& text)
{
    messages_->say(mood, text);
}

void PrintDialog::setValues(const ParameterValues& values)
{
    const bool same = values_ && desk_->sameViews(*values_, values);
    values_ = values;
    if (!live_ && desk_->origin(*values_) == ViewOrigin::shown) values_ = desk_->withOrigin(*values_, ViewOrigin::files);
    if (settings_.look().values.empty()) settings_.restart({{*values_}, {}});
    else settings_.change({}, {{*values_}, {}});
    panel_->showExhibit(0, QStringLiteral("print"));
    showRows();
    showSheets();
    source_->showOrigin(desk_->origin(*values_));
    if (!same) getViews();
    refresh();
}

void PrintDialog::showRows()
{
    panel_->setWanted([this](const ParameterInfo& row) { return desk_->matters(row, *values_, chart_); });
}

void PrintDialog::showSheets()
{
    std::string problem;
    sheets_->showSheets(desk_->sheets(problem), desk_->sheetName(*values_, sheet_));
    if (!problem.empty()) say(MessageStrip::Mood::problem, QString::fromStdString(problem));
}

void PrintDialog::setChart(bool chart)
{
    if (chart != chart_) {
        const QString other = std::exchange(otherPath_, path_->text());
        chart_ = chart;
        path_->setText(other);
    }
    tabs_->setCurrentIndex(chart ? 1 : 0);
    source_->setVisible(!chart);
    eyes_->setVisible(!chart);
    showRows();
    refresh();
}

void PrintDialog::setPath(const QString& path)
{
    path_->setText(path);
}

QString PrintDialog::path() const
{
    return path_->text();
}

bool PrintDialog::hasViews() const
{
    return views_ || desk_->origin(*values_) == ViewOrigin::shown;
}

void PrintDialog::getViews()
{
    if (desk_->origin(*values_) == ViewOrigin::shown) {
        read_.stop();
        draft_ = wantsViews_ = true;
        renderSoon_.start();
        return;
    }
    wantsViews_ = false;
    renderSoon_.stop();
    if (live_) live_->stop();
    depth_.reset();
    readFiles();
}

void PrintDialog::readFiles()
{
    if (files_.isEmpty()) {
        views_.reset();
        read_.stop();
        source_->say(desk_->origin(*values_) == ViewOrigin::quilt ? tr("Choose a picture with a grid of views, or drop it here.")
                                                                  : tr("Choose a folder or pictures, or drop them here."));
        return;
    }
    std::vector<std::string> names;
    for (const QString& file : files_) names.push_back(file.toStdString());
    source_->say(tr("Reading"));
    read_.start([this, names, values = *values_](const PrintProgress& progress) -> ProgressJob::Outcome {
        const std::shared_ptr<const PrintViews> views = desk_->readViews(values, names, progress);
        return [this, views] { takeViews(views, std::nullopt, false); };
    });
}

void PrintDialog::takeViews(std::shared_ptr<const PrintViews> views, const std::optional<SceneDepth>& depth, bool draft)
{
    views_ = std::move(views);
    depth_ = depth;
    draft_ = draft;
    const QString from = files_.isEmpty() ? tr("what is shown") : files_.size() == 1 ? QFileInfo(files_.front()).fileName() : tr("%1 pictures").arg(files_.size());
    source_->say(draft ? tr("%1 views of %2, small ones to look at").arg(views_->count()).arg(from) : tr("%1 views from %2").arg(views_->count()).arg(from));
    refresh();
}

bool PrintDialog::settled() const
{
    return asked_ == shown_ && !look_.busy() && !read_.running() && !renderSoon_.isActive() && !(live_ && live_->running());
}

void PrintDialog::refresh()
{
    if (!values_) return;
    const int turn = ++asked_;
    const std::filesystem::path path = path_->text().toStdString();
    const std::shared_ptr<const PrintViews> views = chart_ ? nullptr : views_;
    look_.ask([this, values = *values_, views, chart = chart_]() -> NewestJob::Outcome {
        std::shared_ptr<const PrintPreview> preview;
        try {
            if (chart || views) preview = desk_->preview(values, views);
        } catch (const Failure&) {  // The summary says why.
        }
        return [this, preview, distance = desk_->viewingDistance(values)] {
            strips_->setPreview(preview);
            eyes_->setPreview(chart_ ? nullptr : preview, distance);
        };
    });
    count_.ask([this, turn, path, values = *values_, views, chart = chart_]() -> NewestJob::Outcome {
        // Views that are rendered will be as many as the values say, whatever is there now.
        const PrintSummary summary = desk_->summary(values, desk_->origin(values) == ViewOrigin::shown ? nullptr : views.get(), chart, path);
        return [this, turn, summary] {
            summary_ = summary;
            shown_ = turn;
            numbers_->showSummary(summary, chart_ ? std::nullopt : depth_);
            showButtons();
            if (wantsViews_ && !chart_ && summary.refusal.empty() && !renderSoon_.isActive()) renderSoon_.start();
        };
    });
    showButtons();
}

void PrintDialog::showButtons()
{
    go_->setEnabled(!exporting_ && summary_.refusal.empty() && (chart_ || hasViews()) && !read_.running());
    go_->setText(chart_ ? tr("Export chart") : tr("Export"));
    stop_->setText(exporting_ ? tr("Cancel") : tr("Close"));
    for (QWidget* input : std::initializer_list<QWidget*>{tabs_, source_, sheets_, panel_, path_, browse_, load_}) input->setEnabled(!exporting_);
}

}  // namespace vitrine::ui

#include "moc_print_dialog.cpp"

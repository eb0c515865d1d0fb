#include "ui/charts/charts_dock.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/museum/museum.h"
#include "ui/kit/accessible_plot.h"
#include "ui/kit/language.h"
#include "ui/kit/progress_job.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"
#include "ui/model/history.h"

#include <qcustomplot.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <memory>
#include <utility>

namespace vitrine::ui {
namespace {

/// Puts the legend above the plot, where it covers no curve.
void putLegendAbove(QCustomPlot& plot)
{
    plot.plotLayout()->insertRow(0);
    plot.plotLayout()->addElement(0, 0, plot.legend);
    plot.plotLayout()->setRowStretchFactor(0, 0.001);
    plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
}

/// Returns the pen of a curve. The first curve is emphasized; the others are for comparison.
QPen penOf(std::size_t curve)
{
    const Theme& t = theme();
    if (curve == 0) return {t.accent, 2};
    return {curve == 1 ? t.dim : t.good, 1.5, Qt::DashLine};
}

void scale(QCPAxis& axis, bool logarithmic)
{
    axis.setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    if (logarithmic) axis.setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog));
    axis.setNumberFormat(logarithmic ? QStringLiteral("gb") : QStringLiteral("g"));
    axis.setNumberPrecision(logarithmic ? 0 : 3);
}

/// Sets the ranges of the axes. A linear axis begins at 0, unless there are negative values.
void setRanges(QCustomPlot& plot, const Chart& chart)
{
    plot.rescaleAxes();
    QCPRange y = plot.yAxis->range();
    if (chart.logarithmic) {
        y.lower = std::max(y.lower, y.upper * 1e-7);
        y.upper *= 2;
    } else {
        y.lower = std::min(y.lower, 0.0);
        y.upper += 0.06 * (y.upper - y.lower);
    }
    plot.yAxis->setRange(y);
}

/// Describes the curves for screen readers: "Title over x; y from 0 to 3. …".
QString sentences(const Chart& chart)
{
    QStringList all{ChartsDock::tr("%1 over %2.").arg(text(chart.yTitle), text(chart.xTitle))};
    for (const ChartCurve& curve : chart.curves) {
        const std::size_t count = std::min(curve.x.size(), curve.y.size());
        if (count == 0) continue;
        const auto end = curve.y.begin() + static_cast<std::ptrdiff_t>(count);
        const auto [least, most] = std::minmax_element(curve.y.begin(), end);
        const auto number = [](double value) { return QString::number(value, 'g', 3); };
        const auto place = [&](auto which) {
            return number(curve.x[static_cast<std::size_t>(which - curve.y.begin())]);
        };
        all << ChartsDock::tr("%1: from %2 at %3 to %4 at %5.")
                   .arg(curve.name.empty() ? ChartsDock::tr("The curve") : translatedText(curve.name), number(*least),
                        place(least), number(*most), place(most));
    }
    return all.join(QLatin1Char(' '));
}

void fill(AccessiblePlot& plot, const Chart& chart)
{
    plot.setSentences(sentences(chart));
    plot.clearGraphs();
    plot.setAccessibleName(translatedText(chart.title));
    plot.xAxis->setLabel(ChartsDock::tr("%1: %2").arg(translatedText(chart.title), translatedText(chart.xTitle)));
    plot.yAxis->setLabel(translatedText(chart.yTitle));
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) scale(*axis, chart.logarithmic);
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const ChartCurve& curve = chart.curves[i];
        QCPGraph* graph = plot.addGraph();
        graph->setName(translatedText(curve.name));
        graph->setPen(penOf(i));
        QVector<double> x, y;
        for (std::size_t k = 0; k < curve.x.size() && k < curve.y.size(); ++k) {
            if (chart.logarithmic && !(curve.x[k] > 0 && curve.y[k] > 0)) continue;
            x.append(curve.x[k]);
            y.append(curve.y[k]);
        }
        graph->setData(x, y, true);
    }
    plot.legend->setVisible(chart.curves.size() > 1);
    setRanges(plot, chart);
    plot.applyTheme();
    plot.replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace

ChartsDock::ChartsDock(const Museum& museum, History& history, QWidget* parent)
    : QWidget(parent), museum_(museum), history_(history), row_(new QHBoxLayout(this)), note_(new QLabel(this)),
      job_(new ProgressJob(this))
{
    row_->setContentsMargins(8, 8, 8, 8);
    row_->setSpacing(8);
    row_->addWidget(note_, 1);
    note_->setTextFormat(Qt::PlainText);
    note_->setAlignment(Qt::AlignCenter);
    note_->setWordWrap(true);
    setMinimumHeight(160);
    soon_.setSingleShot(true);
    soon_.setInterval(150);
    connect(&soon_, &QTimer::timeout, this, &ChartsDock::renew);
    connect(&history_, &History::changesSettled, this, [this](const std::set<std::size_t>& exhibits) {
        if (exhibits.contains(exhibit_)) ask();
    });
    connect(job_, &ProgressJob::failed, this, [this](const QString& why) {
        take(std::vector<Chart>());
        say(why);
    });
    sayWhyEmpty();
}

ChartsDock::~ChartsDock() = default;

void ChartsDock::setSubject(std::size_t exhibit)
{
    if (exhibit_ == exhibit) return;
    exhibit_ = exhibit;
    take(std::vector<Chart>());
    sayWhyEmpty();
    ask();
}

QString ChartsDock::note() const
{
    return note_->text();
}

void ChartsDock::ask()
{
    if (isVisible()) soon_.start();
}

void ChartsDock::renew()
{
    const auto* maker = capability<HasCharts>(museum_.subject(exhibit_));
    if (maker == nullptr) {
        job_->stop();
        return;
    }
    const ParameterValues values = history_.sceneState().values[exhibit_];
    job_->start([this, maker, values, exhibit = exhibit_](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        auto made = std::make_shared<std::vector<Chart>>(maker->charts(values));
        return [this, made, exhibit] {
            if (exhibit == exhibit_) take(std::move(*made));
        };
    });
}

void ChartsDock::take(std::vector<Chart> charts)
{
    charts_ = std::move(charts);
    draw();
    if (!charts_.empty()) {
        say({});
        emit renewed();
    }
}

void ChartsDock::draw()
{
    while (plots_.size() > charts_.size()) {
        delete plots_.back();
        plots_.pop_back();
    }
    while (plots_.size() < charts_.size()) {
        auto* plot = new AccessiblePlot(this);
        plot->setMinimumSize(180, 120);
        putLegendAbove(*plot);
        plots_.push_back(plot);
        row_->addWidget(plot, 1);
    }
    for (std::size_t i = 0; i < charts_.size(); ++i) fill(static_cast<AccessiblePlot&>(*plots_[i]), charts_[i]);
}

void ChartsDock::sayWhyEmpty()
{
    const bool some = capability<HasCharts>(museum_.subject(exhibit_)) != nullptr;
    say(some ? tr("Computing the charts …") : tr("This exhibit has no charts."));
}

void ChartsDock::say(const QString& words)
{
    note_->setText(words);
    note_->setVisible(!words.isEmpty());
}

void ChartsDock::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    ask();
}

void ChartsDock::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) draw();
}

}  // namespace vitrine::ui

#include "moc_charts_dock.cpp"

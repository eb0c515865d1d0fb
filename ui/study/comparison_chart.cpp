#include "ui/study/comparison_chart.h"

#include "exhibits/study/study_text.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace vitrine::ui {
namespace {

using study::ComparedCurve;
using study::costTitle;
using study::StudyComparison;
using study::TimesDiffer;

constexpr float faintness = 0.35F;  // Opacity of dominated points.

struct Look {
    const char *onDark, *onLight;
    QCPScatterStyle::ScatterShape mark;
    Qt::PenStyle line;
};

/// Curves differ by mark and line as well as by color, and colors differ in lightness within each half of the list.
constexpr std::array<Look, 8> looks{{{"#d9a05b", "#9a5f14", QCPScatterStyle::ssDisc, Qt::SolidLine},
                                     {"#7fb2e5", "#1f5f99", QCPScatterStyle::ssSquare, Qt::DashLine},
                                     {"#a4c98c", "#3f6b28", QCPScatterStyle::ssTriangle, Qt::DotLine},
                                     {"#d39ae0", "#7d3f8c", QCPScatterStyle::ssDiamond, Qt::DashDotLine},
                                     {"#e98a73", "#a83a22", QCPScatterStyle::ssTriangleInverted, Qt::DashDotDotLine},
                                     {"#66c7be", "#0f6f66", QCPScatterStyle::ssCross, Qt::SolidLine},
                                     {"#e3d26f", "#776a00", QCPScatterStyle::ssPlus, Qt::DashLine},
                                     {"#c9c4bb", "#55504a", QCPScatterStyle::ssStar, Qt::DotLine}}};

ChartSpan spanOf(const ComparedCurve::Point& p)
{
    return {p.cost, p.costLow, p.costHigh, p.error, p.errorLow, p.errorHigh};
}

}  // namespace

ComparisonChart::ComparisonChart(QWidget* parent) : LogChart(parent)
{
    setAccessibleName(tr("Errors over cost of several studies"));
    setMinimumSize(420, 240);
    applyColors();
}

void ComparisonChart::setComparison(StudyComparison comparison)
{
    comparison_ = std::move(comparison);
    setTitles(comparedCostTitle(comparison_.cost), text(title(comparison_.metric)));
    arrange();
}

void ComparisonChart::build()
{
    std::vector<ChartSpan> all;
    for (const ComparedCurve& curve : comparison_.curves)
        std::transform(curve.points.begin(), curve.points.end(), std::back_inserter(all), spanOf);
    legend->setVisible(begin(all));
    if (!legend->visible()) return;
    for (std::size_t i = 0; i < comparison_.curves.size(); ++i) addCurve(i);
    markExact();
}

void ComparisonChart::addCurve(std::size_t index)
{
    const ComparedCurve& curve = comparison_.curves[index];
    const Look& look = looks[index % looks.size()];
    const QColor color(QLatin1String(theme().dark ? look.onDark : look.onLight));
    QColor faint = color;
    faint.setAlphaF(faintness);
    QCPGraph* front = addGraph();
    nameInLegend(*front, curve.leftOut
                             ? tr("%1: left out, because its metric differs").arg(QString::fromStdString(curve.label))
                             : QString::fromStdString(curve.label));
    front->setPen(QPen(color, 2, look.line));
    front->setScatterStyle(
        QCPScatterStyle(look.mark, QPen(color, 1.6), index == 0 ? QBrush(color) : QBrush(theme().base), 9));
    QCPErrorBars* bars = addBars(front, faint);
    QCPGraph* rest = addGraph();
    rest->setLineStyle(QCPGraph::lsNone);
    rest->setScatterStyle(QCPScatterStyle(look.mark, QPen(faint, 1.2), Qt::NoBrush, 6));
    std::vector<ChartSpan> timed;
    for (const ComparedCurve::Point& p : curve.points) {
        (p.onFront ? front : rest)->addData(p.cost, shownError(p.error));
        if (!p.onFront) continue;
        addErrorBar(bars, spanOf(p));
        timed.push_back(spanOf(p));
    }
    addTimes(timed, faint);
}

QString comparedCostTitle(const std::string& cost)
{
    return cost == "ms" ? ComparisonChart::tr("milliseconds of a picture")
                        : ComparisonChart::tr("%1 per pixel").arg(translatedText(costTitle(cost)));
}

QString timesDifferText(TimesDiffer why)
{
    switch (why) {
    case TimesDiffer::no: return {};
    case TimesDiffer::notTaken:
        return ComparisonChart::tr(
            "Not all settings were timed: their work is compared, which counts the same anywhere.");
    case TimesDiffer::unknownMachine:
        return ComparisonChart::tr("Not all files say on which machine they were measured, so their times cannot be "
                                   "compared: their work is, which counts the same anywhere.");
    case TimesDiffer::machine:
        return ComparisonChart::tr("They were measured on different machines, so their times cannot be compared: their "
                                   "work is, which counts the same anywhere.");
    case TimesDiffer::size:
        return ComparisonChart::tr(
            "Their pictures are of different sizes, so their times cannot be compared: their work "
            "per pixel is.");
    case TimesDiffer::surroundings:
        return ComparisonChart::tr("Some were measured in the hall and some alone, so their times cannot be compared: "
                                   "their work is.");
    case TimesDiffer::clock:
        return ComparisonChart::tr("They were timed by different clocks, so their times cannot be compared: their work "
                                   "is, which counts the same anywhere.");
    }
    return {};
}

}  // namespace vitrine::ui

#include "moc_comparison_chart.cpp"

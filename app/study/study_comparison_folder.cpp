#include "app/study/study_comparison_folder.h"

#include "app/study/cost_switch.h"
#include "app/study/offscreen_charts.h"
#include "exhibits/jobs/kit/html_text.h"
#include "exhibits/jobs/kit/part_folder.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/text/escaped.h"
#include "render/text/joined.h"
#include "ui/kit/picture_file.h"
#include "ui/study/comparison_chart.h"
#include "ui/study/comparison_dialog.h"

namespace vitrine::app {
namespace {

using jobs::pageHead;
using study::ComparedCurve;
using study::comparisonCsv;
using study::comparisonJson;
using study::KeptStudy;
using study::StudyComparison;
using study::StudyDifference;
using study::timesDiffer;

std::string studiesTable(const std::vector<KeptStudy>& studies, const StudyComparison& comparison)
{
    std::string text = "<div class=\"sheet scroll\"><table><thead><tr><th>study</th><th>exhibit</th><th>varied</th>"
                       "<th>points</th><th>pixels</th><th>views</th><th>error</th><th>machine</th><th>clock</th>"
                       "<th>measured</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < studies.size(); ++i) {
        const KeptStudy& study = studies[i];
        text += "<tr><td>" + escaped(comparison.curves[i].label) + (comparison.curves[i].leftOut ? " (left out)" : "") +
                "</td>";
        for (const std::string& cell :
             {study.exhibit + (study.alone ? ", alone" : ", in the hall"), study.parameterNames(),
              std::to_string(study.measuredPoints()),
              std::to_string(study.size.x) + " × " + std::to_string(study.size.y), std::to_string(study.views.size()),
              std::string(toString(study.metric)), study.renderer.empty() ? std::string("–") : study.renderer,
              study.clock + (study.clockTrusted ? ", trusted" : ", not trusted"),
              study.measured.empty() ? std::string("–") : study.measured})
            text += "<td>" + escaped(cell) + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string differencesTable(const StudyComparison& comparison, const PageCost& cost)
{
    std::string text = "<div class=\"sheet scroll\"" + shownWith(cost) + "><table><thead><tr>";
    for (const QString& column : ui::differenceColumns(comparison))
        text += "<th>" + escaped(column.toStdString()) + "</th>";
    text += "</tr></thead><tbody>\n";
    for (const StudyDifference& difference : comparison.differences) {
        text += "<tr>";
        for (const QString& cell : ui::differenceTexts(comparison, difference))
            text += "<td>" + escaped(cell.toStdString()) + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

/// Comparison by one cost, with its chart, for the page.
struct ComparisonSheet {
    StudyComparison comparison;
    PageCost cost;
    std::string svg;
};

std::string comparisonPage(const std::vector<KeptStudy>& studies, const std::vector<ComparisonSheet>& sheets)
{
    const std::string names = joined(sheets.front().comparison.curves, ", ", &ComparedCurve::label);
    std::string page = pageHead(names);
    page += "<h1>" + escaped("What accuracy costs: " + names) + "</h1>\n";
    if (const QString why = ui::timesDifferText(timesDiffer(studies)); !why.isEmpty())
        page += "<p class=\"law\">" + escaped(why.toStdString()) + "</p>\n";
    page +=
        "<p class=\"dim\">Errors: " + escaped(std::string(title(sheets.front().comparison.metric))) +
        ", over all views; bars reach from the lowest view to the worst. Between two settings of a front, costs and "
        "errors are taken on logarithmic scales; beyond its ends nothing is said.</p>\n";
    std::vector<PageCost> costs;
    for (const ComparisonSheet& sheet : sheets) costs.push_back(sheet.cost);
    page += "<div class=\"sheet\">" + costButtons(costs);
    for (const ComparisonSheet& sheet : sheets) {
        // HTML allows no XML declaration, so only the svg element is used.
        const std::size_t start = sheet.svg.find("<svg");
        page += "<div class=\"chart\"" + shownWith(sheet.cost) + ">" +
                (start == std::string::npos ? std::string() : sheet.svg.substr(start)) + "</div>";
    }
    page += "</div>\n" + studiesTable(studies, sheets.front().comparison);
    for (const ComparisonSheet& sheet : sheets) page += differencesTable(sheet.comparison, sheet.cost);
    return page + costScript(costs) + "</body>\n</html>\n";
}

}  // namespace

void requireStudyComparisonFolder(const std::filesystem::path& folder)
{
    jobs::requireFolderFor(folder, "study-comparison.json", "a comparison of studies");
}

void writeStudyComparisonFolder(const std::filesystem::path& folder, const std::vector<KeptStudy>& studies,
                                const std::vector<StudyComparison>& comparisons)
{
    requireStudyComparisonFolder(folder);
    prepareOffscreenCharts();
    std::vector<ComparisonSheet> sheets;
    for (const StudyComparison& comparison : comparisons) {
        ui::ComparisonChart chart;
        chart.setComparison(comparison);
        sheets.push_back({comparison,
                          {comparison.cost, ui::comparedCostTitle(comparison.cost).toStdString(), sheets.empty()},
                          chart.svg(studyChartSize).toStdString()});
    }
    const StudyComparison& first = comparisons.front();
    ui::ComparisonChart chart;
    chart.setComparison(first);
    const QByteArray png = ui::pngOf(chart.picture(studyChartSize, studyChartScale));
    requireChart(png, folder);
    jobs::PartFolder part(folder);
    render::atomicWrite(part.path() / "study-comparison.json", render::writeJson(comparisonJson(studies, first)));
    render::atomicWrite(part.path() / "study-comparison.csv", comparisonCsv(first));
    render::atomicWrite(part.path() / "chart.svg", sheets.front().svg);
    render::atomicWrite(part.path() / "chart.png", png.toStdString());
    render::atomicWrite(part.path() / "index.html", comparisonPage(studies, sheets));
    part.publish();
}

}  // namespace vitrine::app

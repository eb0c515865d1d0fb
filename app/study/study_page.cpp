#include "app/study/study_page.h"

#include "exhibits/jobs/kit/html_text.h"
#include "exhibits/study/study_situation.h"
#include "exhibits/study/study_text.h"
#include "render/files/strict_json.h"
#include "render/text/escaped.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::app {
namespace {

using jobs::pageHead;
using jobs::pageNumber;
using jobs::scriptJson;
using jobs::with;
using render::Json;

constexpr const char* script = R"page(<script>
const study = @DATA@;
let view = 0, point = study.first;
const by = id => document.getElementById(id);
function show() {
  const p = study.points[point], v = view + 1;
  document.querySelectorAll("[data-point]").forEach(e => e.classList.toggle("on", +e.dataset.point === point));
  document.querySelectorAll("[data-view]").forEach(e => e.classList.toggle("on", +e.dataset.view === view));
  by("name").textContent = p.text;
  by("reference").src = "pictures/reference-" + v + ".png";
  const name = "pictures/point-" + (point + 1) + "-view-" + v;
  by("pictures").style.visibility = p.pictures ? "visible" : "hidden";
  if (!p.pictures) return;
  by("picture").src = name + ".png";
  by("heat").src = name + "-heat.png";
  by("numbers").textContent = p.numbers[view];
}
function wipeTo(x) {
  const w = by("wipe"), share = Math.min(Math.max((x - w.getBoundingClientRect().left) / w.clientWidth, 0), 1);
  by("reference").style.clipPath = "inset(0 0 0 " + 100 * share + "%)";
  by("edge").style.left = 100 * share + "%";
}
document.querySelectorAll("[data-point]").forEach(e => ["mouseenter", "focus", "click"].forEach(kind => e.addEventListener(kind, () => { point = +e.dataset.point; show(); })));
document.querySelectorAll("[data-view]").forEach(e => e.addEventListener("click", () => { view = +e.dataset.view; show(); }));
by("wipe").addEventListener("pointermove", e => wipeTo(e.clientX));
show();
wipeTo(by("wipe").getBoundingClientRect().left + by("wipe").clientWidth / 2);
</script>
</body>
</html>
)page";

std::string numbersOf(const study::StudyShot& shot)
{
    std::string text;
    for (const auto& [metric, error] : shot.errors)
        text += (text.empty() ? "" : " · ") + std::string(toString(metric)) + ' ' + pageNumber(error, 3);
    return text;
}

std::string marksOf(const study::StudyResult& result, const study::StudyCosts& costs, std::size_t i)
{
    const study::StudyPoint& p = result.points[i];
    const bool dominated = costs.settings[i].cost > 0 && !costs.onFront(i);
    std::string marks;
    for (const auto& [holds, mark] : {std::pair(result.choice && result.choice->point == i, "chosen"),
                                      std::pair(costs.knee == i, "knee"), std::pair(result.present == i, "present"),
                                      std::pair(p.uncertain, "uncertain"), std::pair(dominated, "dominated")})
        if (holds) marks += (marks.empty() ? "" : ", ") + std::string(mark);
    return marks;
}

std::string table(const study::StudyRequest& request, const study::StudyResult& result,
                  const std::vector<StudyPageChart>& charts, const std::vector<StudyPagePoint>& points)
{
    std::string text = "<div class=\"sheet scroll\"><table><thead><tr><th>setting</th><th>" +
                       std::string(toString(request.metric)) + "</th><th>over the views</th>";
    if (request.modelError) text += "<th>against everything exact</th>";
    text += "<th>ms, median</th><th>interval of the median</th><th>spread</th>";
    if (!result.workName.empty()) text += "<th>" + escaped(study::costTitle(result.workName)) + "</th>";
    text += "<th></th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const study::StudyPoint& p = result.points[i];
        std::string row = "<tr tabindex=\"0\" data-point=\"" + std::to_string(i) + "\"><td>" + escaped(points[i].text) +
                          "</td><td>" + pageNumber(p.error) + "</td><td>" + pageNumber(p.lowestError, 3) + " to " +
                          pageNumber(p.worstError, 3) + "</td>";
        if (request.modelError) row += "<td>" + (p.modelError ? pageNumber(*p.modelError) : std::string("–")) + "</td>";
        if (p.time)
            row += "<td>" + pageNumber(p.time->median) + "</td><td>" + pageNumber(p.time->interval.low, 3) + " to " +
                   pageNumber(p.time->interval.high, 3) + " (" + pageNumber(100 * p.time->interval.confidence, 3) +
                   " %)</td><td>" + pageNumber(p.time->spread, 2) + "</td>";
        else
            row += "<td>–</td><td>–</td><td>–</td>";
        if (const auto count = p.counters.find(result.workName); count != p.counters.end())
            row += "<td>" + pageNumber(static_cast<double>(count->second), 12) + "</td>";
        else if (!result.workName.empty())
            row += "<td>–</td>";
        row += "<td>";
        for (const StudyPageChart& chart : charts)
            row += "<span" + shownWith(chart.cost) + ">" +
                   escaped(marksOf(result, study::costsAlong(chart.axis, request, result), i)) + "</span>";
        text += row + "</td></tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::vector<PageCost> costsOf(const std::vector<StudyPageChart>& charts)
{
    std::vector<PageCost> costs;
    for (const StudyPageChart& chart : charts) costs.push_back(chart.cost);
    return costs;
}

/// Returns the buttons that choose the cost axis, if there is a choice, and a chart for each axis.
std::string chartsOf(const std::vector<StudyPageChart>& charts, glm::ivec2 size,
                     const std::vector<StudyPagePoint>& points)
{
    std::string page = "<div class=\"sheet\">" + costButtons(costsOf(charts));
    for (const StudyPageChart& chart : charts) {
        // HTML allows no XML declaration, so only the svg element is used.
        const std::size_t start = chart.svg.find("<svg");
        page += "<div class=\"chart\"" + shownWith(chart.cost) + ">" +
                (start == std::string::npos ? std::string() : chart.svg.substr(start)) +
                "<svg class=\"spots\" viewBox=\"0 0 " + std::to_string(size.x) + ' ' + std::to_string(size.y) + "\">";
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const auto& place = chart.places[i])
                page += "<circle data-point=\"" + std::to_string(i) + "\" cx=\"" + pageNumber(place->x, 6) +
                        "\" cy=\"" + pageNumber(place->y, 6) + "\" r=\"11\"><title>" + escaped(points[i].text) +
                        "</title></circle>";
        page += "</svg></div>";
    }
    return page + "</div>\n";
}

}  // namespace

std::string studyPage(Subjects subjects, const study::StudyRequest& request, const study::StudyResult& result,
                      const std::vector<StudyPageChart>& charts, glm::ivec2 chartSize,
                      const std::vector<StudyPagePoint>& points)
{
    const SceneObject& subject = *subjects[request.subject];
    const std::string title =
        std::string(subject.title()) + ": what " +
        (request.axes.size() > 2 ? std::string("accuracy") : study::axisLabels(subjects, request)) + " costs";

    std::string page = pageHead(title);
    page += "<h1>" + escaped(title) + "</h1>\n";
    page += "<p class=\"dim\">" + std::to_string(request.size.x) + " × " + std::to_string(request.size.y) +
            " pixels, " + std::to_string(result.views.size()) + (result.views.size() == 1 ? " view, " : " views, ") +
            (request.alone ? "alone" : "in the hall") + ", " + std::to_string(request.runs) +
            " interleaved runs after one that was not timed. Clock: " + escaped(result.clock) +
            (result.clockTrusted ? ", trusted" : ", not trusted") + "; taking a time adds " +
            pageNumber(1000 * result.overheadMilliseconds, 2) + " µs to a picture.</p>\n";
    page += "<p class=\"dim\">" + escaped(result.convergence) + "</p>\n";
    for (const std::string& sentence :
         study::situationSentences(subjects, request, result, study::ParameterNames::shown))
        page += "<p class=\"dim\">" + escaped(sentence) + "</p>\n";
    for (const StudyPageChart& chart : charts)
        if (const std::string law = study::lawSentence(study::costsAlong(chart.axis, request, result)); !law.empty())
            page += "<p class=\"law\"" + shownWith(chart.cost) + ">" + escaped(law) + "</p>\n";
    if (const std::string choice = study::choiceSentence(subjects, request, result); !choice.empty())
        page += "<p class=\"law\">" + escaped(choice) + "</p>\n";

    page += chartsOf(charts, chartSize, points) + "<div class=\"sheet\"><nav>";
    for (std::size_t v = 0; v < result.views.size(); ++v)
        page += "<button data-view=\"" + std::to_string(v) + "\">" + escaped(result.views[v]) + "</button>";
    page += "</nav><div class=\"pictures\" id=\"pictures\"><figure><div class=\"wipe\" id=\"wipe\"><img id=\"picture\" "
            "alt=\"The setting\"><img id=\"reference\" class=\"over\" alt=\"The reference\"><i id=\"edge\"></i></div>"
            "<figcaption>Left of the line: <b id=\"name\"></b>; right of it: the reference.</figcaption></figure>"
            "<figure><img id=\"heat\" alt=\"Where they differ\"><figcaption>Where they differ, one scale for all "
            "settings of a view. <span id=\"numbers\"></span></figcaption></figure></div></div>\n";
    page += table(request, result, charts, points);

    const auto shown =
        std::find_if(charts.begin(), charts.end(), [](const StudyPageChart& chart) { return chart.cost.shown; });
    const study::StudyCosts costs = study::costsAlong(shown->axis, request, result);
    const std::size_t best = costs.knee.value_or(costs.front.empty() ? 0 : costs.front.front());
    Json data{{"first", result.choice ? result.choice->point : result.present.value_or(best)},
              {"points", Json::array()}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        Json numbers = Json::array();
        for (const study::StudyShot& shot : result.points[i].shots) numbers.push_back(numbersOf(shot));
        data["points"].push_back(
            Json{{"text", points[i].text}, {"pictures", points[i].hasPictures}, {"numbers", numbers}});
    }
    return page + costScript(costsOf(charts)) + with(script, "@DATA@", scriptJson(data));
}

}  // namespace vitrine::app

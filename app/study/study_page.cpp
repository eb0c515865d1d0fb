#include "app/study/study_page.h"

#include "app/html_text.h"
#include "exhibits/study/study_text.h"
#include "render/files/strict_json.h"

#include <cmath>

namespace vitrine::app {
namespace {

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

std::string numbersOf(const StudyShot& shot)
{
    std::string text;
    for (const auto& [metric, error] : shot.errors)
        text += (text.empty() ? "" : " · ") + std::string(toString(metric)) + ' ' + pageNumber(error, 3);
    return text;
}

std::string table(const StudyRequest& request, const StudyResult& result, const std::vector<StudyPagePoint>& points)
{
    std::string text = "<div class=\"sheet scroll\"><table><thead><tr><th>setting</th><th>" +
                       std::string(toString(request.metric)) + "</th><th>over the views</th>";
    if (request.modelError) text += "<th>against everything exact</th>";
    if (result.costName != "ms") text += "<th>" + escaped(costTitle(result.costName)) + "</th>";
    text += "<th>ms, median</th><th>interval of the median</th><th>spread</th><th></th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const StudyPoint& p = result.points[i];
        std::string row = "<tr tabindex=\"0\" data-point=\"" + std::to_string(i) + "\"" +
                          (p.dominated ? " class=\"dominated\"" : "") + "><td>" + escaped(points[i].text) +
                          "</td><td>" + pageNumber(p.error) + "</td><td>" + pageNumber(p.lowestError, 3) + " to " +
                          pageNumber(p.worstError, 3) + "</td>";
        if (request.modelError) row += "<td>" + pageNumber(p.modelError) + "</td>";
        if (result.costName != "ms") row += "<td>" + pageNumber(p.cost, 12) + "</td>";
        if (p.time)
            row += "<td>" + pageNumber(p.time->median) + "</td><td>" + pageNumber(p.time->interval.low, 3) + " to " +
                   pageNumber(p.time->interval.high, 3) + " (" + pageNumber(100 * p.time->interval.confidence, 3) +
                   " %)</td><td>" + pageNumber(p.time->spread, 2) + "</td>";
        else
            row += "<td>–</td><td>–</td><td>–</td>";
        std::string marks;
        for (const auto& [holds, mark] :
             {std::pair(result.choice && result.choice->point == i, "chosen"), std::pair(result.knee == i, "knee"),
              std::pair(result.present == i, "present"), std::pair(p.uncertain, "uncertain"),
              std::pair(p.dominated, "dominated")})
            if (holds) marks += (marks.empty() ? "" : ", ") + std::string(mark);
        text += row + "<td>" + marks + "</td></tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

}  // namespace

std::string studyPage(Subjects subjects, const StudyRequest& request, const StudyResult& result,
                      const std::string& chartSvg, glm::ivec2 chartSize, const std::vector<StudyPagePoint>& points)
{
    const Subject& subject = *subjects[request.subject];
    std::string names;
    for (const StudyAxis& axis : request.axes)
        names += (names.empty() ? "" : ", ") + axisName(subjects, request.sceneState, request.subject, axis);
    const std::string title = std::string(subject.title()) + ": what " +
                              (request.axes.size() > 2 ? std::string("accuracy") : names) + " costs";

    std::string page = pageHead(title);
    page += "<h1>" + escaped(title) + "</h1>\n";
    page += "<p class=\"dim\">" + std::to_string(request.size.x) + " × " + std::to_string(request.size.y) +
            " pixels, " + std::to_string(result.views.size()) + (result.views.size() == 1 ? " view, " : " views, ") +
            (request.alone ? "alone" : "in the hall") + ", " + std::to_string(request.runs) +
            " interleaved runs after one that was not timed. Clock: " + escaped(result.clock) +
            (result.clockTrusted ? ", trusted" : ", not trusted") + "; taking a time adds " +
            pageNumber(1000 * result.overheadMilliseconds, 2) + " µs to a picture.</p>\n";
    page += "<p class=\"dim\">" + escaped(result.convergence) + "</p>\n";
    if (const std::string law = lawSentence(result); !law.empty())
        page += "<p class=\"law\">" + escaped(law) + "</p>\n";
    if (const std::string choice = choiceSentence(subjects, request, result); !choice.empty())
        page += "<p class=\"law\">" + escaped(choice) + "</p>\n";

    // The drawing alone: within HTML there is no place for an XML declaration.
    const std::size_t start = chartSvg.find("<svg");
    page += "<div class=\"sheet\"><div class=\"chart\">" +
            (start == std::string::npos ? std::string() : chartSvg.substr(start));
    page +=
        "<svg class=\"spots\" viewBox=\"0 0 " + std::to_string(chartSize.x) + ' ' + std::to_string(chartSize.y) + "\">";
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].place.x) && std::isfinite(points[i].place.y))
            page += "<circle data-point=\"" + std::to_string(i) + "\" cx=\"" + pageNumber(points[i].place.x, 6) +
                    "\" cy=\"" + pageNumber(points[i].place.y, 6) + "\" r=\"11\"><title>" + escaped(points[i].text) +
                    "</title></circle>";
    page += "</svg></div></div>\n<div class=\"sheet\"><nav>";
    for (std::size_t v = 0; v < result.views.size(); ++v)
        page += "<button data-view=\"" + std::to_string(v) + "\">" + escaped(result.views[v]) + "</button>";
    page += "</nav><div class=\"pictures\" id=\"pictures\"><figure><div class=\"wipe\" id=\"wipe\"><img id=\"picture\" "
            "alt=\"The setting\"><img id=\"reference\" class=\"over\" alt=\"The reference\"><i id=\"edge\"></i></div>"
            "<figcaption>Left of the line: <b id=\"name\"></b>; right of it: the reference.</figcaption></figure>"
            "<figure><img id=\"heat\" alt=\"Where they differ\"><figcaption>Where they differ, one scale for all "
            "settings of a view. <span id=\"numbers\"></span></figcaption></figure></div></div>\n";
    page += table(request, result, points);

    Json data{{"first", result.choice ? result.choice->point
                                      : result.present.value_or(
                                            result.knee.value_or(result.front.empty() ? 0 : result.front.front()))},
              {"points", Json::array()}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        Json numbers = Json::array();
        for (const StudyShot& shot : result.points[i].shots) numbers.push_back(numbersOf(shot));
        data["points"].push_back(
            Json{{"text", points[i].text}, {"pictures", points[i].hasPictures}, {"numbers", numbers}});
    }
    return page + with(script, "@DATA@", scriptJson(data));
}

}  // namespace vitrine::app

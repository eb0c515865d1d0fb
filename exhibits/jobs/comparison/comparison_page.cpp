#include "exhibits/jobs/comparison/comparison_page.h"

#include "exhibits/jobs/comparison/comparison_table.h"
#include "exhibits/jobs/kit/html_text.h"
#include "render/text/escaped.h"

#include <cmath>

namespace vitrine::jobs {
namespace {

constexpr const char* comparisonBody =
    R"page(<div class="sheet"><nav id="modes"><button data-mode="wipe">Wipe</button><button data-mode="beside">Side by side</button><button data-mode="flicker">Flicker</button><button data-mode="flip">FLIP</button><button data-mode="signed">Signed difference</button>
<label id="gains">times <input id="gain" type="range" min="0" max="6" step="1" aria-label="Gain of the differences"> <b id="times"></b></label></nav>
<div id="stage" class="wipe"><img id="a" src="pictures/a.png" alt="A"><img id="b" class="over" src="pictures/b.png" alt="B"><img id="d" class="over" alt="Where they differ"><i id="edge"></i></div>
<p class="dim" id="caption"></p></div>
)page";

constexpr const char* comparisonScript = R"page(<style>
#stage.beside { display: grid; grid-template-columns: 1fr 1fr; gap: 4px; background: none; cursor: default; }
#stage.beside img.over { position: static; }
#stage.flicker, #stage.flip, #stage.signed { cursor: default; }
#stage img { width: 100%; height: auto; }
tr.one td { color: var(--accent); }
tr.idle td { color: var(--dim); }
td.why { text-align: left; color: var(--dim); width: 45%; }
summary { cursor: pointer; color: var(--dim); padding: 8px 10px; }
tbody tr { cursor: default; }
h2 { font-size: 17px; font-weight: 600; margin: 0 0 8px; }
td:first-child { overflow-wrap: anywhere; }
#gains { margin-left: auto; display: flex; align-items: center; gap: 6px; }
</style>
<script>
const compared = @DATA@;
const by = id => document.getElementById(id), stage = by("stage");
let mode = "wipe", showsB = false, share = 0.5;
const captions = {
  wipe: "Left of the line A, right of it B; drag it.",
  beside: "A on the left, B on the right.",
  flicker: "A; hold the picture or the key B to see B.",
  flip: "Where an eye that flips between the two sees a difference (FLIP): black none, white one divided by the factor and more.",
  signed: "Gray where both are equal; brighter or darker where B is, times the factor." };
function show() {
  stage.className = "wipe " + mode;
  document.querySelectorAll("[data-mode]").forEach(e => e.classList.toggle("on", e.dataset.mode === mode));
  const gain = compared.gains[by("gain").value], differs = mode === "flip" || mode === "signed";
  by("times").textContent = gain;
  by("gains").style.visibility = differs ? "visible" : "hidden";
  by("d").style.display = differs && !showsB ? "block" : "none";
  if (differs) by("d").src = "pictures/" + mode + "-" + gain + ".png";
  by("b").style.display = mode === "wipe" || mode === "beside" || showsB ? "block" : "none";
  by("b").style.clipPath = mode === "wipe" && !showsB ? "inset(0 0 0 " + 100 * share + "%)" : "none";
  by("edge").style.display = mode === "wipe" && !showsB ? "block" : "none";
  by("edge").style.left = 100 * share + "%";
  by("caption").textContent = showsB && mode !== "beside" ? "B" : captions[mode];
}
function showB(on) { showsB = on; show(); }
document.querySelectorAll("[data-mode]").forEach(e => e.addEventListener("click", () => { mode = e.dataset.mode; show(); }));
by("gain").value = compared.gains.indexOf(compared.gain);
by("gain").addEventListener("input", show);
stage.addEventListener("pointermove", e => {
  if (mode !== "wipe") return;
  const box = stage.getBoundingClientRect();
  share = Math.min(Math.max((e.clientX - box.left) / box.width, 0), 1);
  show();
});
stage.addEventListener("pointerdown", () => { if (mode === "flicker") showB(true); });
["pointerup", "pointerleave"].forEach(kind => stage.addEventListener(kind, () => showB(false)));
addEventListener("keydown", e => { if (e.key === "b") showB(true); });
addEventListener("keyup", e => { if (e.key === "b") showB(false); });
show();
</script>
</body>
</html>
)page";

std::string msText(const compare::PassSide& side)
{
    if (side.state == compare::PassSide::State::absent) return "–";
    if (side.state == compare::PassSide::State::skipped) return "skipped";
    return side.milliseconds < 0 ? "ran" : pageNumber(side.milliseconds);
}

/// Returns the reason once if it is the same for A and B, otherwise each reason.
std::string whyText(const compare::PassCost& cost)
{
    if (cost.a.why == cost.b.why || cost.b.why.empty()) return cost.a.why;
    if (cost.a.why.empty()) return cost.b.why;
    return "A: " + cost.a.why + ". B: " + cost.b.why;
}

std::string passRow(const compare::PassCost& cost)
{
    return std::string(cost.ranInOnlyOne() ? "<tr class=\"one\">" : "<tr>") + "<td>" + escaped(cost.name) +
           "</td><td>" + msText(cost.a) + "</td><td>" + msText(cost.b) + "</td><td class=\"why\">" +
           escaped(whyText(cost)) + "</td></tr>\n";
}

std::string costTable(const compare::ComparisonResult& result)
{
    const render::FrameReport& first = result.sides[0].report;
    std::string text = "<div class=\"sheet scroll\"><h2>What a frame costs</h2><p class=\"dim\">Milliseconds by: " +
                       escaped(first.clock) + (first.clockTrusted ? "" : ", not trusted") +
                       ". What only one of them runs is set apart.</p><table><thead><tr><th>pass</th><th>A, ms</th>"
                       "<th>B, ms</th><th></th></tr></thead><tbody>\n";
    if (result.sides[0].time && result.sides[1].time)
        text += "<tr><td><b>whole frame, median of " + std::to_string(result.sides[0].time->runs) + "</b></td><td><b>" +
                pageNumber(result.sides[0].time->median) + "</b></td><td><b>" +
                pageNumber(result.sides[1].time->median) + "</b></td><td></td></tr>\n";
    std::string idle;
    std::size_t idles = 0;
    for (const compare::PassCost& cost : result.passes) {
        const bool ran = cost.a.state == compare::PassSide::State::ran || cost.b.state == compare::PassSide::State::ran;
        (ran ? text : idle) += passRow(cost);
        idles += ran ? 0 : 1;
    }
    text += "</tbody></table>\n";
    if (idles > 0)
        text += "<details><summary>" + std::to_string(idles) + " passes that neither runs</summary><table><tbody>\n" +
                idle + "</tbody></table></details>\n";
    text += "</div>\n<div class=\"sheet scroll\"><h2>What a frame counts</h2><table><thead><tr>"
            "<th>counter</th><th>A</th><th>B</th></tr></thead><tbody>\n";
    const auto count = [](const std::optional<std::int64_t>& n) { return n ? std::to_string(*n) : std::string("–"); };
    for (const compare::CounterCost& cost : result.counters)
        text += std::string(cost.a == cost.b ? "<tr>" : "<tr class=\"one\">") + "<td>" + escaped(cost.name) +
                "</td><td>" + count(cost.a) + "</td><td>" + count(cost.b) + "</td></tr>\n";
    return text + "</tbody></table></div>\n";
}

std::string parameterTable(Subjects subjects, const std::vector<compare::DifferingParameter>& rows)
{
    if (rows.empty()) return "<div class=\"sheet\"><h2>A and B are identical</h2></div>\n";
    std::string text = "<div class=\"sheet scroll\"><h2>" + std::to_string(rows.size()) +
                       (rows.size() == 1 ? " parameter differs" : " parameters differ") +
                       "</h2><table><thead><tr><th>parameter</th><th>A</th><th>B</th><th></th></tr></thead><tbody>\n";
    for (const compare::DifferingParameter& row : rows) {
        const auto value = [&](const std::optional<Value>& v) {
            return v ? escaped(compare::valueWithUnit(row.info, *v)) : std::string("no such parameter");
        };
        const bool idle = !row.actsInA && !row.actsInB;
        text += std::string(idle ? "<tr class=\"idle\">" : "<tr>") + "<td title=\"" +
                escaped(std::string(row.info.help)) + "\">" +
                escaped(std::string(subjects[row.subject]->title()) + ": " + label(row.info)) + "</td><td>" +
                value(row.a) + "</td><td>" + value(row.b) + "</td><td class=\"why\">" +
                (idle                         ? "acts in neither"
                 : row.actsInA && row.actsInB ? ""
                 : row.actsInA                ? "acts in A only"
                                              : "acts in B only") +
                "</td></tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

}  // namespace

std::string comparisonPage(Subjects subjects, const compare::Comparison& comparison, const ComparisonText& text)
{
    const compare::ComparisonRequest& request = comparison.request();
    const compare::ComparisonResult& result = comparison.result();
    std::string page = pageHead(text.names[0] + " beside " + text.names[1]);
    page += "<h1>A: " + escaped(text.names[0]) + " · B: " + escaped(text.names[1]) + "</h1>\n";
    const glm::ivec2 size = request.frame.raster.size;
    page += "<p class=\"dim\">" + std::to_string(size.x) + " × " + std::to_string(size.y) + " pixels, " +
            std::to_string(request.samples[0]) + " and " + std::to_string(request.samples[1]) +
            " samples per pixel, one camera, one moment, one seed.</p>\n<p class=\"law\">";
    std::string errors;
    for (const auto& [metric, error] : result.errors)
        errors += (errors.empty() ? "" : " · ") + std::string(toString(metric)) + ' ' +
                  (std::isfinite(error) ? pageNumber(error, 3) : std::string("infinite"));
    page += escaped(errors) + "</p>\n" + comparisonBody + costTable(result) + parameterTable(subjects, result.rows);
    render::Json gains = render::Json::array();
    for (const int gain : comparisonGains) gains.push_back(gain);
    return page + with(comparisonScript, "@DATA@", scriptJson(render::Json{{"gains", gains}, {"gain", text.gain}}));
}

}  // namespace vitrine::jobs

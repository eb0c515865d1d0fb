#include "app/study/cost_switch.h"

#include "render/text/escaped.h"

namespace vitrine::app {
namespace {

constexpr const char* costSwitch = R"page(<script>
document.querySelectorAll("[data-cost]").forEach(button => button.addEventListener("click", () => {
  document.querySelectorAll("[data-with-cost]").forEach(e => e.hidden = e.dataset.withCost !== button.dataset.cost);
  document.querySelectorAll("[data-cost]").forEach(e => {
    e.classList.toggle("on", e === button);
    e.setAttribute("aria-pressed", e === button);
  });
}));
</script>
)page";

}  // namespace

std::string costButtons(const std::vector<PageCost>& costs)
{
    if (costs.size() < 2) return {};
    std::string page = "<nav aria-label=\"Costs of the chart\">";
    for (const PageCost& cost : costs)
        page += "<button data-cost=\"" + escaped(cost.name) + "\" aria-pressed=\"" + (cost.shown ? "true" : "false") +
                "\"" + (cost.shown ? " class=\"on\"" : "") + ">" + escaped(cost.title) + "</button>";
    return page + "</nav>\n";
}

std::string shownWith(const PageCost& cost)
{
    return " data-with-cost=\"" + escaped(cost.name) + "\"" + (cost.shown ? "" : " hidden");
}

std::string costScript(const std::vector<PageCost>& costs)
{
    return costs.size() < 2 ? std::string() : costSwitch;
}

}  // namespace vitrine::app

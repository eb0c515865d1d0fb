#pragma once

#include <string>
#include <vector>

namespace vitrine::app {

/// Cost that the reader of a page can choose for the chart.
struct PageCost {
    std::string name;    ///< Name: "ms", or a counter.
    std::string title;   ///< Title for people.
    bool shown = false;  ///< Shown at first; true for one of them.
};

/// Returns a button for each cost; empty for fewer than two.
[[nodiscard]] std::string costButtons(const std::vector<PageCost>&);
/// Returns the attributes of an element that is shown while this cost is chosen.
[[nodiscard]] std::string shownWith(const PageCost&);
/// Returns the script element of the buttons, for the end of a page; empty for fewer than two costs.
[[nodiscard]] std::string costScript(const std::vector<PageCost>&);

}  // namespace vitrine::app

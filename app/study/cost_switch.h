#pragma once

#include <string>
#include <vector>

namespace vitrine::app {

/// A cost that the reader of a page can choose for its chart.
struct PageCost {
    std::string name;    ///< "ms", or a counter.
    std::string title;   ///< For people.
    bool shown = false;  ///< At first; one of them is.
};

/// One button for each cost; empty for fewer than two.
[[nodiscard]] std::string costButtons(const std::vector<PageCost>&);
/// Attributes of an element that is shown while this cost is chosen.
[[nodiscard]] std::string shownWith(const PageCost&);
/// A script element that makes the buttons work, for the end of a page; empty for fewer than two costs.
[[nodiscard]] std::string costScript(const std::vector<PageCost>&);

}  // namespace vitrine::app

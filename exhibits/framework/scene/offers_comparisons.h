#pragma once

#include "exhibits/framework/scene/capabilities.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// Comparison that an exhibit offers.
struct OfferedComparison {
    std::string name;   ///< Name on the command line: "mesh".
    std::string title;  ///< "The rasterized mesh".
    std::string help;   ///< One sentence: what to look at.
    /// Parameters with the values of B, the other side.
    std::vector<std::pair<std::string_view, Value>> rows;
};

/// Capability: offers comparisons with another setting of itself.
class OffersComparisons {
public:
    virtual ~OffersComparisons() = default;
    /// Returns always the same list, with unique names.
    [[nodiscard]] virtual std::vector<OfferedComparison> comparisons() const = 0;
};

}  // namespace vitrine

#pragma once

#include "exhibits/framework/capabilities.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// Something that an exhibit is worth being compared with.
struct OfferedComparison {
    std::string name;   ///< On the command line: "mesh".
    std::string title;  ///< "The rasterized mesh".
    std::string help;   ///< One sentence: what to look at.
    /// The rows in which B, the other side, is another one than what is on show.
    std::vector<std::pair<std::string_view, Value>> rows;
};

/// Offers comparisons with itself in another way.
class OffersComparisons {
public:
    virtual ~OffersComparisons() = default;
    /// The same at any time, with names of their own.
    [[nodiscard]] virtual std::vector<OfferedComparison> comparisons() const = 0;
};

}  // namespace vitrine

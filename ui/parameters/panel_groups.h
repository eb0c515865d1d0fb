#pragma once

#include "exhibits/framework/table/parameters.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace vitrine::ui {

/// Heading of a parameter panel, and the parameters under it.
struct PanelGroup {
    enum class Kind : std::uint8_t { essentials, pinned, table };

    Kind kind = Kind::table;
    std::string_view title = {};            ///< Title of the group in the table, or "Essentials" or "Pinned".
    std::vector<std::size_t> rows = {};     ///< Parameters that are shown under the heading.
    std::vector<std::size_t> members = {};  ///< All parameters of the group, with those that are shown further up.
    bool foldedAtFirst = false;
};

/// Arranges the parameters of a table for a panel: first the essential ones, then those that `isPinned` names, then the
/// others by the groups of the table, folded. A table without essential parameters keeps its groups, unfolded, and
/// ignores pins. A group is left out if all its parameters are shown further up.
[[nodiscard]] std::vector<PanelGroup> panelGroups(std::span<const ParameterInfo>,
                                                  const std::function<bool(std::size_t row)>& isPinned);

}  // namespace vitrine::ui

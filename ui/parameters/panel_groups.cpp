#include "ui/parameters/panel_groups.h"

#include <algorithm>
#include <utility>

namespace vitrine::ui {

std::vector<PanelGroup> panelGroups(std::span<const ParameterInfo> rows,
                                    const std::function<bool(std::size_t row)>& isPinned)
{
    PanelGroup essentials{PanelGroup::Kind::essentials, "Essentials"};
    PanelGroup pinned{PanelGroup::Kind::pinned, "Pinned"};
    const bool sorted =
        std::any_of(rows.begin(), rows.end(), [](const ParameterInfo& parameter) { return parameter.essential; });
    std::vector<PanelGroup> groups;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i].group != rows[i - 1].group)
            groups.push_back({PanelGroup::Kind::table, rows[i].group, {}, {}, sorted && !rows[i].group.empty()});
        groups.back().members.push_back(i);
        PanelGroup& shown = rows[i].essential ? essentials : sorted && isPinned(i) ? pinned : groups.back();
        shown.rows.push_back(i);
    }
    essentials.members = essentials.rows;
    pinned.members = pinned.rows;
    groups.insert(groups.begin(), {std::move(essentials), std::move(pinned)});
    std::erase_if(groups, [](const PanelGroup& group) { return group.rows.empty(); });
    return groups;
}

}  // namespace vitrine::ui

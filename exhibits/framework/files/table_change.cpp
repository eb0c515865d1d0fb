#include "exhibits/framework/files/table_change.h"

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/framework/time/motion_json.h"

#include <utility>

namespace vitrine {

ParameterValues underTable(const ParameterValues& values, std::shared_ptr<const Parameters> table,
                           std::vector<std::string>& notes)
{
    ParameterValues result(std::move(table));
    ParameterValues::PendingParameters pending = values.pending(), pendingMotions = values.pendingMotions();
    for (std::size_t i = 0; i < result.rows().size(); ++i) {
        const ParameterInfo& row = result.rows()[i];
        if (const auto here = values.table().find(row.name)) {
            if (values.rows()[*here].kind != row.kind) continue;
            if (!values.isInitial(*here)) result.setParameter(i, values.row(*here));
            if (const Motion* motion = values.motion(*here)) result.setMotion(i, *motion);
        } else if (const auto written = pending.find(std::string(row.name)); written != pending.end()) {
            if (const auto value = valueFromText(row, written->second, notes)) result.setParameter(i, *value);
            pending.erase(written);
        }
        const auto moved = pendingMotions.find(std::string(row.name));
        if (moved == pendingMotions.end()) continue;
        if (const auto motion = motionFromText(row, moved->second, notes)) result.setMotion(i, *motion);
        pendingMotions.erase(moved);
    }
    result.setPending(std::move(pending));
    result.setPendingMotions(std::move(pendingMotions));
    return result;
}

ParameterValues withTableOf(const ParameterValues& other, const ParameterValues& values)
{
    if (values.sharedTable() == other.sharedTable() || values.tableFiles() != other.tableFiles()) return values;
    std::vector<std::string> notes;
    return underTable(values, other.sharedTable(), notes);
}

}  // namespace vitrine

#include "exhibits/your_shader/guest_input.h"

#include "exhibits/your_shader/guest_keys.h"
#include "exhibits/your_shader/guest_work.h"

#include <algorithm>
#include <cmath>

namespace vitrine::guest {
namespace {

constexpr std::size_t mouseGrip = 0;  ///< A point has the index of its input, plus 1.

/// Returns whether an input is a point with a place in the picture.
bool isPlaced(const YourShaderTable& table, std::size_t input)
{
    return table.work->shader->inputs[input].type == InputType::point && table.ofInputs[input].size() == 2;
}

/// Limits of a component of a point.
glm::dvec2 endsOf(const Input& input, std::size_t axis)
{
    const double low = input.low[axis], high = input.high[axis];
    return {low, high > low ? high : low + 1};
}

}  // namespace

std::optional<std::size_t> gripAt(const YourShaderTable& table, const ParameterValues& values, const glm::dvec2& place,
                                  const glm::dvec2& reach)
{
    if (!table.work) return std::nullopt;
    std::optional<std::size_t> found;
    double nearest = 1;
    for (std::size_t i = 0; i < table.ofInputs.size(); ++i) {
        if (!isPlaced(table, i)) continue;
        glm::dvec2 at(0);
        for (const std::size_t axis : {0U, 1U}) {
            const glm::dvec2 ends = endsOf(table.work->shader->inputs[i], axis);
            const double value = std::get<double>(values.row(table.ofInputs[i][axis]));
            at[static_cast<int>(axis)] = (value - ends.x) / (ends.y - ends.x);
        }
        if (const double distance = glm::length((place - at) / reach); distance < nearest) {
            nearest = distance;
            found = i + 1;
        }
    }
    if (!found && table.work->readsMouse) found = mouseGrip;
    return found;
}

ParameterChanges pointedAt(const YourShaderTable& table, std::size_t grip, PointerEvent event, const glm::dvec2& place)
{
    if (!table.work || grip > table.ofInputs.size()) return {};
    if (grip != mouseGrip) {
        ParameterChanges changes;
        for (const std::size_t axis : {0U, 1U}) {
            const glm::dvec2 ends = endsOf(table.work->shader->inputs[grip - 1], axis);
            changes.emplace_back(table.ofInputs[grip - 1][axis],
                                 glm::mix(ends.x, ends.y, place[static_cast<int>(axis)]));
        }
        return changes;
    }
    ParameterChanges changes{{table.mouseX.row, place.x},
                             {table.mouseY.row, place.y},
                             {table.mouseDown.row, event == PointerEvent::release ? 0.0 : 1.0}};
    if (event == PointerEvent::press) {
        changes.emplace_back(table.pressX.row, place.x);
        changes.emplace_back(table.pressY.row, place.y);
    }
    return changes;
}

ParameterChanges keyedAt(const YourShaderTable& table, const ParameterValues& values, int code, bool isDown,
                         double time)
{
    return {{table.keys.row, withKey(values[table.keys], code, isDown, time)}};
}

std::optional<ParameterChanges> pushedAt(const YourShaderTable& table, const ParameterValues& values,
                                         std::size_t parameter, double time)
{
    for (std::size_t i = 0; table.work && i < table.ofInputs.size(); ++i) {
        if (table.work->shader->inputs[i].type != InputType::event || table.ofInputs[i].front() != parameter) continue;
        const double rate = values[table.rate];
        const double next = (std::floor(std::max(time, 0.0) * rate + 1e-6) + 1) / rate;
        ParameterChanges changes{{parameter, next}};
        if (!values[table.animate]) changes.emplace_back(table.moment.row, next);
        return changes;
    }
    return std::nullopt;
}

}  // namespace vitrine::guest

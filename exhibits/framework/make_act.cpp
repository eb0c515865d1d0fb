#include "exhibits/framework/make_act.h"

#include <algorithm>
#include <optional>

namespace vitrine {
namespace {

bool isAmong(const Condition& condition, double x)
{
    return std::find(condition.values.begin(), condition.values.end(), x) != condition.values.end();
}

/// Returns a value of the parameter that satisfies the condition's test: the initial one if it does.
std::optional<double> satisfying(const Condition& condition, const ParameterInfo& row)
{
    const auto* initial = std::get_if<double>(&row.initial);
    if (!initial) return std::nullopt;
    switch (condition.test) {
    case Condition::Test::among: return isAmong(condition, *initial) ? *initial : condition.values.front();
    case Condition::Test::differs: {
        double other = isAmong(condition, *initial) ? row.range.low : *initial;
        while (isAmong(condition, other)) ++other;
        return other;
    }
    case Condition::Test::above:
        if (*initial > condition.values.front()) return *initial;
        if (row.range.softHigh > condition.values.front()) return row.range.softHigh;
        return row.range.high;
    case Condition::Test::given:
    case Condition::Test::all:
    case Condition::Test::any: break;
    }
    return std::nullopt;
}

std::size_t changes(const ParameterValues& from, const ParameterValues& to)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < from.rows().size(); ++i) count += from.row(i) != to.row(i) ? 1 : 0;
    return count;
}

void satisfy(ParameterValues& values, const Condition& condition, std::span<const std::size_t> fixed)
{
    if (holds(condition, values)) return;
    if (condition.test == Condition::Test::all) {
        for (const Condition& part : condition.parts) satisfy(values, part, fixed);
        return;
    }
    if (condition.test == Condition::Test::any) {
        std::optional<ParameterValues> best;
        for (const Condition& part : condition.parts) {
            ParameterValues tried = values;
            satisfy(tried, part, fixed);
            if (!holds(part, tried)) continue;
            if (!best || changes(values, tried) < changes(values, *best)) best = std::move(tried);
        }
        if (best) values = std::move(*best);
        return;
    }
    const std::optional<std::size_t> row = values.table().find(condition.row);
    if (!row) return;
    if (const std::optional<Condition>& own = values.rows()[*row].actsWhen) satisfy(values, *own, fixed);
    if (holds(condition, values) || std::find(fixed.begin(), fixed.end(), *row) != fixed.end()) return;
    if (const std::optional<double> value = satisfying(condition, values.rows()[*row])) values.setRow(*row, *value);
}

}  // namespace

bool makeAct(ParameterValues& values, std::size_t row, std::span<const std::size_t> fixed)
{
    const std::optional<Condition>& condition = values.rows()[row].actsWhen;
    if (!condition) return true;
    ParameterValues changed = values;
    satisfy(changed, *condition, fixed);
    if (!acts(changed, row)) return false;
    values = std::move(changed);
    return true;
}

}  // namespace vitrine

#include "exhibits/framework/table/acting.h"

#include "exhibits/framework/table/value_text.h"
#include "render/text/translation.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace vitrine {
namespace {

std::size_t parameterNamed(const Parameters& table, std::string_view name)
{
    const std::optional<std::size_t> row = table.find(name);
    assert(row && "a condition names a parameter that its table does not have");
    return row.value_or(0);
}

/// Returns the alternatives as text: "a, b or c".
std::string alternatives(const ParameterInfo& parameter, const std::vector<double>& values)
{
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string one = translated(formatValue(parameter, values[i]));
        if (i == 0)
            text = one;
        else
            text = i + 1 == values.size() ? translated("{1} or {2}", {text, one}) : text + ", " + one;
    }
    return text;
}

/// Formats a condition. With `values`, adds the conditions of tested parameters that have no effect themselves.
std::string text(const Condition& condition, const Parameters& table, const ParameterValues* values)
{
    const bool all = condition.test == Condition::Test::all;
    if (all || condition.test == Condition::Test::any) {
        std::string line;
        for (const Condition& part : condition.parts) {
            std::string one = text(part, table, values);
            if (all && part.test == Condition::Test::any) one = "(" + one + ")";
            if (line.empty())
                line = one;
            else
                line = all ? translated("{1} and {2}", {line, one}) : translated("{1} or {2}", {line, one});
        }
        return line;
    }
    const std::size_t index = parameterNamed(table, condition.row);
    const ParameterInfo& row = table.rows()[index];
    const std::string name = translated(label(row));
    std::string line;
    if (condition.test == Condition::Test::given)
        line = translated("“{1}” names a file", {name});
    else if (condition.test == Condition::Test::above)
        line = translated("“{1}” is above {2}", {name, formatValue(row, condition.values.front())});
    else if (condition.test == Condition::Test::differs)
        line = translated("“{1}” is not {2}", {name, alternatives(row, condition.values)});
    else
        line = translated("“{1}” is {2}", {name, alternatives(row, condition.values)});
    if (!values || acts(*values, index)) return line;
    return translated("{1} (which acts when {2})", {line, text(*row.actsWhen, table, values)});
}

bool isAmong(const Condition& condition, double x)
{
    return std::find(condition.values.begin(), condition.values.end(), x) != condition.values.end();
}

/// Returns a value of the parameter that satisfies the condition's test: the initial one if it does.
std::optional<double> satisfying(const Condition& condition, const ParameterInfo& parameter)
{
    const auto* initial = std::get_if<double>(&parameter.initial);
    if (!initial) return std::nullopt;
    switch (condition.test) {
    case Condition::Test::among: return isAmong(condition, *initial) ? *initial : condition.values.front();
    case Condition::Test::differs: {
        double other = isAmong(condition, *initial) ? parameter.range.low : *initial;
        while (isAmong(condition, other)) ++other;
        return other;
    }
    case Condition::Test::above:
        if (*initial > condition.values.front()) return *initial;
        if (parameter.range.softHigh > condition.values.front()) return parameter.range.softHigh;
        return parameter.range.high;
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
    if (const std::optional<double> value = satisfying(condition, values.rows()[*row]))
        values.setParameter(*row, *value);
}

}  // namespace

bool holds(const Condition& condition, const ParameterValues& values)
{
    const auto part = [&](const Condition& one) { return holds(one, values); };
    if (condition.test == Condition::Test::all)
        return std::all_of(condition.parts.begin(), condition.parts.end(), part);
    if (condition.test == Condition::Test::any)
        return std::any_of(condition.parts.begin(), condition.parts.end(), part);
    const std::size_t row = parameterNamed(values.table(), condition.row);
    if (!acts(values, row)) return false;
    if (condition.test == Condition::Test::given) return !std::get<std::string>(values.row(row)).empty();
    const double x = std::get<double>(values.row(row));
    const bool among = std::find(condition.values.begin(), condition.values.end(), x) != condition.values.end();
    if (condition.test == Condition::Test::among) return among;
    if (condition.test == Condition::Test::differs) return !among;
    return x > condition.values.front();
}

bool acts(const ParameterValues& values, std::size_t row)
{
    const std::optional<Condition>& condition = values.rows()[row].actsWhen;
    return !condition || holds(*condition, values);
}

std::string actsWhen(const Parameters& table, std::size_t row)
{
    const std::optional<Condition>& condition = table.rows()[row].actsWhen;
    return condition ? text(*condition, table, nullptr) : std::string();
}

std::string actsWhen(const ParameterValues& values, std::size_t row)
{
    const std::optional<Condition>& condition = values.rows()[row].actsWhen;
    return condition ? text(*condition, values.table(), &values) : std::string();
}

ParameterValues actingValues(const ParameterValues& values)
{
    ParameterValues result = values;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (!acts(values, i)) result.resetParameter(i);
    return result;
}

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

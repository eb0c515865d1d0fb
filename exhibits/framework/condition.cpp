#include "exhibits/framework/condition.h"

#include "exhibits/framework/make_act.h"
#include "exhibits/framework/parameters.h"
#include "exhibits/framework/value_text.h"
#include "render/text/translation.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace vitrine {
namespace {

/// Parts of the same kind lie side by side: (a and b) and c is a and b and c.
Condition joined(Condition::Test test, Condition a, Condition b)
{
    Condition both{test};
    for (Condition* one : {&a, &b}) {
        if (one->test != test)
            both.parts.push_back(std::move(*one));
        else
            both.parts.insert(both.parts.end(), std::make_move_iterator(one->parts.begin()),
                              std::make_move_iterator(one->parts.end()));
    }
    return both;
}

std::size_t rowNamed(const Parameters& table, std::string_view name)
{
    const std::optional<std::size_t> row = table.find(name);
    assert(row && "a condition names a row that its table does not have");
    return row.value_or(0);
}

/// "a, b or c".
std::string alternatives(const ParameterInfo& row, const std::vector<double>& values)
{
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string one = translated(formatValue(row, values[i]));
        if (i == 0)
            text = one;
        else
            text = i + 1 == values.size() ? translated("{1} or {2}", {text, one}) : text + ", " + one;
    }
    return text;
}

/// `values` adds, of each row that does not act itself, when it does.
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
    const std::size_t index = rowNamed(table, condition.row);
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

}  // namespace

Condition operator&&(Condition a, Condition b)
{
    return joined(Condition::Test::all, std::move(a), std::move(b));
}

Condition operator||(Condition a, Condition b)
{
    return joined(Condition::Test::any, std::move(a), std::move(b));
}

std::string_view toString(Condition::Test test)
{
    switch (test) {
    case Condition::Test::among: return "among";
    case Condition::Test::differs: return "differs";
    case Condition::Test::above: return "above";
    case Condition::Test::given: return "given";
    case Condition::Test::all: return "all";
    case Condition::Test::any: return "any";
    }
    return "";
}

std::vector<std::string_view> rowsOf(const Condition& condition)
{
    std::vector<std::string_view> names;
    if (!condition.row.empty()) names.push_back(condition.row);
    for (const Condition& part : condition.parts)
        for (const std::string_view name : rowsOf(part)) names.push_back(name);
    return names;
}

bool holds(const Condition& condition, const ParameterValues& values)
{
    const auto part = [&](const Condition& one) { return holds(one, values); };
    if (condition.test == Condition::Test::all)
        return std::all_of(condition.parts.begin(), condition.parts.end(), part);
    if (condition.test == Condition::Test::any)
        return std::any_of(condition.parts.begin(), condition.parts.end(), part);
    const std::size_t row = rowNamed(values.table(), condition.row);
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
        if (!acts(values, i)) result.resetRow(i);
    return result;
}

}  // namespace vitrine

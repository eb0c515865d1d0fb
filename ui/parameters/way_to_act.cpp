#include "ui/parameters/way_to_act.h"

#include "exhibits/framework/table/acting.h"

#include <algorithm>

namespace vitrine::ui {
namespace {

bool isAmong(const std::vector<double>& values, double x)
{
    return std::find(values.begin(), values.end(), x) != values.end();
}

/// Returns whether the test holds for the value `x` of its parameter.
bool testHolds(const Condition& test, double x)
{
    if (test.test == Condition::Test::above) return x > test.values.front();
    return isAmong(test.values, x) == (test.test == Condition::Test::among);
}

/// Returns a value of the parameter for which the test holds, if there is one.
std::optional<double> valueFor(const Condition& test, const ParameterInfo& row)
{
    const double initial = std::get<double>(row.initial);
    std::vector<double> candidates = test.test == Condition::Test::among ? test.values : std::vector{initial};
    for (std::size_t i = 0; i < row.choices.size(); ++i) candidates.push_back(static_cast<double>(i));
    if (row.kind == Kind::toggle) candidates.insert(candidates.end(), {0, 1});
    if (row.isNumeric()) candidates.insert(candidates.end(), {row.range.softLow, row.range.softHigh, row.range.high});
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](double x) { return testHolds(test, x); });
    return found == candidates.end() ? std::nullopt : std::optional(*found);
}

/// Makes the condition hold in `values`, and adds the changes to `changes`. Returns whether it succeeded.
bool reach(const Condition& condition, ParameterValues& values, RowChanges& changes);

/// The same for a parameter that is to have an effect.
bool reachRow(std::size_t row, ParameterValues& values, RowChanges& changes)
{
    const std::optional<Condition>& condition = values.rows()[row].actsWhen;
    return !condition || acts(values, row) || reach(*condition, values, changes);
}

bool reach(const Condition& condition, ParameterValues& values, RowChanges& changes)
{
    const auto part = [&](const Condition& one) {
        const ParameterValues before = values;
        const RowChanges until = changes;
        if (reach(one, values, changes)) return true;
        values = before;
        changes = until;
        return false;
    };
    if (condition.test == Condition::Test::all)
        return std::all_of(condition.parts.begin(), condition.parts.end(), part);
    if (condition.test == Condition::Test::any)
        return std::any_of(condition.parts.begin(), condition.parts.end(), part);
    const std::optional<std::size_t> row = values.table().find(condition.row);
    if (!row || !reachRow(*row, values, changes)) return false;
    if (condition.test == Condition::Test::given) return !std::get<std::string>(values.row(*row)).empty();
    if (testHolds(condition, std::get<double>(values.row(*row)))) return true;
    const std::optional<double> value = valueFor(condition, values.rows()[*row]);
    if (!value) return false;
    values.setRow(*row, *value);
    changes.emplace_back(*row, *value);
    return true;
}

}  // namespace

std::optional<RowChanges> changesToAct(const ParameterValues& values, std::size_t row)
{
    ParameterValues changed = values;
    RowChanges changes;
    if (!reachRow(row, changed, changes) || !acts(changed, row)) return std::nullopt;
    return changes;
}

}  // namespace vitrine::ui

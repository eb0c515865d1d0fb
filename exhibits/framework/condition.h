#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

class Parameters;
class ParameterValues;

/// What must hold in other rows of a table for a row to act on anything that can be seen. Rows are told by their names,
/// so that one may look at rows further down.
struct Condition {
    enum class Test : std::uint8_t {
        among,    ///< The row has one of `values`: numbers, indices of choices, 0 or 1 for toggles.
        differs,  ///< It has none of them.
        above,    ///< It is above `values[0]`.
        given,    ///< It names a file.
        all,      ///< Every one of `parts` holds.
        any       ///< At least one of them does.
    };
    Test test = Test::all;
    std::string_view row = {};
    std::vector<double> values = {};
    std::vector<Condition> parts = {};

    bool operator==(const Condition&) const = default;
};

[[nodiscard]] Condition operator&&(Condition, Condition);
[[nodiscard]] Condition operator||(Condition, Condition);

/// "all", "among" ... as `vitrine list --json` prints them.
[[nodiscard]] std::string_view toString(Condition::Test);

/// The names of all rows that the condition looks at, in the order in which it does.
[[nodiscard]] std::vector<std::string_view> rowsOf(const Condition&);

/// Whether row `row` acts: its condition holds, and the rows that it looks at act themselves. A row that does not act
/// changes no picture and keeps its value.
[[nodiscard]] bool acts(const ParameterValues&, std::size_t row);

/// When row `row` acts, by the labels of the other rows: "“Shadow filter” is sun's disk". Empty: always.
[[nodiscard]] std::string actsWhen(const Parameters&, std::size_t row);
/// The same, and of every row in it that does not act itself, when that one does.
[[nodiscard]] std::string actsWhen(const ParameterValues&, std::size_t row);

/// The values with every row that does not act at its initial value: alike for two snapshots that differ in such rows
/// alone.
[[nodiscard]] ParameterValues actingValues(const ParameterValues&);

}  // namespace vitrine

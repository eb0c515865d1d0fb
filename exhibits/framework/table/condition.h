#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace vitrine {

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

}  // namespace vitrine

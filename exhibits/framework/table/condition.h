#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace vitrine {

/// Condition on other parameters of a table under which a parameter acts, which means that it can change a picture.
/// Parameters are given by their names, so that a condition may refer to one that is declared later.
struct Condition {
    enum class Test : std::uint8_t {
        among,    ///< The parameter has one of `values`: numbers, indices of choices, 0 or 1 for toggles.
        differs,  ///< It has none of them.
        above,    ///< It is above `values[0]`.
        given,    ///< It names a file.
        all,      ///< All conditions of `parts` hold.
        any       ///< At least one condition of `parts` holds.
    };
    Test test = Test::all;
    std::string_view row = {};
    std::vector<double> values = {};
    std::vector<Condition> parts = {};

    bool operator==(const Condition&) const = default;
};

[[nodiscard]] Condition operator&&(Condition, Condition);
[[nodiscard]] Condition operator||(Condition, Condition);

/// Returns the name that `vitrine list --json` prints: "all", "among" ...
[[nodiscard]] std::string_view toString(Condition::Test);

/// Returns the names of all parameters that the condition tests, in the order of its parts.
[[nodiscard]] std::vector<std::string_view> parametersOf(const Condition&);

}  // namespace vitrine

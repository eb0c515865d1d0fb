#pragma once

#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Upper bound on the change that an effect makes to any channel of any pixel of the image "radiance". The change is at
/// most `relative` times the pixel's value without the effect, plus `absolute`. `absolute` is scene-linear light before
/// exposure. An effect that other passes read (a shadow map, a probe) gives the change on a surface that receives it.
/// The reading pass bounds its own further use.
struct ContributionBound {
    double relative = 0;
    double absolute = std::numeric_limits<double>::infinity();  ///< Infinite: the change is unknown, or the pass draws
                                                                ///< the object itself.
    std::string whyNone = {};  ///< Reason why the bound is 0, for people. Empty if it is not 0.

    /// Returns true if the effect changes nothing and can be left out.
    [[nodiscard]] bool isZero() const { return relative == 0 && absolute == 0; }
    /// Returns true if both parts of the bound are finite.
    [[nodiscard]] bool isKnown() const
    {
        return relative < std::numeric_limits<double>::infinity() && absolute < std::numeric_limits<double>::infinity();
    }
};

/// A factor that an effect is proportional to, or 1 or 0 for a condition, with the reason that is shown if it is 0.
struct Factor {
    double value = 1;  ///< NaN counts as infinite, negative as 0.
    std::string_view whenZero;
};

/// Returns a factor of 1 if the condition holds, else of 0 with the reason `otherwise`.
[[nodiscard]] constexpr Factor required(bool holds, std::string_view otherwise)
{
    return {holds ? 1.0 : 0.0, otherwise};
}

/// Returns the reason of the first factor that is 0 or negative; empty if there is none. Condition and reason are
/// declared together, so that no reason can be given while its condition holds.
[[nodiscard]] std::string whyZero(std::initializer_list<Factor>);

/// Returns both parts of the bound, each multiplied by all factors. The first factor that is 0 gives the reason. 0
/// times infinity is 0: an effect that is absent changes nothing. `relative` and `absolute` must not both be 0:
/// anything that may be 0 is passed as a factor with a reason.
[[nodiscard]] ContributionBound boundOf(double relative, double absolute, std::initializer_list<Factor> factors);

/// Returns for example "changes a pixel by at most 40 % of its light and 0.3 of the light of white". From a bound of 1
/// on, a pixel can take any value: "may change any pixel". "changes nothing" for a bound of 0; empty for an unknown
/// bound.
[[nodiscard]] std::string toString(const ContributionBound&);

}  // namespace vitrine::render

#pragma once

#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

namespace vitrine::render {

/// The most that an effect changes of any channel of any pixel of the image "radiance": `relative` of what the pixel is
/// without the effect, plus `absolute` in scene-linear light before exposure. An effect that others read (a shadow map,
/// a probe) states what it changes on a surface that it falls on; what is made of it elsewhere is bounded there.
struct ContributionBound {
    double relative = 0;
    double absolute = std::numeric_limits<double>::infinity();  ///< Infinite: nobody knows, or it is the thing itself.
    std::string whyNone = {};                                   ///< Of a bound of 0: what makes it so.

    /// Nothing is changed, so that the effect can be left out.
    [[nodiscard]] bool isZero() const { return relative == 0 && absolute == 0; }
    /// Whether something finite is promised.
    [[nodiscard]] bool isKnown() const
    {
        return relative < std::numeric_limits<double>::infinity() && absolute < std::numeric_limits<double>::infinity();
    }
};

/// A number that an effect is in proportion to, or 1 and 0 for whether it can be seen, and what a visitor is told of
/// its 0.
struct Factor {
    double value = 1;  ///< NaN counts as infinite, negative as 0.
    std::string_view whenZero;
};

/// 1 where a condition holds, else 0.
[[nodiscard]] constexpr Factor required(bool holds, std::string_view otherwise)
{
    return {holds ? 1.0 : 0.0, otherwise};
}

/// What a visitor is told of the first factor that is 0; empty where none is. A condition and its reason are declared
/// together this way, so that a reason cannot be given where its condition holds.
[[nodiscard]] std::string whyZero(std::initializer_list<Factor>);

/// Share and absolute times all factors; the first factor that is 0 says why. 0 times infinity is 0: what is not there
/// changes nothing, whatever it would. Share and absolute are not both 0: what may be 0 is a factor, with its reason.
[[nodiscard]] ContributionBound boundOf(double relative, double absolute, std::initializer_list<Factor> factors);

/// "changes a pixel by at most 40 % of its light and 0.3 of the light of white"; "may change any pixel" from a bound of
/// 1 on, which leaves a pixel every value; "changes nothing"; empty when nothing is promised.
[[nodiscard]] std::string toString(const ContributionBound&);

}  // namespace vitrine::render

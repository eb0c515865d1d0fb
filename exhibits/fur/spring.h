#pragma once

#include "exhibits/fur/fur_table.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace vitrine {

/// A damped oscillator: undamped angular frequency in rad/s (0: nothing draws it back) and damping ratio
/// (0 swings forever, 1 returns fastest without swinging). Both at least 0.
struct Spring {
    double omega = 0;
    double zeta = 0;

    bool operator==(const Spring&) const = default;
};

struct SpringState {
    glm::dvec3 value{0};
    glm::dvec3 rate{0};  ///< Per second.

    bool operator==(const SpringState&) const = default;
};

/// The state `seconds` later, drawn towards a target that rests meanwhile. FurSpring::closedForm is exact for
/// every step: one of an hour equals all the small ones in it, and no step can add energy. The other two are
/// one step of the method that they name, and fail as it does.
/// A step of 0, a negative, infinite or NaN one changes nothing.
[[nodiscard]] SpringState advance(const SpringState&, const glm::dvec3& target, const Spring&, double seconds,
                                  FurSpring);

/// Energy per unit mass about `target`: never grows under the closed form.
[[nodiscard]] double energy(const SpringState&, const glm::dvec3& target, const Spring&);

/// The state with its value at most `limit` long, and no rate left that would lead out again.
[[nodiscard]] SpringState limited(const SpringState&, double limit);

/// Axis times angle, the angle at most pi, of a unit quaternion; q and -q give the same. At pi, where two
/// axes are as good, the one whose first nonzero component is positive.
[[nodiscard]] glm::dvec3 rotationVector(const glm::dquat&);
/// The unit quaternion of an axis times an angle; exact near 0.
[[nodiscard]] glm::dquat rotationOf(const glm::dvec3& rotationVector);

}  // namespace vitrine

#pragma once

#include "exhibits/fur/fur_table.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace vitrine::fur {

/// Damped oscillator: undamped angular frequency in rad/s (0: no restoring force) and damping ratio (0 oscillates
/// forever, 1 returns fastest without oscillating). Both are at least 0.
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

/// Returns the state `seconds` later, drawn towards a constant target. FurSpring::closedForm is exact for every step:
/// one step of an hour equals all the small ones in it, and no step adds energy. The other two are one step of the
/// method that they name, with its errors. A zero, negative, infinite or NaN step changes nothing.
[[nodiscard]] SpringState advance(const SpringState&, const glm::dvec3& target, const Spring&, double seconds,
                                  FurSpring);

/// Returns the energy per unit mass about `target`; it never grows with the closed form.
[[nodiscard]] double energy(const SpringState&, const glm::dvec3& target, const Spring&);

/// Returns the state with a value no longer than `limit`, and without a rate that leads out again.
[[nodiscard]] SpringState limited(const SpringState&, double limit);

/// Returns axis times angle of a unit quaternion, with an angle of at most pi; q and -q give the same. At pi both axes
/// are equally good, and the one whose first nonzero component is positive is returned.
[[nodiscard]] glm::dvec3 rotationVector(const glm::dquat&);
/// Returns the unit quaternion of an axis times an angle; exact near 0.
[[nodiscard]] glm::dquat rotationOf(const glm::dvec3& rotationVector);

}  // namespace vitrine::fur

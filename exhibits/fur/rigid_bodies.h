#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <memory>
#include <variant>
#include <vector>

namespace vitrine::fur {

/// Ball around the origin.
struct BallShape {
    double radius = 1;
};
/// Capsule: everything within `radius` of a straight line along x from -halfLength to halfLength.
struct RollShape {
    double radius = 1, halfLength = 1;
};
/// Torus: everything within `tube` of a circle of `radius` around y, approximated by 16 balls.
struct RingShape {
    double radius = 1, tube = 0.5;
};
/// Convex hull of at most 10,000 points, at least 4 of them not in a plane, grown by a margin.
struct HullShape {
    std::vector<glm::dvec3> points;
    double margin = 0;
};
using RigidShape = std::variant<BallShape, RollShape, RingShape, HullShape>;

struct RigidPose {
    glm::dvec3 position{0};
    glm::dquat rotation{1, 0, 0, 0};  ///< World from body, unit length.
};

/// Round pit in level ground: its floor at y = 0, an upright wall, and a padded rim on the ground around it. y is up;
/// lengths are in meters.
struct RigidPit {
    double radius = 1;
    double depth = 1;         ///< Depth of the floor below the ground outside.
    double padRadius = 0.15;  ///< Radius of the padded tube on the edge; the tube begins where the wall ends.
    double padLift = 0;       ///< Height of the tube's center line above the ground.
    double gravity = 9.81;    ///< m/s², downwards.
};

/// Rigid bodies that fall, bounce and roll in a pit (Bullet). The same calls give the same motion.
class RigidBodies {
public:
    explicit RigidBodies(const RigidPit&);
    ~RigidBodies();
    RigidBodies(const RigidBodies&) = delete;
    RigidBodies& operator=(const RigidBodies&) = delete;

    /// Adds a body. `mass` is in kilograms and above 0. Returns the index of the body, from 0.
    int add(const RigidShape&, const RigidPose&, double mass);
    /// Sets the radius of a ball to a value above 0. Its mass is unchanged.
    void resizeBall(int body, double radius);
    /// Moves a body and sets its velocity (m/s). Its rotation is unchanged.
    void move(int body, const glm::dvec3& position, const glm::dvec3& velocity);
    /// Adds to the velocity (m/s) and angular velocity (rad/s) of a body, and wakes it.
    void accelerate(int body, const glm::dvec3& velocity, const glm::dvec3& angularVelocity);
    /// Computes one step of `seconds`. In steps longer than 1/60 s, fast bodies may pass through walls.
    void step(double seconds);

    [[nodiscard]] RigidPose pose(int body) const;
    [[nodiscard]] glm::dvec3 velocity(int body) const;
    [[nodiscard]] glm::dvec3 angularVelocity(int body) const;
    /// Returns the radius at which a ball collides.
    [[nodiscard]] double ballRadius(int body) const;
    /// Returns whether the body touched anything in the last step.
    [[nodiscard]] bool touches(int body) const;
    /// Returns whether the body has hardly moved for half a second and is no longer simulated.
    [[nodiscard]] bool asleep(int body) const;

private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace vitrine::fur

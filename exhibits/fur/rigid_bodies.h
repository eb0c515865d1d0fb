#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <memory>
#include <variant>
#include <vector>

namespace vitrine {

/// A ball around the origin.
struct BallShape {
    double radius = 1;
};
/// Everything within `radius` of a straight line along x from -halfLength to halfLength.
struct RollShape {
    double radius = 1, halfLength = 1;
};
/// Everything within `tube` of a circle of `radius` around y, as 16 balls on it.
struct RingShape {
    double radius = 1, tube = 0.5;
};
/// The convex hull of points (at most 10,000 of them, at least 4 not in a plane), grown by a margin.
struct HullShape {
    std::vector<glm::dvec3> points;
    double margin = 0;
};
using RigidShape = std::variant<BallShape, RollShape, RingShape, HullShape>;

struct RigidPose {
    glm::dvec3 position{0};
    glm::dquat rotation{1, 0, 0, 0};  ///< World from body, unit length.
};

/// A round pit in level ground: its floor at y = 0, an upright wall, and around it on the ground a padded rim; y is up,
/// meters.
struct RigidPit {
    double radius = 1;
    double depth = 1;         ///< Of the floor below the ground outside.
    double padRadius = 0.15;  ///< Of the padded tube that lies on the edge; it begins where the wall ends.
    double padLift = 0;       ///< Of the tube's middle above the ground.
    double gravity = 9.81;    ///< m/s², downwards.
};

/// Rigid bodies that fall, bounce and roll in a pit (Bullet). The same calls give the same motion.
class RigidBodies {
public:
    explicit RigidBodies(const RigidPit&);
    ~RigidBodies();
    RigidBodies(const RigidBodies&) = delete;
    RigidBodies& operator=(const RigidBodies&) = delete;

    /// `mass` in kilograms, above 0. Returns the body's number, from 0.
    int add(const RigidShape&, const RigidPose&, double mass);
    /// Sets the radius of a ball that was added; above 0. Its mass stays.
    void resizeBall(int body, double radius);
    /// Puts it elsewhere, as it is turned, with another velocity (m/s).
    void move(int body, const glm::dvec3& position, const glm::dvec3& velocity);
    /// Adds to velocity (m/s) and angular velocity (rad/s), and wakes it.
    void accelerate(int body, const glm::dvec3& velocity, const glm::dvec3& angularVelocity);
    /// One step of `seconds`; at most 1/60 or fast bodies pass through walls.
    void step(double seconds);

    [[nodiscard]] RigidPose pose(int body) const;
    [[nodiscard]] glm::dvec3 velocity(int body) const;
    [[nodiscard]] glm::dvec3 angularVelocity(int body) const;
    /// Radius at which a ball collides.
    [[nodiscard]] double ballRadius(int body) const;
    /// Whether it touched anything in the last step.
    [[nodiscard]] bool touches(int body) const;
    /// Whether it has hardly moved for half a second and is no longer computed.
    [[nodiscard]] bool asleep(int body) const;

private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace vitrine

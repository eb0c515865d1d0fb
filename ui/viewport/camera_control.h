#pragma once

#include "render/scene/camera.h"

#include <functional>

namespace vitrine::ui {

/// Where a visitor who stands at `from` and wants to be at `to` ends up: `to`, or as far as walls and
/// exhibits allow, sliding along them. Eye positions in the world, meters.
using Walkable = std::function<glm::dvec3(const glm::dvec3& from, const glm::dvec3& to)>;

/// What the visitor holds down or pushes.
struct WalkKeys {
    bool forward = false, back = false, left = false, right = false, run = false;
    /// Of a stick, added to the keys: parts of the full speed, forward and to the right.
    double ahead = 0, aside = 0;
    double yaw = 0, pitch = 0;  ///< Radians per second by which the head is turned.
    double nearer = 0;          ///< Steps of `Orbit::zoom` per second.

    /// Something walks.
    [[nodiscard]] bool any() const { return forward || back || left || right || ahead != 0 || aside != 0; }
    /// Something walks, or turns the head, or goes nearer.
    [[nodiscard]] bool moves() const { return any() || yaw != 0 || pitch != 0 || nearer != 0; }
};

/// A look direction as two angles, radians. Yaw 0 looks along -z and grows to the right; pitch grows upward.
struct Heading {
    double yaw = 0;
    double pitch = 0;
};
[[nodiscard]] Heading headingOf(const glm::dvec3& direction);
[[nodiscard]] glm::dvec3 directionOf(const Heading&);

/// First person: eye height, speed with a soft start and stop, walls.
class Walker {
public:
    static constexpr double eyeHeight = 1.65;    ///< Meters.
    static constexpr double walkingSpeed = 1.4;  ///< Meters per second.
    static constexpr double runningSpeed = 3.5;
    static constexpr double response = 0.12;  ///< Seconds in which 63% of a change of speed is made.

    /// The camera is kept exactly until the first turn or step.
    void place(const render::Camera&);
    [[nodiscard]] const render::Camera& camera() const { return camera_; }
    void turn(double yaw, double pitch);
    /// Walks for `seconds` (more than half a second counts as half). Speed follows its differential equation
    /// exactly, so that the way covered does not depend on how time is cut into frames.
    void advance(double seconds, const WalkKeys&, const Walkable&);
    [[nodiscard]] bool moving() const { return velocity_ != glm::dvec3(0); }
    void stop() { velocity_ = glm::dvec3(0); }

private:
    void step(double seconds, const glm::dvec3& wanted, const Walkable&);
    void moveTo(const glm::dvec3& eye);

    render::Camera camera_;
    glm::dvec3 velocity_{0};
    Heading heading_;
};

/// Looks at one point from all sides.
class Orbit {
public:
    static constexpr double lowestEye = 0.2;     ///< Meters above the floor.
    static constexpr double steepest = 1.48;     ///< Radians from the horizon, about 85 degrees.
    static constexpr double nearestPart = 0.25;  ///< Of the distance at the start.
    static constexpr double farthestPart = 2.5;

    /// Around the camera's target; the camera is kept exactly until the first turn or zoom.
    void start(const render::Camera&);
    [[nodiscard]] const render::Camera& camera() const { return camera_; }
    /// Radians by which the eye moves around the center; clamped to `steepest` and above the floor.
    void turn(double yaw, double pitch);
    /// Positive steps come nearer, a tenth of the distance each.
    void zoom(double steps);

private:
    void update(Heading, double distance);

    render::Camera camera_;
    double nearest_ = 0.1;
    double farthest_ = 10;
};

/// The way from one camera to another in `duration` seconds, slow at both ends. At the end it is exactly there.
class Glide {
public:
    static constexpr double duration = 0.8;

    void start(const render::Camera& from, const render::Camera& to);
    void advance(double seconds) { elapsed_ += seconds; }
    [[nodiscard]] bool finished() const { return elapsed_ >= duration; }
    [[nodiscard]] render::Camera camera() const;
    [[nodiscard]] const render::Camera& end() const { return to_; }

private:
    render::Camera from_, to_;
    double elapsed_ = duration;
};

/// Aspect ratio (width / height) for which the best views are made.
inline constexpr double keptAspect = 1.5;

/// `camera` for a picture of this aspect ratio (width / height): in one narrower than 3:2 the field of view grows, so
/// that it shows as much from left to right as one of 3:2 does, for which the best views are made.
[[nodiscard]] render::Camera widened(const render::Camera& camera, double aspect);

/// The visitor: walks, glides to an exhibit, orbits it, and walks on.
class CameraControl {
public:
    enum class Mode { walk, glide, orbit };

    /// Where a visitor is, or is gliding to.
    struct Standpoint {
        render::Camera camera;
        Mode mode = Mode::walk;  ///< Never `glide`.
    };

    /// While on, nothing glides: the camera is at once where it would have glided to.
    void setCutting(bool cuts) { cuts_ = cuts; }
    [[nodiscard]] bool cuts() const { return cuts_; }
    void setWalkable(Walkable walkable) { walkable_ = std::move(walkable); }
    /// At once: walking where a visitor can stand, else orbiting the camera's target.
    void jumpTo(const render::Camera&);
    /// Glides there and then orbits its target, or walks.
    void glideTo(const Standpoint&);
    void visit(const render::Camera& bestView) { glideTo({bestView, Mode::orbit}); }
    /// Leaves an exhibit: glides to eye height beside it, or back to where the visit began when
    /// something stands there, looks at it still, and walks.
    void walkOn();

    /// Radians. Walking: looks around. Orbiting: moves around. Gliding: nothing.
    void turn(double yaw, double pitch);
    void zoom(double steps);
    /// Keys for walking while orbiting walk on. Returns whether the camera changed.
    bool advance(double seconds, const WalkKeys&);

    [[nodiscard]] render::Camera camera() const;
    [[nodiscard]] Mode mode() const { return mode_; }
    [[nodiscard]] Standpoint standpoint() const;
    [[nodiscard]] bool moving() const { return mode_ == Mode::glide || walker_.moving(); }

private:
    void startGlide(const render::Camera& from, const Standpoint& there);
    void arrive();

    Walkable walkable_;
    bool cuts_ = false;
    Walker walker_;
    Orbit orbit_;
    Glide glide_;
    Mode mode_ = Mode::walk;
    Mode afterGlide_ = Mode::walk;
    render::Camera beforeVisit_;
};

}  // namespace vitrine::ui

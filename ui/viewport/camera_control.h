#pragma once

#include "render/scene/camera.h"

#include <functional>

namespace vitrine::ui {

/// Collision test: returns the position that a visitor reaches who walks from `from` to `to`. It is `to`, or as far as
/// walls and exhibits allow, sliding along them. Eye positions in the world, meters.
using Walkable = std::function<glm::dvec3(const glm::dvec3& from, const glm::dvec3& to)>;

/// State of the keys and sticks that move the visitor.
struct WalkKeys {
    bool forward = false, back = false, left = false, right = false, run = false;
    /// Deflection of a stick, as parts of the full speed forward and to the right. Added to the keys.
    double ahead = 0, aside = 0;
    double yaw = 0, pitch = 0;  ///< Turn of the head in radians per second.
    double nearer = 0;          ///< Zoom speed in steps of `Orbit::zoom` per second.

    /// Returns whether any input walks.
    [[nodiscard]] bool any() const { return forward || back || left || right || ahead != 0 || aside != 0; }
    /// Returns whether any input walks, turns the head or zooms.
    [[nodiscard]] bool moves() const { return any() || yaw != 0 || pitch != 0 || nearer != 0; }
};

/// A look direction as two angles, radians. Yaw 0 looks along -z and grows to the right; pitch grows upward.
struct Heading {
    double yaw = 0;
    double pitch = 0;
};
[[nodiscard]] Heading headingOf(const glm::dvec3& direction);
[[nodiscard]] glm::dvec3 directionOf(const Heading&);

/// First-person camera: eye height, walking speed with a soft start and stop, collision with walls.
class Walker {
public:
    static constexpr double eyeHeight = 1.65;    ///< Height of the eye in meters.
    static constexpr double walkingSpeed = 1.4;  ///< Meters per second.
    static constexpr double runningSpeed = 3.5;
    /// Time constant of a change of speed: seconds after which 63% of it is made.
    static constexpr double response = 0.12;

    /// Places the camera. It stays exactly this one until the first turn or step.
    void place(const render::Camera&);
    [[nodiscard]] const render::Camera& camera() const { return camera_; }
    void turn(double yaw, double pitch);
    /// Walks for `seconds`; more than half a second counts as half. The differential equation of the speed is solved
    /// exactly, so that the distance covered does not depend on the frame rate.
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

/// Camera that turns around one point.
class Orbit {
public:
    static constexpr double lowestEye = 0.2;  ///< Height of the eye above the floor, in meters.
    static constexpr double steepest = 1.48;  ///< Largest angle from the horizon in radians, about 85 degrees.
    /// Nearest and farthest distance, as parts of the distance at the start.
    static constexpr double nearestPart = 0.25;
    static constexpr double farthestPart = 2.5;

    /// Starts orbiting the camera's target. The camera stays exactly this one until the first turn or zoom.
    void start(const render::Camera&);
    [[nodiscard]] const render::Camera& camera() const { return camera_; }
    /// Moves the eye around the center by these angles in radians. Clamped to `steepest` and to `lowestEye`.
    void turn(double yaw, double pitch);
    /// Zooms. Positive steps come nearer, by a tenth of the distance each.
    void zoom(double steps);

private:
    void update(Heading, double distance);

    render::Camera camera_;
    double nearest_ = 0.1;
    double farthest_ = 10;
};

/// Glide from one camera to another in `duration` seconds, slow at both ends. It ends exactly at the second camera.
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

/// Camera of the visitor: walks, glides to an exhibit, orbits it, and walks on.
class CameraControl {
public:
    enum class Mode { walk, glide, orbit };

    /// Place of the visitor, or the end of the present glide.
    struct Standpoint {
        render::Camera camera;
        Mode mode = Mode::walk;  ///< Never `glide`.
    };

    /// While on, cameras cut instead of gliding: each glide is at its end at once.
    void setCutting(bool cuts) { cuts_ = cuts; }
    [[nodiscard]] bool cuts() const { return cuts_; }
    void setWalkable(Walkable walkable) { walkable_ = std::move(walkable); }
    /// Places the camera at once. The visitor walks if the camera is at `Walker::eyeHeight`, and orbits its target
    /// otherwise.
    void jumpTo(const render::Camera&);
    /// Glides to the standpoint, and then orbits its target or walks, as its mode says.
    void glideTo(const Standpoint&);
    void visit(const render::Camera& bestView) { glideTo({bestView, Mode::orbit}); }
    /// Leaves an exhibit: glides to eye height beside it, keeps looking at it, and walks. Glides back to the start of
    /// the visit if something stands there.
    void walkOn();

    /// Turns by these angles in radians. Walking: looks around. Orbiting: moves around. Gliding: ignored.
    void turn(double yaw, double pitch);
    void zoom(double steps);
    /// Advances walking and glides by `seconds`. Walking keys end an orbit. Returns whether the camera changed.
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

#include "ui/viewport/camera_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::ui {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double steepestPitch = 1.5;   // Radians, just short of straight up, where yaw is undefined.
constexpr double longestStep = 0.1;     // Meters per collision test: shorter than any wall is thick.
constexpr double longestAdvance = 0.5;  // Seconds. A longer pause counts as this long.
constexpr double slowest = 0.004;       // Meters per second. A slower visitor stands still.

double shortestTurn(double from, double to)
{
    return std::remainder(to - from, 2 * pi);
}

}  // namespace

Heading headingOf(const glm::dvec3& direction)
{
    const double length = glm::length(direction);
    if (length < 1e-12) return {};
    const glm::dvec3 d = direction / length;
    const bool vertical = std::hypot(d.x, d.z) < 1e-9;
    return {vertical ? 0.0 : std::atan2(d.x, -d.z), std::asin(std::clamp(d.y, -1.0, 1.0))};
}

glm::dvec3 directionOf(const Heading& h)
{
    return {std::sin(h.yaw) * std::cos(h.pitch), std::sin(h.pitch), -std::cos(h.yaw) * std::cos(h.pitch)};
}

void Walker::place(const render::Camera& camera)
{
    camera_ = camera;
    heading_ = headingOf(camera.target - camera.eye);
    stop();
}

void Walker::moveTo(const glm::dvec3& eye)
{
    if (eye == camera_.eye) return;
    camera_.target += eye - camera_.eye;
    camera_.eye = eye;
}

void Walker::turn(double yaw, double pitch)
{
    heading_.yaw = std::remainder(heading_.yaw + yaw, 2 * pi);
    heading_.pitch = std::clamp(heading_.pitch + pitch, -steepestPitch, steepestPitch);
    camera_.target = camera_.eye + directionOf(heading_);
}

void Walker::advance(double seconds, const WalkKeys& keys, const Walkable& walkable)
{
    const glm::dvec3 ahead(std::sin(heading_.yaw), 0, -std::cos(heading_.yaw));
    const glm::dvec3 aside(-ahead.z, 0, ahead.x);
    glm::dvec3 wanted = ahead * (keys.forward - keys.back + keys.ahead) + aside * (keys.right - keys.left + keys.aside);
    const double length = glm::length(wanted);
    // A stick that is partly deflected walks slowly.
    wanted *= (keys.run ? runningSpeed : walkingSpeed) / std::max(length, 1.0);

    seconds = std::clamp(seconds, 0.0, longestAdvance);
    const double fastest = std::max(glm::length(wanted), glm::length(velocity_));
    const int steps = std::max(1, static_cast<int>(std::ceil(fastest * seconds / longestStep)));
    for (int i = 0; i < steps; ++i) step(seconds / steps, wanted, walkable);
    if (length == 0 && glm::length(velocity_) < slowest) stop();
}

void Walker::step(double seconds, const glm::dvec3& wanted, const Walkable& walkable)
{
    // Solves dv/dt = (wanted - v) / response over the step, and its integral for the way.
    const double decay = std::exp(-seconds / response);
    const glm::dvec3 way = wanted * seconds + (velocity_ - wanted) * (response * (1 - decay));
    velocity_ = wanted + (velocity_ - wanted) * decay;
    const glm::dvec3 to = camera_.eye + way;
    const glm::dvec3 reached = walkable ? walkable(camera_.eye, to) : to;
    if (glm::distance(reached, to) > 1e-9) {
        const glm::dvec3 made = reached - camera_.eye;
        const double distance = glm::length(made);
        velocity_ =
            distance > 1e-9 ? made / distance * std::max(0.0, glm::dot(velocity_, made / distance)) : glm::dvec3(0);
    }
    moveTo(reached);
}

void Orbit::start(const render::Camera& camera)
{
    camera_ = camera;
    const double distance = std::max(0.05, glm::distance(camera.eye, camera.target));
    nearest_ = distance * nearestPart;
    farthest_ = distance * farthestPart;
}

void Orbit::turn(double yaw, double pitch)
{
    Heading from = headingOf(camera_.eye - camera_.target);
    from.yaw += yaw;
    from.pitch += pitch;
    update(from, glm::distance(camera_.eye, camera_.target));
}

void Orbit::zoom(double steps)
{
    update(headingOf(camera_.eye - camera_.target), glm::distance(camera_.eye, camera_.target) * std::pow(0.9, steps));
}

void Orbit::update(Heading from, double distance)
{
    distance = std::clamp(distance, nearest_, farthest_);
    const double floor = std::asin(std::clamp((lowestEye - camera_.target.y) / distance, -1.0, 1.0));
    from.pitch = std::clamp(from.pitch, std::min(std::max(-steepest, floor), steepest), steepest);
    camera_.eye = camera_.target + directionOf(from) * distance;
}

void Glide::start(const render::Camera& from, const render::Camera& to)
{
    from_ = from;
    to_ = to;
    elapsed_ = 0;
}

render::Camera Glide::camera() const
{
    if (finished()) return to_;
    const double t = std::clamp(elapsed_ / duration, 0.0, 1.0);
    const double part = t * t * t * (t * (6 * t - 15) + 10);
    const Heading a = headingOf(from_.target - from_.eye);
    const Heading b = headingOf(to_.target - to_.eye);
    const Heading heading{a.yaw + shortestTurn(a.yaw, b.yaw) * part, glm::mix(a.pitch, b.pitch, part)};
    const double distance = glm::mix(glm::distance(from_.eye, from_.target), glm::distance(to_.eye, to_.target), part);
    render::Camera camera;
    camera.eye = glm::mix(from_.eye, to_.eye, part);
    camera.target = camera.eye + directionOf(heading) * distance;
    camera.fovY = glm::mix(from_.fovY, to_.fovY, part);
    return camera;
}

void CameraControl::jumpTo(const render::Camera& camera)
{
    const bool stands = std::abs(camera.eye.y - Walker::eyeHeight) < 0.01;
    if (!stands && mode_ == Mode::walk) beforeVisit_ = walker_.camera();
    walker_.place(camera);
    orbit_.start(camera);
    mode_ = stands ? Mode::walk : Mode::orbit;
}

void CameraControl::glideTo(const Standpoint& there)
{
    if (mode_ == Mode::walk) beforeVisit_ = walker_.camera();
    walker_.stop();
    startGlide(camera(), there);
}

void CameraControl::startGlide(const render::Camera& from, const Standpoint& there)
{
    glide_.start(from, there.camera);
    afterGlide_ = there.mode;
    mode_ = Mode::glide;
    if (cuts_) arrive();
}

void CameraControl::arrive()
{
    mode_ = afterGlide_;
    if (mode_ == Mode::orbit)
        orbit_.start(glide_.end());
    else
        walker_.place(glide_.end());
}

CameraControl::Standpoint CameraControl::standpoint() const
{
    if (mode_ == Mode::glide) return {glide_.end(), afterGlide_};
    return {camera(), mode_};
}

void CameraControl::walkOn()
{
    if (mode_ == Mode::walk || (mode_ == Mode::glide && afterGlide_ == Mode::walk)) return;
    const render::Camera now = camera();
    render::Camera standing = now;
    standing.eye.y = Walker::eyeHeight;
    if (walkable_ && glm::distance(walkable_(standing.eye, standing.eye), standing.eye) > 1e-6)
        standing.eye = beforeVisit_.eye;
    startGlide(now, {standing, Mode::walk});
}

void CameraControl::turn(double yaw, double pitch)
{
    if (mode_ == Mode::walk) walker_.turn(yaw, pitch);
    // The scene follows the pointer, so the eye moves the other way.
    if (mode_ == Mode::orbit) orbit_.turn(yaw, -pitch);
}

void CameraControl::zoom(double steps)
{
    if (mode_ == Mode::orbit) orbit_.zoom(steps);
}

bool CameraControl::advance(double seconds, const WalkKeys& keys)
{
    const render::Camera before = camera();
    const double turned = std::clamp(seconds, 0.0, longestAdvance);
    if (keys.yaw != 0 || keys.pitch != 0) turn(keys.yaw * turned, keys.pitch * turned);
    if (keys.nearer != 0) zoom(keys.nearer * turned);
    if (mode_ == Mode::orbit && keys.any()) walkOn();
    if (mode_ == Mode::glide) {
        glide_.advance(seconds);
        if (glide_.finished()) arrive();
    } else if (mode_ == Mode::walk) {
        walker_.advance(seconds, keys, walkable_);
    }
    return !(camera() == before);
}

render::Camera CameraControl::camera() const
{
    switch (mode_) {
    case Mode::walk: return walker_.camera();
    case Mode::glide: return glide_.camera();
    case Mode::orbit: return orbit_.camera();
    }
    return {};
}

}  // namespace vitrine::ui

#include "exhibits/recording/camera_path.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace vitrine::recording {
namespace {

constexpr std::size_t piecesOfLeg = 2048;
constexpr double metersPerRadian = 1.5;
/// Largest elevation of the view direction, in radians: not quite vertical, where the bearing is undefined. Its sine
/// stays below 0.99999, from which makeView uses another axis than the vertical.
constexpr double steepest = 1.566;

render::Camera cameraAt(const std::array<double, 7>& p)
{
    render::Camera camera;
    camera.eye = {p[0], p[1], p[2]};
    const glm::dvec3 look(std::cos(p[4]) * std::sin(p[3]), std::sin(p[4]), -std::cos(p[4]) * std::cos(p[3]));
    camera.target = camera.eye + std::exp(p[5]) * look;
    camera.fovY = p[6];
    return camera;
}

}  // namespace

CameraPath::Point CameraPath::pointOf(const render::Camera& camera, double bearingBefore)
{
    const glm::dvec3 look = camera.target - camera.eye;
    const double flat = std::hypot(look.x, look.z);
    const double distance = std::max(glm::length(look), 1e-3);
    double bearing = flat > 1e-9 ? std::atan2(look.x, -look.z) : bearingBefore;
    bearing += 2 * std::numbers::pi * std::round((bearingBefore - bearing) / (2 * std::numbers::pi));
    return {camera.eye.x,       camera.eye.y, camera.eye.z, bearing, std::atan2(look.y, flat),
            std::log(distance), camera.fovY};
}

double CameraPath::distance(const Point& a, const Point& b)
{
    constexpr Point weights = {1, 1, 1, metersPerRadian, metersPerRadian, 0.01, metersPerRadian};
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]) * weights[i] * weights[i];
    return std::sqrt(sum);
}

CameraPath::CameraPath(const std::vector<render::Camera>& stops, bool closed) : lengths_(1, 0.0)
{
    assert(!stops.empty());
    std::vector<Point> points;
    const auto add = [&](std::size_t i) {
        const Point next = pointOf(stops[i % stops.size()], points.empty() ? 0 : points.back()[3]);
        if (!points.empty() && distance(points.back(), next) < 1e-9) return;
        points.push_back(next);
        stops_.push_back(stops[i % stops.size()]);
        numbers_.push_back(i % stops.size());
    };
    for (std::size_t i = 0; i < stops.size(); ++i) add(i);
    const bool loops = closed && points.size() > 1;
    if (loops) add(stops.size());
    const auto mirrored = [](const Point& end, const Point& inner) {
        Point beyond{};
        for (std::size_t i = 0; i < end.size(); ++i) beyond[i] = 2 * end[i] - inner[i];
        return beyond;
    };
    // A closed path continues as it began, with a bearing that differs by whole turns.
    const auto shifted = [&](Point p, double bearing) {
        p[3] += bearing;
        return p;
    };
    const std::size_t n = points.size();
    const double turns = points.back()[3] - points.front()[3];
    const Point& second = points[std::min<std::size_t>(1, n - 1)];
    const Point& beforeLast = points[n >= 2 ? n - 2 : 0];
    points_.push_back(loops ? shifted(beforeLast, -turns) : mirrored(points.front(), second));
    points_.insert(points_.end(), points.begin(), points.end());
    points_.push_back(loops ? shifted(second, turns) : mirrored(points.back(), beforeLast));
    for (std::size_t leg = 0; leg + 1 < n; ++leg) {
        Point before = onLeg(leg, 0);
        for (std::size_t i = 1; i <= piecesOfLeg; ++i) {
            const Point next = onLeg(leg, static_cast<double>(i) / piecesOfLeg);
            lengths_.push_back(lengths_.back() + distance(before, next));
            before = next;
        }
    }
}

CameraPath::Point CameraPath::onLeg(std::size_t leg, double part) const
{
    // Barry and Goldman's pyramid over four knots, whose distances are the square roots of those between the points.
    std::array<Point, 4> p{};
    std::array<double, 4> knot{};
    for (std::size_t i = 0; i < 4; ++i) {
        p.at(i) = points_[leg + i];
        if (i > 0) knot.at(i) = knot.at(i - 1) + std::max(std::sqrt(distance(p.at(i - 1), p.at(i))), 1e-6);
    }
    const double t = knot[1] + part * (knot[2] - knot[1]);
    for (std::size_t level = 1; level < 4; ++level)
        for (std::size_t i = 0; i + level < 4; ++i) {
            // The last level spans the two knots in the center.
            const double low = level == 3 ? knot[1] : knot.at(i);
            const double high = level == 3 ? knot[2] : knot.at(i + level);
            const double share = (t - low) / (high - low);
            for (std::size_t c = 0; c < p[0].size(); ++c)
                p.at(i).at(c) = (1 - share) * p.at(i).at(c) + share * p.at(i + 1).at(c);
        }
    // The clamp is here, and not where the camera is made, so the length accounts for it.
    p[0][4] = std::clamp(p[0][4], -steepest, steepest);
    return p[0];
}

render::Camera CameraPath::at(double share) const
{
    if (!(share > 0) || stops_.size() == 1) return stops_.front();
    if (share >= 1) return stops_.back();
    const double length = share * lengths_.back();
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    const auto piece = static_cast<std::size_t>(after - lengths_.begin()) - 1;
    const double within = (length - lengths_[piece]) / (*after - lengths_[piece]);
    const std::size_t leg = piece / piecesOfLeg;
    return cameraAt(
        onLeg(leg, (static_cast<double>(piece - leg * piecesOfLeg) + within) / static_cast<double>(piecesOfLeg)));
}

std::size_t CameraPath::stopBefore(double share) const
{
    const double length = std::clamp(share, 0.0, 1.0) * lengths_.back();
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end() - 1, length);
    const auto piece = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - lengths_.begin() - 1, 0));
    return numbers_[std::min(piece / piecesOfLeg, numbers_.size() - 1)];
}

double paced(Pace pace, double part)
{
    const double t = std::clamp(part, 0.0, 1.0);
    return pace == Pace::eased ? t * t * (3 - 2 * t) : t;
}

render::Camera turned(const render::Camera& camera, double angle)
{
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0));
    render::Camera result = camera;
    result.eye = camera.target + glm::dvec3(turn * glm::dvec4(camera.eye - camera.target, 0));
    return result;
}

bool isWholeTurns(double angle)
{
    return angle != 0 && std::abs(std::remainder(angle, 2 * std::numbers::pi)) < 1e-9;
}

CameraMotion turntable(const render::Camera& camera, double angle, Pace pace)
{
    const double begin = isWholeTurns(angle) ? 0 : -angle / 2;
    return [camera, angle, pace, begin](double part) { return turned(camera, begin + angle * paced(pace, part)); };
}

}  // namespace vitrine::recording

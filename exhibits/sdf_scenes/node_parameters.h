#pragma once

#include "exhibits/sdf_scenes/node_kinds.h"
#include "exhibits/sdf_scenes/scene_functions_cpu.h"

#include <algorithm>
#include <limits>
#include <numbers>

// Helpers to declare the fields of node kinds. Only for the source files with these declarations.

namespace vitrine::scenes {

inline constexpr double radiansPerDegree = std::numbers::pi / 180;
/// Smallest and largest legal size in meters; values beyond are considered mistakes.
inline constexpr double smallestSize = 1e-4, largestSize = 1e4;
inline constexpr double noEnd = std::numeric_limits<double>::infinity();

/// Factor from a size's initial value to either end of its slider, which is logarithmic.
inline constexpr double sizeSpan = 8;

inline Field size(std::string_view name, double initial, std::string_view help)
{
    return {name,        FieldType::real,    Unit::meter,        smallestSize,
            largestSize, initial / sizeSpan, initial * sizeSpan, {initial, 0, 0},
            help};
}
/// Returns a size field that may be 0.
inline Field width(std::string_view name, double initial, std::string_view help)
{
    return {name, FieldType::real, Unit::meter, 0, largestSize, 0, 1, {initial, 0, 0}, help};
}
inline Field sizes(std::string_view name, const std::array<double, 3>& initial, std::string_view help)
{
    const auto [least, most] = std::minmax({initial[0], initial[1], initial[2]});
    return {name, FieldType::sizes, Unit::meter, smallestSize, largestSize, least / sizeSpan, most * sizeSpan, initial,
            help};
}
inline Field point(std::string_view name, const std::array<double, 3>& initial, std::string_view help)
{
    return {name, FieldType::vector, Unit::meter, -largestSize, largestSize, -4, 4, initial, help};
}
inline Field height(std::string_view name, double initial, std::string_view help)
{
    return {name, FieldType::real, Unit::meter, -largestSize, largestSize, -2, 2, {initial, 0, 0}, help};
}
inline Field angle(std::string_view name, double initial, double low, double high, std::string_view help)
{
    return {name,
            FieldType::real,
            Unit::degree,
            low * radiansPerDegree,
            high * radiansPerDegree,
            low * radiansPerDegree,
            high * radiansPerDegree,
            {initial * radiansPerDegree, 0, 0},
            help};
}
inline Field plain(std::string_view name, double initial, double low, double high, std::string_view help)
{
    return {name, FieldType::real, Unit::none, low, high, low, high, {initial, 0, 0}, help};
}
inline Field count(std::string_view name, double initial, double low, double high, std::string_view help)
{
    return {name, FieldType::count, Unit::none, low, high, low, high, {initial, 0, 0}, help};
}
inline Field toggle(std::string_view name, bool initial, std::string_view help)
{
    return {name, FieldType::toggle, Unit::none, 0, 1, 0, 1, {initial ? 1.0 : 0.0, 0, 0}, help};
}

inline glm::dvec3 vec3At(const double* v, std::size_t i)
{
    return {v[i], v[i + 1], v[i + 2]};
}

/// Returns the extent of a shape that is symmetric in all coordinates and fits a box of this half size around the
/// origin.
inline Bounds evenExtent(const glm::dvec3& halfSize)
{
    return {boxAround(halfSize), evenInAll};
}
/// Returns the extent of a solid of revolution about the segment from a to b, with all points within `radius` of it.
inline Bounds segmentExtent(const glm::dvec3& a, const glm::dvec3& b, double radius)
{
    return {grown({glm::min(a, b), glm::max(a, b)}, radius), a.z == 0 && b.z == 0 ? evenInZ : 0};
}
/// Returns the same of a solid that consists of balls with their centers on the segment.
inline Bounds ballsExtent(const glm::dvec3& a, const glm::dvec3& b, double radius)
{
    Bounds all = segmentExtent(a, b, radius);
    if (a.z == 0 && b.z == 0) all.ballsFrom = std::min(a.x, b.x);
    return all;
}

}  // namespace vitrine::scenes

// Makes an expression available as GLSL text and as a C++ function with the given parameters.
#define SCENE_FUNCTION(Result, expression, ...)                                                                        \
    {                                                                                                                  \
#expression, [](__VA_ARGS__, [[maybe_unused]] const double* v) -> Result {                                     \
            using namespace glsl;                                                                                      \
            [[maybe_unused]] const auto V = [v](std::size_t n) { return v[n]; };                                       \
            [[maybe_unused]] const auto V3 = [v](std::size_t n) { return vec3At(v, n); };                              \
            return expression;                                                                                         \
        }       \
    }
#define SCENE_DISTANCE(expression) SCENE_FUNCTION(double, expression, [[maybe_unused]] const glm::dvec3& p)
#define SCENE_PLACE(expression) SCENE_FUNCTION(glm::dvec3, expression, [[maybe_unused]] const glm::dvec3& p)
#define SCENE_AFTER(expression) SCENE_FUNCTION(double, expression, double d, [[maybe_unused]] const glm::dvec3& p)
#define SCENE_COPY(expression) SCENE_FUNCTION(glm::dvec3, expression, const glm::dvec3& p, int i)
#define SCENE_COMBINE(expression)                                                                                      \
    SCENE_FUNCTION(double, expression, [[maybe_unused]] double a, [[maybe_unused]] double b)

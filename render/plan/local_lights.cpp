#include "render/plan/local_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vitrine::render {
namespace {

/// Luminance of the irradiance at `center`, ignoring the light's range and cone.
double strengthAt(const LocalLight& light, const glm::dvec3& center)
{
    const double distance = std::max({glm::distance(light.position, center), light.radius, 1e-3});
    return glm::dot(light.intensity, glm::dvec3(0.2126, 0.7152, 0.0722)) / (distance * distance);
}

bool reaches(const LocalLight& light, const glm::dvec3& center, double radius)
{
    const double distance = glm::distance(light.position, center);
    return std::isfinite(distance) && strengthAt(light, center) > 0 &&
           (light.range <= 0 || distance - radius < light.range);
}

/// Accounts for rounding in shaders, meters.
constexpr double slack = 1e-3;

/// Box around the part of `within` that a view may show. Parallel projections show all of it.
Box seenPart(const View& view, const Box& within)
{
    if (view.clipFromView[2][3] == 0) return within;
    Box seen{view.eye, view.eye};
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)}) {
        // Slightly outside, because a sample may lie anywhere in its pixel.
        const glm::dvec3 far = view.eye + within.farthest(view.eye) * view.direction(1.02 * corner);
        seen.include(far);
    }
    return seen.intersection(within);
}

/// The cone and the range of a light.
class LitPart {
public:
    explicit LitPart(const LocalLightEntry& light)
        : position_(light.position), axis_(light.axis), hasCone_(light.coneScale > 0),
          range_(light.range > 0 ? light.range + slack : std::numeric_limits<double>::infinity())
    {
        if (hasCone_) cosine_ = std::clamp(static_cast<double>(light.coneCosine) - 1.0 / light.coneScale, -1.0, 1.0);
        sine_ = std::sqrt(1 - cosine_ * cosine_);
    }

    [[nodiscard]] bool mayReach(const Box& box) const
    {
        if (glm::distance(position_, glm::clamp(position_, box.low, box.high)) > range_) return false;
        if (!hasCone_) return true;
        const double radius = glm::length(box.halfSize()) + slack;
        const glm::dvec3 away = box.center() - position_;
        const double along = glm::dot(away, axis_);
        const double across = std::sqrt(std::max(glm::dot(away, away) - along * along, 0.0));
        // The distance from a line on the cone's surface, and from the plane through its tip.
        return cosine_ * across - sine_ * along <= radius && (cosine_ < 0 || -along <= radius);
    }

    /// Returns whether a place within `reach` meters of the light may lie on the side of the plane where `plane` is
    /// positive: a unit normal, and the distance from the origin.
    [[nodiscard]] bool mayReach(const glm::dvec4& plane, double reach) const
    {
        const glm::dvec3 normal(plane);
        const double tip = glm::dot(normal, position_) + plane.w;
        if (tip + reach < -slack) return false;
        if (!hasCone_ || cosine_ < 0.1) return true;
        // The cone up to its base, a disk `reach` meters away.
        const double cosine = glm::dot(normal, axis_);
        const double rim = sine_ / cosine_ * std::sqrt(std::max(1 - cosine * cosine, 0.0));
        return std::max(tip, tip + reach * (cosine + rim)) >= -slack;
    }

    [[nodiscard]] double range() const { return range_; }
    [[nodiscard]] const glm::dvec3& position() const { return position_; }

private:
    glm::dvec3 position_;
    glm::dvec3 axis_;
    bool hasCone_;
    double range_;
    double cosine_ = 1;  ///< Cosine of the half angle at which its light ends.
    double sine_ = 0;
};

bool mayReach(const LitPart& lit, const ShadedSpace& space, const std::optional<Box>& part, const View& view)
{
    if (part && !lit.mayReach(*part)) return false;
    if (!space.inView) return true;
    const double reach = part ? std::min(lit.range(), part->farthest(lit.position())) : lit.range();
    if (!std::isfinite(reach)) return true;
    const glm::dmat4 rows = glm::transpose(view.clipFromWorld);
    for (const glm::dvec4& plane :
         {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3]})
        if (const double length = glm::length(glm::dvec3(plane)); length > 0 && !lit.mayReach(plane / length, reach))
            return false;
    return true;
}

/// Bits of the first `count` lights.
std::uint32_t firstLights(int count)
{
    return count >= 32 ? ~0U : (1U << count) - 1;
}

/// Returns the box that is divided into cells; an empty one if there is one cell only.
Box cellsOf(const LocalLightsBlock& block)
{
    if (block.cellsPerMeter == glm::vec3(0)) return {};
    const glm::dvec3 low(block.cellsLow);
    return {low - slack,
            low + glm::dvec3(LIGHT_CELLS_X, LIGHT_CELLS_Y, LIGHT_CELLS_Z) / glm::dvec3(block.cellsPerMeter) + slack};
}

/// Calls `change` for each cell's bits.
template <typename Change> void forEachCell(LocalLightsBlock& block, Change change)
{
    int index = 0;
    for (glm::ivec4& four : block.cells)
        for (int i = 0; i < 4; ++i) four[i] = static_cast<int>(change(static_cast<std::uint32_t>(four[i]), index++));
}

}  // namespace

LocalLighting localLighting(std::span<const LocalLight> lights, const glm::dvec3& center, double radius)
{
    LocalLighting result;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (reaches(lights[i], center, radius)) result.chosen.push_back(i);
    std::stable_sort(result.chosen.begin(), result.chosen.end(), [&](std::size_t a, std::size_t b) {
        return strengthAt(lights[a], center) > strengthAt(lights[b], center);
    });
    if (result.chosen.size() > mostLocalLights) result.chosen.resize(mostLocalLights);
    result.block.count = static_cast<int>(result.chosen.size());
    for (std::size_t i = 0; i < result.chosen.size(); ++i) {
        const LocalLight& light = lights[result.chosen[i]];
        LocalLightEntry& entry = result.block.lights[i];
        entry.position = glm::vec3(light.position);
        entry.radius = static_cast<float>(std::max(light.radius, 0.0));
        entry.intensity = glm::vec3(light.intensity);
        entry.range = static_cast<float>(light.range);
        entry.nearest = static_cast<float>(std::max(light.nearest, 0.0));
        if (light.axis != glm::dvec3(0)) {
            entry.axis = glm::vec3(light.axis);
            entry.coneCosine = static_cast<float>(std::cos(light.coneInner));
            entry.coneScale =
                static_cast<float>(1 / std::max(std::cos(light.coneInner) - std::cos(light.coneOuter), 1e-6));
        }
        if (!light.castsShadow || result.shadowed.size() >= mostLocalShadows) continue;
        entry.castsShadow = true;
        entry.firstLayer = static_cast<int>(6 * result.shadowed.size());
        entry.nearPlane = static_cast<float>(localShadowNear);
        result.shadowed.push_back(result.chosen[i]);
    }
    result.block = inOneCell(std::move(result.block));
    return result;
}

void divideIntoCells(LocalLightsBlock& block, const Box& space)
{
    const glm::dvec3 count(LIGHT_CELLS_X, LIGHT_CELLS_Y, LIGHT_CELLS_Z);
    const glm::dvec3 size = glm::max(space.high - space.low, 1e-3) / count;
    block.cellsLow = glm::vec3(space.low);
    block.cellsPerMeter = glm::vec3(1.0 / size);
    std::vector<LitPart> lit;
    for (int i = 0; i < block.count; ++i) lit.emplace_back(block.lights[static_cast<std::size_t>(i)]);
    forEachCell(block, [&](std::uint32_t, int index) {
        const glm::dvec3 at(index % LIGHT_CELLS_X, index / LIGHT_CELLS_X % LIGHT_CELLS_Y,
                            index / (LIGHT_CELLS_X * LIGHT_CELLS_Y));
        // Wider, because shaders find the cell at float32.
        const Box cell{space.low + at * size - slack, space.low + (at + 1.0) * size + slack};
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < lit.size(); ++i)
            if (lit[i].mayReach(cell)) bits |= 1U << i;
        return bits;
    });
}

LocalLightsBlock inOneCell(LocalLightsBlock block)
{
    block.cellsPerMeter = glm::vec3(0);
    block.cells[0][0] = static_cast<int>(firstLights(block.count));
    return block;
}

LocalLightsBlock reachingLights(const LocalLightsBlock& all, const ShadedSpace& space, const View& view)
{
    std::optional<Box> part = space.within;
    if (part && space.inView) part = seenPart(view, *part);
    LocalLightsBlock result;
    if (part && part->empty()) return result;
    std::array<std::size_t, mostLocalLights> kept{};
    for (int i = 0; i < all.count; ++i) {
        const LocalLightEntry& light = all.lights[static_cast<std::size_t>(i)];
        if (!mayReach(LitPart(light), space, part, view)) continue;
        kept[static_cast<std::size_t>(result.count)] = static_cast<std::size_t>(i);
        result.lights[static_cast<std::size_t>(result.count)] = light;
        ++result.count;
    }
    const Box cells = cellsOf(all);
    if (!space.within || !cells.contains(space.within->low) || !cells.contains(space.within->high))
        return inOneCell(std::move(result));
    result.cellsLow = all.cellsLow;
    result.cellsPerMeter = all.cellsPerMeter;
    result.cells = all.cells;
    forEachCell(result, [&](std::uint32_t bits, int) {
        std::uint32_t left = 0;
        for (int i = 0; i < result.count; ++i) left |= (bits >> kept[static_cast<std::size_t>(i)] & 1U) << i;
        return left;
    });
    return result;
}

}  // namespace vitrine::render

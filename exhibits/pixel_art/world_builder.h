#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine {

/// What a piece of the small world is painted with; patterns are those of shaders/pixel_art/patterns.glsl.
struct Paint {
    glm::vec3 color{1};  ///< Linear Rec. 709.
    int pattern = 0;
    float glow = 0;
};

/// Sews solids into one mesh whose tangents hold color and object number, and whose `extra` holds glow and pattern.
class WorldBuilder {
public:
    explicit WorldBuilder(std::string name) { mesh_->name = std::move(name); }

    /// What follows is another object: lines are drawn between objects.
    WorldBuilder& object();
    /// Where what follows stands.
    WorldBuilder& at(const glm::dmat4& modelFromPart);
    WorldBuilder& at(const glm::dvec3& place, double turn = 0);

    /// From -half to half; uv in meters on every face.
    WorldBuilder& box(const glm::dvec3& half, const Paint&);
    /// Around +y from 0 to `height`, radii at foot and top, flat or smooth sides, closed.
    WorldBuilder& prism(int sides, double foot, double top, double height, const Paint&, bool smooth = false);
    /// Smooth, radii along the axes.
    WorldBuilder& ball(const glm::dvec3& radii, const Paint&, int rings = 8);
    /// Around +y, smooth.
    WorldBuilder& torus(double ring, double tube, const Paint&, int around = 28, int across = 14);
    /// A roof over x, z: the ridge along z.
    WorldBuilder& gable(const glm::dvec3& half, const Paint& roof, const Paint& wall);
    /// An outline of `outline(angle)` meters, extruded from `low` to `high`; the side leans in by `lean`.
    WorldBuilder& slab(const std::function<double(double)>& outline, double low, double high, double lean,
                       const Paint& top, const Paint& side, int sides = 48);
    /// Water around that outline, at `height`: u is the distance from the shore, v the angle over a turn.
    WorldBuilder& water(const std::function<double(double)>& outline, double height, double reach, const Paint&);
    /// A rectangle of tiles facing up, uv counts tiles.
    WorldBuilder& tiles(const glm::dvec2& half, double tile, const Paint&);

    [[nodiscard]] std::shared_ptr<const render::Mesh> finished();

private:
    void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Paint&);
    void quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d, const Paint&,
              glm::dvec2 uvA, glm::dvec2 uvC);
    std::uint32_t vertex(const glm::dvec3& p, const glm::dvec3& n, glm::dvec2 uv, const Paint&);

    std::shared_ptr<render::Mesh> mesh_ = std::make_shared<render::Mesh>();
    glm::dmat4 place_{1};
    int object_ = 0;
};

}  // namespace vitrine

#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::pixel_art {

/// Paint of a piece of the small world; patterns are those of shaders/pixel_art/patterns.glsl.
struct Paint {
    glm::vec3 color{1};  ///< Linear Rec. 709.
    int pattern = 0;
    float glow = 0;
};

/// Builder of one mesh from solids. Its tangents contain color and object number, its `extra` glow and pattern.
class WorldBuilder {
public:
    explicit WorldBuilder(std::string name) { mesh_->name = std::move(name); }

    /// Begins another object: lines are drawn between objects.
    WorldBuilder& object();
    /// Sets the place of the pieces that follow.
    WorldBuilder& at(const glm::dmat4& modelFromPart);
    WorldBuilder& at(const glm::dvec3& place, double turn = 0);

    /// Adds a box from -half to half; uv is in meters on every face.
    WorldBuilder& box(const glm::dvec3& half, const Paint&);
    /// Adds a closed prism around +y from 0 to `height`, with radii at foot and top, and flat or smooth sides.
    WorldBuilder& prism(int sides, double foot, double top, double height, const Paint&, bool smooth = false);
    /// Adds a smooth ellipsoid with radii along the axes.
    WorldBuilder& ball(const glm::dvec3& radii, const Paint&, int rings = 8);
    /// Adds a smooth torus around +y.
    WorldBuilder& torus(double ring, double tube, const Paint&, int around = 28, int across = 14);
    /// Adds a roof over x, z with its ridge along z.
    WorldBuilder& gable(const glm::dvec3& half, const Paint& roof, const Paint& wall);
    /// Extrusion of an outline, in meters: from `low` to `high`, and `lean` narrower at its top.
    struct Extrusion {
        double low = 0, high = 0, lean = 0;
    };
    /// Adds an outline of `outline(angle)` meters, extruded.
    WorldBuilder& slab(const std::function<double(double)>& outline, const Extrusion&, const Paint& top,
                       const Paint& side, int sides = 48);
    /// Adds water around that outline at `height`: u is the distance from the shore, v the angle in turns.
    WorldBuilder& water(const std::function<double(double)>& outline, double height, double reach, const Paint&);
    /// Adds a rectangle of tiles that faces up; uv counts tiles.
    WorldBuilder& tiles(const glm::dvec2& half, double tile, const Paint&);

    [[nodiscard]] std::shared_ptr<const render::Mesh> finished();

private:
    void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Paint&);
    void quad(const std::array<glm::dvec3, 4>& corners, const Paint&, glm::dvec2 uvOfFirst, glm::dvec2 uvOfThird);
    std::uint32_t vertex(const glm::dvec3& p, const glm::dvec3& n, glm::dvec2 uv, const Paint&);

    std::shared_ptr<render::Mesh> mesh_ = std::make_shared<render::Mesh>();
    glm::dmat4 place_{1};
    int object_ = 0;
};

}  // namespace vitrine::pixel_art

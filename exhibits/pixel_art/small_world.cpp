#include "exhibits/pixel_art/small_world.h"

#include "exhibits/kit/surface_draw.h"
#include "exhibits/pixel_art/world_builder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::pixel_art {
namespace {

using Shared = std::shared_ptr<const render::Mesh>;

const Paint stone{{0.62, 0.57, 0.50}}, gold{{0.95, 0.60, 0.12}}, crystal{{0.16, 0.66, 0.72}, 0, 0.12F};

glm::dmat4 moved(const glm::dvec3& place)
{
    return glm::translate(glm::dmat4(1), place);
}

/// Returns the transform of an object that turns once about two axes in a round, like the reference's torus.
glm::dmat4 tumbled(double time, const glm::dvec3& place, double scale)
{
    const double turn = 2 * std::numbers::pi * time / worldRound;
    glm::dmat4 m = glm::rotate(moved(place), turn, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, turn + 0.9, glm::dvec3(1, 0, 0));
    return glm::scale(m, glm::dvec3(scale));
}

double bob(double time, double phase)
{
    return std::sin(2 * std::numbers::pi * (time / 2 + phase));
}

Shared torusMesh()
{
    static const Shared mesh = WorldBuilder("torus").object().torus(0.4, 0.1, gold, 96, 48).finished();
    return mesh;
}

Shared cubeMesh(const Paint& paint)
{
    return WorldBuilder("cube").object().box(glm::dvec3(0.375), paint).finished();
}

/// Adds a cylinder with hexagonal caps, like the three of the reference, but rounder. So its facets are no error of a
/// method.
void pylon(WorldBuilder& b, const glm::dvec3& place, double half, const Paint& paint)
{
    b.object().at(place).prism(64, 0.3, 0.3, 2 * half, paint, true);
    b.at(place + glm::dvec3(0, 2 * half, 0)).prism(6, 0.42, 0.42, 0.16, paint);
    b.at(place).prism(6, 0.42, 0.42, 0.16, paint);
}

Shared testFloor()
{
    static const Shared mesh = [] {
        WorldBuilder b("test scene");
        b.object().at(glm::dvec3(0, -0.1, 0)).box({4, 0.1, 4}, stone);
        b.at(glm::dvec3(0, 0.001, 0)).tiles(glm::dvec2(4), 1, {stone.color, 1});
        pylon(b, {3, 0, 3}, 0.8, stone);
        pylon(b, {-3, 0, -3}, 0.8, stone);
        pylon(b, {-2, 0, 2}, 0.5, stone);
        for (const glm::dvec3 p :
             {glm::dvec3(2, 0.375, -2), glm::dvec3(1.4, 0.375, 1.2), glm::dvec3(-0.6, 0.375, -2.4)})
            b.object().at(p, p.x).box(glm::dvec3(0.375), gold);
        return b.finished();
    }();
    return mesh;
}

Shared barMesh()
{
    static const Shared mesh = [] {
        constexpr double texel = 9.8 / 135;
        WorldBuilder b("bars");
        b.object().at(glm::dvec3(0, -0.1, 0)).box({7, 0.1, 7}, stone);
        for (int i = 0; i < 9; ++i) {
            const double thick = 0.5 * texel * (1 + i % 3);
            const double at = 0.9 * (i - 4);
            b.object().at(glm::dvec3(at, 1.2, -at)).box({thick, 1.2, thick}, gold);
            b.object().at(glm::dvec3(at + 1.2, 0.4 + 0.2 * i, 1.2 - at), 0.785).box({0.9, thick, thick}, crystal);
            glm::dmat4 leaning = glm::rotate(moved({at - 1.4, 0.9, -1.4 - at}), 0.6 + 0.1 * i, glm::dvec3(0.7, 0, 0.7));
            b.object().at(leaning).box({thick, 1.1, thick}, stone);
        }
        return b.finished();
    }();
    return mesh;
}

}  // namespace

std::vector<WorldPart> testParts(double time)
{
    static const Shared cube = cubeMesh(crystal);
    return {{testFloor(), glm::dmat4(1), 0},
            {torusMesh(), tumbled(time, {0, 1.1, 0}, 1), 20},
            {cube, moved({-1.8, 1.1 + 0.5 * bob(time, 0), -0.4}), 21},
            {cube, moved({2.4, 1.1 + 0.5 * bob(time, 0.5), 0.2}), 22}};
}

std::vector<WorldPart> barParts()
{
    return {{barMesh(), glm::dmat4(1), 0}};
}

std::vector<WorldPart> modelParts(const render::Model& model, const render::Box& framed, double time)
{
    constexpr double across = 5;  // Meters of its largest side.
    const glm::dvec3 half = framed.halfSize();
    const double largest = 2 * std::max({half.x, half.y, half.z});
    const double scale = largest > 0 ? across / largest : 1;
    glm::dmat4 place = glm::rotate(glm::dmat4(1), 2 * std::numbers::pi * time / worldRound, glm::dvec3(0, 1, 0));
    place = glm::translate(glm::scale(place, glm::dvec3(scale)), -framed.center());
    std::vector<WorldPart> parts;
    int id = 0;
    for (const render::MeshInstance& part : model.parts)
        parts.push_back({part.mesh, place * part.modelFromPart, ++id, part.material});
    return parts;
}

render::Box boundsOf(const std::vector<WorldPart>& parts)
{
    render::Box all;
    for (const WorldPart& part : parts) {
        if (part.mesh->bounds.empty()) continue;
        const render::Box box = part.mesh->bounds.transformed(part.worldFromModel);
        all.include(box.low);
        all.include(box.high);
    }
    return all;
}

}  // namespace vitrine::pixel_art

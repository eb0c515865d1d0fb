#include "exhibits/pixel_art/small_world.h"
#include "exhibits/pixel_art/world_builder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace vitrine::pixel_art {
namespace {

using Shared = std::shared_ptr<const render::Mesh>;

// Patterns as in shaders/pixel_art/patterns.glsl.
const Paint grass{{0.24, 0.44, 0.10}, 2}, meadow{{0.28, 0.47, 0.11}, 2}, cliff{{0.36, 0.25, 0.18}, 7};
const Paint sand{{0.80, 0.64, 0.38}}, wall{{0.74, 0.66, 0.54}, 4}, roof{{0.66, 0.16, 0.09}, 6},
    wood{{0.40, 0.23, 0.11}, 6};
const Paint bark{{0.26, 0.15, 0.09}}, leaf{{0.17, 0.42, 0.12}, 5}, pine{{0.06, 0.28, 0.17}, 5},
    blossom{{0.86, 0.36, 0.44}, 5};
const Paint rock{{0.42, 0.40, 0.44}}, marble{{0.76, 0.70, 0.62}}, tile{{0.78, 0.68, 0.52}, 1}, curb{{0.55, 0.48, 0.42}};
const Paint lamp{{1.0, 0.72, 0.28}, 0, 1.0F}, dark{{0.10, 0.07, 0.08}}, sea{{0.018, 0.13, 0.24}, 3};
const Paint goldPaint{{0.95, 0.58, 0.10}}, crystalPaint{{0.12, 0.62, 0.70}, 0, 0.25F}, cloth{{0.80, 0.76, 0.66}};

double shore(double angle)
{
    return 5.15 + 0.45 * std::sin(2 * angle + 1.0) + 0.28 * std::sin(3 * angle + 0.4) + 0.12 * std::sin(7 * angle);
}

double meadowEdge(double angle)
{
    return shore(angle) - 0.55 - 0.18 * std::sin(4 * angle + 2);
}

double hillEdge(double angle)
{
    return 2.05 + 0.24 * std::sin(3 * angle + 0.5) + 0.12 * std::sin(5 * angle + 2);
}

constexpr double ground = 0.62;  ///< Height of the meadow, meters.
constexpr double hill = 1.75;    ///< Height of the hill behind the meadow, meters.
const glm::dvec3 hillPlace(2.45, 0, 1.35);

void roundTree(WorldBuilder& b, const glm::dvec3& p, double s, const Paint& paint)
{
    b.object().at(p).prism(7, 0.13 * s, 0.09 * s, 0.75 * s, bark, true);
    b.object().at(p + glm::dvec3(0, 1.15 * s, 0)).ball(glm::dvec3(0.62, 0.55, 0.62) * s, paint);
    b.at(p + glm::dvec3(-0.36, 0.95, 0.22) * s).ball(glm::dvec3(0.42, 0.36, 0.42) * s, paint);
    b.at(p + glm::dvec3(0.34, 0.98, -0.2) * s).ball(glm::dvec3(0.44, 0.38, 0.44) * s, paint);
    b.at(p + glm::dvec3(0.05, 1.52, 0.02) * s).ball(glm::dvec3(0.4, 0.34, 0.4) * s, paint);
}

void pineTree(WorldBuilder& b, const glm::dvec3& p, double s)
{
    b.object().at(p).prism(6, 0.11 * s, 0.09 * s, 0.5 * s, bark, true);
    b.object();
    for (int i = 0; i < 3; ++i)
        b.at(p + glm::dvec3(0, (0.4 + 0.48 * i) * s, 0), 0.4 * i)
            .prism(9, (0.62 - 0.15 * i) * s, 0, (0.86 - 0.08 * i) * s, pine);
}

void boulder(WorldBuilder& b, const glm::dvec3& p, double s, double turn)
{
    b.object().at(p, turn).prism(6, 0.5 * s, 0.3 * s, 0.42 * s, rock);
    b.object().at(p + glm::dvec3(0.42 * s, -0.02, 0.2 * s), turn + 1).prism(5, 0.26 * s, 0.14 * s, 0.2 * s, rock);
}

void lantern(WorldBuilder& b, const glm::dvec3& p)
{
    b.object().at(p).prism(6, 0.05, 0.05, 0.85, dark);
    b.object().at(p + glm::dvec3(0, 0.95, 0)).box({0.12, 0.14, 0.12}, lamp);
    b.object().at(p + glm::dvec3(0, 1.09, 0), 0.785).prism(4, 0.24, 0, 0.18, dark);
}

void land(WorldBuilder& b)
{
    b.object().slab([](double a) { return shore(a) + 0.25; }, {-0.5, 0.06, 0.35}, sand, sand, 72);
    b.object().slab(meadowEdge, {0, ground, 0.10}, grass, cliff, 56);
    b.object().at(hillPlace).slab(hillEdge, {ground - 0.1, hill, 0.16}, meadow, cliff, 40);
    b.at(glm::dvec3(0)).object().water(shore, 0.0, 60, sea);
}

/// Adds floor and pylons of the reference's scene, aged.
void court(WorldBuilder& b)
{
    const glm::dvec3 middle(-1.15, ground, -1.15);
    b.object().at(middle + glm::dvec3(0, 0.06, 0)).box({2.1, 0.08, 2.1}, curb);
    b.at(middle + glm::dvec3(0, 0.145, 0)).tiles(glm::dvec2(1.95), 0.65, tile);
    const auto column = [&](const glm::dvec3& p, double tall) {
        b.object().at(p).prism(6, 0.36, 0.36, 0.16, marble);
        b.object().at(p + glm::dvec3(0, 0.16, 0)).prism(12, 0.23, 0.2, tall, marble, true);
        b.object().at(p + glm::dvec3(0, 0.16 + tall, 0)).prism(6, 0.34, 0.34, 0.15, marble);
    };
    const double y = ground + 0.14;
    column({-2.75, y, 0.45}, 1.55);
    column({0.45, y, -2.75}, 1.55);
    column({-2.75, y, -2.75}, 0.62);
    column({0.45, y, 0.45}, 1.55);
    b.object().at(glm::dvec3(-1.15, y, -1.15)).prism(8, 0.62, 0.56, 0.14, marble);
    b.object().at(glm::dvec3(-1.15, y + 0.14, -1.15)).prism(8, 0.4, 0.36, 0.14, marble);
    b.object().at(glm::dvec3(-3.05, ground + 0.17, -2.0), 0.5).prism(6, 0.2, 0.18, 0.3, marble);
}

void stairs(WorldBuilder& b)
{
    b.object();
    for (int i = 0; i < 5; ++i) {
        const double t = 0.62 + 0.24 * (4 - i);
        const double top = ground + 0.23 * (i + 1);
        b.at(glm::dvec3(hillPlace.x - 1.55 - t + 0.35, 0.5 * (ground + top), hillPlace.z - 1.1))
            .box({0.13, 0.5 * (top - ground) + 0.01, 0.55}, curb);
    }
}

void house(WorldBuilder& b)
{
    const glm::dvec3 p = hillPlace + glm::dvec3(0.35, hill, 0.1);
    b.object().at(p + glm::dvec3(0, 0.5, 0)).box({0.85, 0.52, 0.7}, wall);
    b.object().at(p + glm::dvec3(0, 1.0, 0)).gable({1.05, 0.72, 0.9}, roof, wall);
    b.object().at(p + glm::dvec3(0.42, 1.62, 0.2)).box({0.13, 0.36, 0.13}, rock);
    b.object().at(p + glm::dvec3(-0.86, 0.34, -0.1)).box({0.03, 0.34, 0.19}, wood);
    b.object().at(p + glm::dvec3(-0.86, 0.58, 0.42)).box({0.03, 0.15, 0.13}, lamp);
    b.object().at(p + glm::dvec3(0.0, 0.58, -0.71)).box({0.15, 0.15, 0.03}, lamp);
    b.object().at(p + glm::dvec3(0.52, 0.58, -0.71)).box({0.13, 0.15, 0.03}, lamp);
}

void jetty(WorldBuilder& b)
{
    b.object().at(glm::dvec3(4.9, 0.26, -2.5), 0.35).box({1.45, 0.05, 0.36}, wood);
    for (const double x : {-0.2, 1.3})
        for (const double z : {-0.36, 0.36}) {
            const double c = std::cos(0.35), s = std::sin(0.35);
            b.object().at(glm::dvec3(4.9 + x * c + z * s, -0.3, -2.5 - x * s + z * c)).prism(6, 0.07, 0.07, 0.8, bark);
        }
}

void plants(WorldBuilder& b)
{
    roundTree(b, {-3.35, ground, 2.0}, 1.12, leaf);
    roundTree(b, {-1.75, ground, 3.25}, 0.95, blossom);
    roundTree(b, {2.9, ground, -1.55}, 0.85, leaf);
    pineTree(b, hillPlace + glm::dvec3(1.3, hill, -1.0), 1.0);
    pineTree(b, hillPlace + glm::dvec3(-0.75, hill, 1.25), 1.15);
    pineTree(b, {4.35, ground, 0.35}, 0.85);
    pineTree(b, {1.0, ground, 3.75}, 1.0);
    pineTree(b, {-0.2, ground, 4.15}, 0.8);
    for (const glm::dvec3 p : {glm::dvec3(-3.9, ground, 0.2), glm::dvec3(1.85, ground, -3.3),
                               glm::dvec3(-0.4, ground, 1.7), glm::dvec3(1.5, ground, -0.55)})
        b.object().at(p + glm::dvec3(0, 0.12, 0)).ball({0.32, 0.24, 0.3}, leaf, 6);
    boulder(b, {-4.9, -0.1, -3.0}, 0.8, 0.3);
    boulder(b, {-2.3, -0.1, -4.9}, 1.0, 1.3);
    boulder(b, {0.9, -0.1, -5.2}, 0.6, 2.0);
    boulder(b, {-0.3, ground - 0.05, 2.5}, 0.55, 0.7);
    lantern(b, {-3.2, ground, -0.5});
    lantern(b, {3.45, ground, -2.35});
}

Shared isleMesh()
{
    static const Shared mesh = [] {
        WorldBuilder b("isle");
        land(b);
        court(b);
        stairs(b);
        house(b);
        jetty(b);
        plants(b);
        return b.finished();
    }();
    return mesh;
}

Shared boatMesh()
{
    static const Shared mesh = [] {
        WorldBuilder b("boat");
        b.object().at(glm::scale(glm::dmat4(1), glm::dvec3(1.9, 1, 0.8))).prism(8, 0.3, 0.42, 0.3, wood);
        b.at(glm::dvec3(0, 0.301, 0)).box({0.55, 0.01, 0.2}, dark);
        b.object().at(glm::dvec3(0, 0.2, 0)).prism(5, 0.045, 0.03, 1.5, bark);
        b.object().at(glm::translate(glm::dmat4(1), {0.42, 1.0, 0})).box({0.4, 0.5, 0.02}, cloth);
        return b.finished();
    }();
    return mesh;
}

}  // namespace

std::vector<WorldPart> isleParts(double time)
{
    static const Shared torus = WorldBuilder("torus").object().torus(0.46, 0.14, goldPaint).finished();
    static const Shared cube = WorldBuilder("cube").object().box(glm::dvec3(0.26), crystalPaint).finished();
    const double turn = 2 * std::numbers::pi * time / worldRound;
    const auto at = [](const glm::dvec3& p) { return glm::translate(glm::dmat4(1), p); };
    const auto wave = [&](double phase) { return std::sin(2 * turn + phase); };
    glm::dmat4 tumbling = glm::rotate(at({-1.15, 2.0, -1.15}), turn, glm::dvec3(0, 1, 0));
    tumbling = glm::rotate(tumbling, turn + 1.1, glm::dvec3(1, 0, 0));
    const glm::dmat4 boat = glm::rotate(glm::rotate(at({5.6, -0.12 + 0.03 * wave(0), -3.9}), 0.5, glm::dvec3(0, 1, 0)),
                                        0.05 * wave(1), glm::dvec3(1, 0, 0));
    return {{isleMesh(), glm::dmat4(1), 0},
            {torus, tumbling, 200},
            {cube, glm::rotate(at({-5.3, 0.75 + 0.14 * wave(0), -2.0}), turn / 2 + 0.5, glm::dvec3(0, 1, 0)), 201},
            {cube, glm::rotate(at({2.1, 0.95 + 0.10 * wave(2), -4.3}), 0.9, glm::dvec3(0, 1, 0)), 202},
            {boatMesh(), boat, 203}};
}

}  // namespace vitrine::pixel_art

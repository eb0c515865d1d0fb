#include "exhibits/sdf_morph/torus_mug_cpu.h"
#include "exhibits/sdf_morph/torus_mug_cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace vitrine {
namespace {

using glm::dvec3;
using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;

f64::TorusMug sizes(double morph)
{
    return {morph, 0.35, 0.12, 0.28, 0.66, 0.045, 0.165, 0.09, 0.06};
}
f32::TorusMug sizes32(float morph)
{
    return {morph, 0.35F, 0.12F, 0.28F, 0.66F, 0.045F, 0.165F, 0.09F, 0.06F};
}

/// Returns random sizes within the sliders' ranges: thin, thick, small, large.
f64::TorusMug randomSizes(test::Random& random, double morph)
{
    const double mug = random.number(0.2, 0.4);
    return {morph,
            random.number(0.25, 0.45),
            random.number(0.06, 0.16),
            mug,
            random.number(0.5, 0.9),
            random.number(0.03, 0.08),
            random.number(0.13, 0.2),
            random.number(0.05, 0.11),
            random.number(0, 0.1)};
}

constexpr int moments = 41;
double moment(int i)
{
    return i / double(moments - 1);
}

TEST(TorusMug, EndsBitwiseOnThePureShapes)
{
    test::Random random(1);
    const auto torus = f32::torusMugShape(sizes32(0));
    const auto mug = f32::torusMugShape(sizes32(1));
    for (int i = 0; i < 20000; ++i) {
        const vec3 p(random.point(1));
        EXPECT_EQ(f32::sdfTorusMug(p, torus), f32::sdfTorus(vec3(p.x, p.z, p.y), 0.35F, 0.12F));
        EXPECT_EQ(f32::sdfTorusMug(p, torus), f32::sdfUprightTorus(p, sizes32(0.5F)));
        EXPECT_EQ(f32::sdfTorusMug(p, mug), f32::sdfMug(p, sizes32(0.5F)));
        // Values of morph out of range count as the nearest end.
        EXPECT_EQ(f32::sdfTorusMug(p, f32::torusMugShape(sizes32(-0.25F))), f32::sdfTorusMug(p, torus));
        EXPECT_EQ(f32::sdfTorusMug(p, f32::torusMugShape(sizes32(1.25F))), f32::sdfTorusMug(p, mug));
    }
}

TEST(TorusMug, MeltsWithoutAJump)
{
    // A jump would be visible. The fastest point moves by 3.5 m per unit of morph, and a jump would not shrink with the
    // step. At the torus's end the field is compared near the solid only, because far inside the pure torus is exact
    // and the union is a bound.
    test::Random random(2);
    std::vector<dvec3> points;
    for (int i = 0; i < 2000; ++i) points.push_back(random.point(0.7));
    constexpr double step = 1e-5;
    for (int i = 0; i < moments - 1; ++i) {
        const auto a = f64::torusMugShape(sizes(moment(i)));
        const auto b = f64::torusMugShape(sizes(moment(i) + step));
        for (const dvec3& p : points) {
            const double before = f64::sdfTorusMug(p, a);
            const double after = f64::sdfTorusMug(p, b);
            if (i == 0 && before < -0.02) continue;
            ASSERT_NEAR(before, after, 3.5 * step) << "morph " << moment(i);
        }
    }
    const auto nearly = f64::torusMugShape(sizes(1 - 1e-7));
    const auto mug = f64::torusMugShape(sizes(1));
    for (const dvec3& p : points) ASSERT_NEAR(f64::sdfTorusMug(p, nearly), f64::sdfTorusMug(p, mug), 1e-6);
}

TEST(TorusMug, IsOneLipschitzAtEveryMoment)
{
    test::Random random(3);
    for (int i = 0; i < moments; ++i) {
        for (int k = 0; k < 4; ++k) {
            const auto shape = f64::torusMugShape(k == 0 ? sizes(moment(i)) : randomSizes(random, moment(i)));
            for (int j = 0; j < 2000; ++j) {
                const dvec3 p = random.point(0.8);
                const dvec3 q = p + random.direction() * std::pow(10.0, random.number(-4, 0));
                ASSERT_LE(std::abs(f64::sdfTorusMug(p, shape) - f64::sdfTorusMug(q, shape)),
                          glm::length(p - q) * (1 + 1e-9));
            }
        }
    }
}

/// Topology of the solid as voxels: numbers of pieces and closed bubbles, and its Euler characteristic (pieces - holes
/// + bubbles), counted from corners, edges, faces and cubes.
struct Topology {
    int pieces = 0;
    int bubbles = 0;
    int euler = 0;

    [[nodiscard]] int holes() const { return pieces + bubbles - euler; }
};

template <typename Field> Topology topology(const Field& field, const dvec3& center, const dvec3& halfSize, int n)
{
    const int side = n + 2;  // One layer of empty cubes around.
    const auto index = [&](int x, int y, int z) { return std::size_t((z * side + y) * side + x); };
    std::vector<char> solid(std::size_t(side * side * side), 0);
    for (int z = 1; z <= n; ++z)
        for (int y = 1; y <= n; ++y)
            for (int x = 1; x <= n; ++x)
                solid[index(x, y, z)] = field(center + halfSize * ((dvec3(x, y, z) - 0.5) / double(n) * 2.0 - 1.0)) < 0;

    Topology found;
    // A cell of the complex exists if any cube around it is solid. Cell (a, b, c) spans the axes whose bit of `kind` is
    // set; its sign is (-1)^dimension.
    for (int z = 1; z < side; ++z)
        for (int y = 1; y < side; ++y)
            for (int x = 1; x < side; ++x)
                for (int kind = 0; kind < 8; ++kind) {
                    bool exists = false;
                    for (int around = 0; around < 8 && !exists; ++around)
                        if ((around & kind) == 0)
                            exists = solid[index(x - (around & 1), y - (around >> 1 & 1), z - (around >> 2))] != 0;
                    if (exists) found.euler += __builtin_popcount(unsigned(kind)) % 2 == 0 ? 1 : -1;
                }

    // Flood fill: solid cubes connect across corners as in the complex (26 neighbors), empty ones across faces (6).
    std::vector<char> seen(solid.size(), 0);
    std::vector<std::array<int, 3>> open;
    int airPieces = 0;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                if (seen[index(x, y, z)]) continue;
                const char what = solid[index(x, y, z)];
                (what ? found.pieces : airPieces) += 1;
                seen[index(x, y, z)] = 1;
                open.push_back({x, y, z});
                while (!open.empty()) {
                    const auto [cx, cy, cz] = open.back();
                    open.pop_back();
                    for (int dz = -1; dz <= 1; ++dz)
                        for (int dy = -1; dy <= 1; ++dy)
                            for (int dx = -1; dx <= 1; ++dx) {
                                if (!what && std::abs(dx) + std::abs(dy) + std::abs(dz) != 1) continue;
                                const int nx = cx + dx, ny = cy + dy, nz = cz + dz;
                                if (nx < 0 || ny < 0 || nz < 0 || nx >= side || ny >= side || nz >= side) continue;
                                if (seen[index(nx, ny, nz)] || solid[index(nx, ny, nz)] != what) continue;
                                seen[index(nx, ny, nz)] = 1;
                                open.push_back({nx, ny, nz});
                            }
                }
            }
    found.bubbles = airPieces - 1;
    return found;
}

TEST(LongTorusMug, IsOneBodyWithOneHoleAtEveryMoment)
{
    // The counting is checked on solids of known topology.
    const auto ball = topology([](const dvec3& p) { return f64::sdfSphere(p, 0.8); }, dvec3(0), dvec3(1), 24);
    EXPECT_EQ(ball.holes(), 0);
    const auto shell =
        topology([](const dvec3& p) { return f64::sdfOnion(f64::sdfSphere(p, 0.7), 0.3); }, dvec3(0), dvec3(1), 24);
    EXPECT_EQ(shell.bubbles, 1);
    EXPECT_EQ(shell.holes(), 0);
    // Negative control: mixing the two fields breaks the wall of the cup, or closes its hole, somewhere on the way.
    const auto mug = f64::torusMugShape(sizes(1));
    const auto box = f64::torusMugBoxOverMorph(sizes(0));
    bool broken = false;
    for (int i = 0; i < moments; ++i) {
        const auto mixed = topology(
            [&](const dvec3& p) {
                return f64::sdfMix(f64::sdfUprightTorus(p, sizes(0)), f64::sdfTorusMug(p, mug), moment(i));
            },
            box.center, box.halfSize, 64);
        broken = broken || mixed.pieces != 1 || mixed.holes() != 1;
    }
    EXPECT_TRUE(broken);

    for (int i = 0; i < moments; ++i) {
        const auto shape = f64::torusMugShape(sizes(moment(i)));
        const auto found =
            topology([&](const dvec3& p) { return f64::sdfTorusMug(p, shape); }, box.center, box.halfSize, 72);
        EXPECT_EQ(found.pieces, 1) << "morph " << moment(i);
        EXPECT_EQ(found.bubbles, 0) << "morph " << moment(i);
        EXPECT_EQ(found.holes(), 1) << "morph " << moment(i);
    }
}

TEST(LongTorusMug, StaysOneBodyWithOneHoleForOtherSizes)
{
    test::Random random(4);
    for (int k = 0; k < 24; ++k) {
        const auto m = randomSizes(random, random.number(0, 1));
        const auto shape = f64::torusMugShape(m);
        const auto box = f64::torusMugBox(shape);
        const auto found =
            topology([&](const dvec3& p) { return f64::sdfTorusMug(p, shape); }, box.center, box.halfSize, 72);
        EXPECT_EQ(found.pieces, 1) << "try " << k << ", morph " << m.morph;
        EXPECT_EQ(found.holes(), 1) << "try " << k << ", morph " << m.morph;
    }
}

TEST(TorusMug, ALookThroughTheHoleIsFreeAtEveryMoment)
{
    for (int i = 0; i < moments; ++i) {
        const auto shape = f64::torusMugShape(sizes(moment(i)));
        const dvec3 hole = shape.bodyCenter + dvec3(shape.ringCenter.x, shape.ringCenter.y, 0);
        double clearance = 1;
        for (int z = -200; z <= 200; ++z)
            clearance = std::min(clearance, f64::sdfTorusMug(hole + dvec3(0, 0, z * 0.005), shape));
        EXPECT_GT(clearance, 0.04) << "morph " << moment(i);
    }
}

TEST(TorusMug, TheWallOfTheCupIsThereAndAsThickAsAsked)
{
    // Wall opposite the handle, at half height: sign changes of the field along -x.
    const auto m = sizes(1);
    const auto shape = f64::torusMugShape(m);
    const auto at = [&](double x) { return f64::sdfTorusMug(shape.bodyCenter + dvec3(-x, 0.1, 0), shape); };
    EXPECT_NEAR(at(m.mugRadius), 0, 1e-12);
    EXPECT_NEAR(at(m.mugRadius - m.wallThickness), 0, 1e-12);
    EXPECT_LT(at(m.mugRadius - 0.5 * m.wallThickness), -0.2 * m.wallThickness);
    EXPECT_GT(at(0), 0.2);  // The cup is hollow.
    // Height from bottom to lip; the blend rounds the lip a little.
    double low = 1;
    double high = -1;
    for (double y = -0.6; y < 0.4; y += 0.0005)
        for (double x = -0.3; x < 0.3; x += 0.01)
            if (f64::sdfTorusMug(dvec3(shape.bodyCenter.x + x, y, 0), shape) < 0)
                low = std::min(low, y), high = std::max(high, y);
    EXPECT_NEAR(high - low, m.mugHeight, 0.012);
}

TEST(TorusMug, StandsOnItsGroundAndFillsItsBoxAtEveryMoment)
{
    test::Random random(5);
    for (int i = 0; i < moments; ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto m = k == 0 ? sizes(moment(i)) : randomSizes(random, moment(i));
            const auto shape = f64::torusMugShape(m);
            const auto box = f64::torusMugBox(shape);
            const auto everything = f64::torusMugBoxOverMorph(m);
            const double ground = -(m.majorRadius + m.minorRadius);
            dvec3 low(1e9);
            dvec3 high(-1e9);
            for (int j = 0; j < 60000; ++j) {
                const dvec3 p = dvec3(0, 0.1, 0) + random.point(1);
                if (f64::sdfTorusMug(p, shape) >= 0) continue;
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(low[axis], box.center[axis] - box.halfSize[axis]) << "morph " << moment(i);
                EXPECT_LE(high[axis], box.center[axis] + box.halfSize[axis]) << "morph " << moment(i);
                EXPECT_GE(box.center[axis] - box.halfSize[axis],
                          everything.center[axis] - everything.halfSize[axis] - 1e-9)
                    << "morph " << moment(i);
                EXPECT_LE(box.center[axis] + box.halfSize[axis],
                          everything.center[axis] + everything.halfSize[axis] + 1e-9)
                    << "morph " << moment(i);
                // Tight up to the bulge of the joint, the dent and the spacing of the samples.
                EXPECT_LT(box.halfSize[axis] * 2 - (high[axis] - low[axis]), 0.5 * shape.joint + 0.13)
                    << "morph " << moment(i);
            }
            EXPECT_GE(low.y, ground - 0.25 * shape.joint);
            EXPECT_LE(low.y, ground + 0.04);
        }
    }
}

TEST(TorusMug, NormalsAreUnitVectorsOnTheSaddlesAndEverywhere)
{
    test::Random random(6);
    for (int i = 0; i < moments; ++i) {
        const auto shape = f32::torusMugShape(sizes32(float(moment(i))));
        f32::Tracer tracer{[&](const vec3& p) { return f32::sdfTorusMug(p, shape); }};
        for (int j = 0; j < 2000; ++j) {
            // Half of the points are on planes of symmetry, where slopes cancel.
            vec3 p(random.point(0.6));
            if (j % 2 == 0) p.z = 0;
            if (j % 4 == 0) p.x = shape.bodyCenter.x;
            const float length = glm::length(tracer.fieldNormal(p, 3e-4F, j % 3, vec3(0, 0, 1)));
            ASSERT_NEAR(length, 1, 1e-5);
        }
    }
    // Zero gradient: the center of a ball.
    f32::Tracer ball{[](const vec3& p) { return f32::sdfSphere(p, 0.5F); }};
    EXPECT_EQ(ball.fieldNormal(vec3(0), 1e-3F, ball.NORMAL_TETRAHEDRON, vec3(0, 0, 1)), vec3(0, 0, 1));
    EXPECT_EQ(ball.fieldNormal(vec3(0), 1e-3F, ball.NORMAL_CENTRAL, vec3(0, 0, 1)), vec3(0, 0, 1));
    // Without the fallback, normalizing would give NaN.
}

TEST(TorusMug, AtFloat32DiffersFromFloat64ByRoundingOnly)
{
    test::Random random(7);
    double worst = 0;
    for (int i = 0; i < moments; ++i) {
        const auto near = f32::torusMugShape(sizes32(float(moment(i))));
        auto exactSizes = sizes(double(float(moment(i))));
        const auto far = f64::torusMugShape(exactSizes);
        for (int j = 0; j < 2000; ++j) {
            const vec3 p(random.point(1));
            worst = std::max(worst, std::abs(double(f32::sdfTorusMug(p, near)) - f64::sdfTorusMug(dvec3(p), far)));
        }
    }
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, 1e-6);
}

}  // namespace
}  // namespace vitrine

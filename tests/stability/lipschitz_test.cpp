// Every field that calls itself 1-Lipschitz or exact, tried at random. The offenders that the library marks
// as such are tried too: a fuzz that could not catch them would prove nothing.

#include "render/glsl/cpu.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using glm::dvec2;
using glm::dvec3;
using Field = std::function<double(const dvec3&)>;
using namespace glsl;

enum class Claim { exact, exactOutside, bound, steep };

struct Named {
    std::string name;
    Claim claim;
    Field field;
};

std::vector<Named> primitives()
{
    return {
        {"sphere", Claim::exact, [](const dvec3& p) { return sdfSphere(p, 0.7); }},
        {"plane", Claim::exact, [](const dvec3& p) { return sdfPlane(p, glm::normalize(dvec3(1, 2, -1)), 0.2); }},
        {"box", Claim::exact, [](const dvec3& p) { return sdfBox(p, dvec3(0.5, 0.3, 0.8)); }},
        {"roundBox", Claim::exact, [](const dvec3& p) { return sdfRoundBox(p, dvec3(0.5, 0.3, 0.8), 0.1); }},
        {"boxFrame", Claim::exactOutside, [](const dvec3& p) { return sdfBoxFrame(p, dvec3(0.6, 0.5, 0.8), 0.12); }},
        {"torus", Claim::exact, [](const dvec3& p) { return sdfTorus(p, 0.6, 0.2); }},
        {"cappedTorus 40", Claim::exact, [](const dvec3& p) { return sdfCappedTorus(p, 0.7, 0.6, 0.15); }},
        {"cappedTorus 140", Claim::exact, [](const dvec3& p) { return sdfCappedTorus(p, 2.45, 0.6, 0.15); }},
        {"cappedTorus closed", Claim::exact,
         [](const dvec3& p) { return sdfCappedTorus(p, 3.14159265358979, 0.6, 0.15); }},
        {"link", Claim::exactOutside, [](const dvec3& p) { return sdfLink(p, 0.3, 0.4, 0.12); }},
        {"infiniteCylinder", Claim::exact, [](const dvec3& p) { return sdfInfiniteCylinder(p, 0.4); }},
        {"cylinder", Claim::exact, [](const dvec3& p) { return sdfCylinder(p, 0.5, 0.4); }},
        {"roundCylinder", Claim::exact, [](const dvec3& p) { return sdfRoundCylinder(p, 0.5, 0.4, 0.1); }},
        {"capsule", Claim::exact,
         [](const dvec3& p) { return sdfCapsule(p, dvec3(-0.4, 0.1, 0), dvec3(0.5, 0.3, -0.4), 0.2); }},
        {"cappedCone", Claim::exact, [](const dvec3& p) { return sdfCappedCone(p, 0.5, 0.7, 0.2); }},
        {"cappedCone, wide above", Claim::exact, [](const dvec3& p) { return sdfCappedCone(p, 0.5, 0.2, 0.7); }},
        {"cone", Claim::exact, [](const dvec3& p) { return sdfCone(p, 0.6, 0.9); }},
        {"roundCone", Claim::exact, [](const dvec3& p) { return sdfRoundCone(p, 0.5, 0.2, 0.7); }},
        {"ellipsoid", Claim::steep, [](const dvec3& p) { return sdfEllipsoid(p, dvec3(0.7, 0.1, 0.5)); }},
        {"ellipsoidBound", Claim::bound, [](const dvec3& p) { return sdfEllipsoidBound(p, dvec3(0.7, 0.1, 0.5)); }},
        {"octahedron", Claim::exact, [](const dvec3& p) { return sdfOctahedron(p, 0.8); }},
        {"hexPrism", Claim::exact, [](const dvec3& p) { return sdfHexPrism(p, 0.6, 0.3); }},
        {"triangularPrism", Claim::exact, [](const dvec3& p) { return sdfTriangularPrism(p, 0.35, 0.3); }},
        {"solidAngle 40", Claim::exact, [](const dvec3& p) { return sdfSolidAngle(p, 0.7, 0.9); }},
        {"solidAngle 130", Claim::exactOutside, [](const dvec3& p) { return sdfSolidAngle(p, 2.27, 0.9); }},
        {"cutSphere above", Claim::exact, [](const dvec3& p) { return sdfCutSphere(p, 0.8, 0.3); }},
        {"cutSphere below", Claim::exact, [](const dvec3& p) { return sdfCutSphere(p, 0.8, -0.4); }},
        {"triangle", Claim::exact,
         [](const dvec3& p) { return sdfTriangle(p, dvec3(-0.5, 0, 0), dvec3(0.6, 0.2, 0.1), dvec3(0, 0.5, -0.6)); }},
    };
}

std::vector<Named> operators()
{
    const auto a = [](const dvec3& p) { return sdfBox(p - dvec3(0.2, 0, 0), dvec3(0.5, 0.3, 0.4)); };
    const auto b = [](const dvec3& p) { return sdfSphere(p + dvec3(0.2, -0.1, 0.1), 0.5); };
    const dvec3 scale(1.5, 0.5, 1);
    return {
        {"union", Claim::exactOutside, [=](const dvec3& p) { return sdfUnion(a(p), b(p)); }},
        {"intersection", Claim::bound, [=](const dvec3& p) { return sdfIntersection(a(p), b(p)); }},
        {"subtraction", Claim::bound, [=](const dvec3& p) { return sdfSubtraction(a(p), b(p)); }},
        {"subtraction deeper than the object (H26)", Claim::bound,
         [=](const dvec3& p) { return sdfSubtraction(a(p), sdfSphere(p, 3)); }},
        {"cleanSubtraction", Claim::bound, [=](const dvec3& p) { return sdfCleanSubtraction(a(p), b(p), 0.01); }},
        {"xor", Claim::bound, [=](const dvec3& p) { return sdfXor(a(p), b(p)); }},
        {"smoothUnion", Claim::bound, [=](const dvec3& p) { return sdfSmoothUnion(a(p), b(p), 0.3); }},
        {"smoothUnionCubic", Claim::bound, [=](const dvec3& p) { return sdfSmoothUnionCubic(a(p), b(p), 0.3); }},
        {"smoothUnionExponential", Claim::bound,
         [=](const dvec3& p) { return sdfSmoothUnionExponential(a(p), b(p), 0.1); }},
        {"smoothSubtraction", Claim::bound, [=](const dvec3& p) { return sdfSmoothSubtraction(a(p), b(p), 0.3); }},
        {"smoothIntersection", Claim::bound, [=](const dvec3& p) { return sdfSmoothIntersection(a(p), b(p), 0.3); }},
        {"mix at 0.3", Claim::bound, [=](const dvec3& p) { return sdfMix(a(p), b(p), 0.3); }},
        {"mix at 1.25", Claim::bound, [=](const dvec3& p) { return sdfMix(a(p), b(p), 1.25); }},
        {"mix at -0.5", Claim::bound, [=](const dvec3& p) { return sdfMix(a(p), b(p), -0.5); }},
        {"onion", Claim::bound, [=](const dvec3& p) { return sdfOnion(a(p), 0.1); }},
        {"round", Claim::exactOutside, [=](const dvec3& p) { return sdfRound(a(p), 0.1); }},
        {"scaled", Claim::exact, [=](const dvec3& p) { return sdfScaled(b(p / 1.7), 1.7); }},
        {"scaledBound", Claim::bound, [=](const dvec3& p) { return sdfScaledBound(b(p / scale), scale); }},
        {"extrude", Claim::exact,
         [](const dvec3& p) { return sdfExtrude(sdfRectangle(dvec2(p.x, p.y), dvec2(0.4, 0.2)), p.z, 0.3); }},
        {"elongate", Claim::exactOutside,
         [=](const dvec3& p) { return sdfSphere(sdfElongate(p, dvec3(0.3, 0.1, 0)), 0.4); }},
        {"revolve", Claim::exact, [](const dvec3& p) { return sdfRectangle(sdfRevolve(p, 0.6), dvec2(0.2, 0.1)); }},
        // What the corrections above are for.
        {"mix at 1.25, not divided", Claim::steep, [=](const dvec3& p) { return a(p) * -0.25 + b(p) * 1.25; }},
        {"scaled unevenly, not corrected", Claim::steep, [=](const dvec3& p) { return b(p / scale); }},
    };
}

/// Largest |f(p) - f(q)| / |p - q| over near and far pairs.
double steepest(const Field& field)
{
    test::Random random(7);
    double slope = 0;
    for (int i = 0; i < 60000; ++i) {
        const dvec3 p = random.point(1.5);
        const double apart = std::pow(10.0, random.number(-4, 0.3));
        const dvec3 q = p + random.direction() * apart;
        slope = std::max(slope, std::abs(field(p) - field(q)) / glm::length(p - q));
    }
    return slope;
}

dvec3 gradient(const Field& field, const dvec3& p)
{
    constexpr double h = 1e-6;
    return dvec3(field(p + dvec3(h, 0, 0)) - field(p - dvec3(h, 0, 0)),
                 field(p + dvec3(0, h, 0)) - field(p - dvec3(0, h, 0)),
                 field(p + dvec3(0, 0, h)) - field(p - dvec3(0, 0, h))) /
           (2 * h);
}

void expectKeepsItsClaim(const Named& named)
{
    SCOPED_TRACE(named.name);
    const double slope = steepest(named.field);
    if (named.claim == Claim::steep) {
        EXPECT_GT(slope, 1.2) << "the fuzz no longer catches a field that is too steep";
        return;
    }
    EXPECT_LE(slope, 1 + 1e-9);
    if (named.claim == Claim::bound)
        return;

    // Exact: going the distance down the gradient ends on the surface, for all points but those (of
    // measure zero, plus the width of the difference) where the nearest point is not unique.
    test::Random random(11);
    int tried = 0;
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const dvec3 p = random.point(1.5);
        const double d = named.field(p);
        if (named.claim == Claim::exactOutside && d <= 0)
            continue;
        ++tried;
        const dvec3 surface = p - gradient(named.field, p) * d;
        wrong += !(std::abs(named.field(surface)) < 1e-5);
    }
    EXPECT_GT(tried, 1000);
    EXPECT_LE(wrong, tried / 1000);
}

TEST(Lipschitz, EverySolidIsWhatItClaims)
{
    for (const Named& named : primitives())
        expectKeepsItsClaim(named);
}

TEST(Lipschitz, EveryOperatorIsWhatItClaims)
{
    for (const Named& named : operators())
        expectKeepsItsClaim(named);
}

/// The ends of each solid's extent, worked out by hand: |gradient| = 1 alone would not notice a solid of
/// the wrong size.
TEST(Lipschitz, SolidsHaveTheSizesTheyAreGiven)
{
    const auto zero = [](double d) { EXPECT_NEAR(d, 0, 1e-12); };
    zero(sdfRoundBox(dvec3(0.5, 0, 0), dvec3(0.5, 0.3, 0.8), 0.1));
    zero(sdfBoxFrame(dvec3(0.6, 0.5, 0), dvec3(0.6, 0.5, 0.8), 0.12));
    EXPECT_NEAR(sdfBoxFrame(dvec3(0, 0, 0), dvec3(0.5), 0.1), std::hypot(0.4, 0.4), 1e-12);
    zero(sdfTorus(dvec3(0.8, 0, 0), 0.6, 0.2));
    zero(sdfCappedTorus(dvec3(0, 0.75, 0), 0.7, 0.6, 0.15));
    zero(sdfCappedTorus(dvec3(0, -0.75, 0), 3.1415927, 0.6, 0.15));
    zero(sdfLink(dvec3(0, 0.82, 0), 0.3, 0.4, 0.12));
    zero(sdfCappedCone(dvec3(0.7, -0.5, 0), 0.5, 0.7, 0.2));
    zero(sdfCappedCone(dvec3(0.45, 0, 0), 0.5, 0.7, 0.2));
    zero(sdfCone(dvec3(0, 0.9, 0), 0.6, 0.9));
    zero(sdfCone(dvec3(0.3, 0.45, 0), 0.6, 0.9));
    zero(sdfRoundCone(dvec3(0, 0.9, 0), 0.5, 0.2, 0.7));
    zero(sdfRoundCone(dvec3(0, -0.5, 0), 0.5, 0.2, 0.7));
    zero(sdfEllipsoid(dvec3(0, 0.1, 0), dvec3(0.7, 0.1, 0.5)));
    zero(sdfOctahedron(dvec3(0.8, 0, 0), 0.8));
    zero(sdfHexPrism(dvec3(0, 0.6, 0), 0.6, 0.3));
    zero(sdfHexPrism(dvec3(0.6 * 2 / std::sqrt(3.0), 0, 0), 0.6, 0.3));
    zero(sdfTriangularPrism(dvec3(0, 0.7, 0), 0.35, 0.3));
    zero(sdfTriangularPrism(dvec3(0, -0.35, 0), 0.35, 0.3));
    zero(sdfSolidAngle(dvec3(0.9 * std::sin(0.7), 0.9 * std::cos(0.7), 0), 0.7, 0.9));
    zero(sdfSolidAngle(dvec3(0), 0.7, 0.9));
    zero(sdfCutSphere(dvec3(0, 0.3, 0), 0.8, 0.3));
    zero(sdfCutSphere(dvec3(0, -0.8, 0), 0.8, 0.3));
    EXPECT_NEAR(sdfTriangle(dvec3(0.1, 0.1, 0.4), dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0)), 0.4, 1e-12);
}

}  // namespace
}  // namespace vitrine

#pragma once

#include "exhibits/sdf_morph/torus_mug_cpu.h"
#include "exhibits/sdf_morph/torus_mug_cpu32.h"
#include "tests/stability/fields.h"

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace vitrine::test {

/// Property that the library documents for a field.
enum class Claim {
    exact,         ///< Euclidean distance; 1-Lipschitz.
    exactOutside,  ///< Exact where it is positive.
    bound,         ///< At most the distance to the surface; 1-Lipschitz.
    steep,         ///< Changes faster than the distance: by up to `slope`.
};

/// Solid or operator with sizes; `Number` is double or float.
template <typename Number> struct LibraryField {
    using Point = glm::vec<3, Number>;
    std::string name;
    Claim claim;
    std::function<Number(const Point&)> field;
    double slope = 1;  ///< Largest change per meter.
};

/// Source of sizes for a list of fields: the given ones, or random ones. Equal for both precisions, because every value
/// is one of float32.
class Sizes {
public:
    Sizes() = default;
    explicit Sizes(std::uint64_t seed) : random_(seed), fixed_(false) {}

    /// Returns the given size, or a random one from 0 to twice as much; in one of eight cases 0.
    double size(double written)
    {
        if (fixed_) return rounded(written);
        const double share = random_.number(0, 2);
        return random_.number(0, 1) < 0.125 ? 0 : rounded(written * share);
    }
    /// Returns the given value, or a random one in [low, high]; in one of eight cases an end.
    double between(double low, double high, double written)
    {
        if (fixed_) return rounded(written);
        const double any = random_.number(low, high);
        const double choice = random_.number(0, 1);
        return rounded(choice < 0.0625 ? low : choice < 0.125 ? high : any);
    }

private:
    static double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

    Random random_{0};
    bool fixed_ = true;
};

// Functions of both precisions have equal names and differ in their argument types.
using namespace glsl;    // NOLINT
using namespace glsl32;  // NOLINT

/// Returns all solids of shaders/lib/sdf.glsl. Profiles are infinite prisms.
template <typename Number> std::vector<LibraryField<Number>> librarySolids(Sizes sizes = {})
{
    using V3 = glm::vec<3, Number>;
    using V2 = glm::vec<2, Number>;
    const auto n = [&](double x) { return static_cast<Number>(sizes.size(x)); };
    const auto v = [&](double x, double y, double z) {
        const Number a = n(x), b = n(y), c = n(z);
        return V3(a, b, c);
    };
    const auto angle = [&](double x) { return static_cast<Number>(sizes.between(0, 3.1415927, x)); };
    const auto point = [&](double x, double y, double z) {
        const auto one = [&](double w) { return static_cast<Number>(sizes.between(-0.8, 0.8, w)); };
        const Number a = one(x), b = one(y), c = one(z);
        return V3(a, b, c);
    };
    std::vector<LibraryField<Number>> list;
    const auto add = [&](const char* name, Claim claim, auto field, double slope = 1) {
        list.push_back({name, claim, field, slope});
    };

    const Number r = n(0.7), rounding = n(0.1), thickness = n(0.12), tube = n(0.2), thin = n(0.15);
    const Number a = n(0.4), b = n(0.5), c = n(0.3), height = n(0.7), below = n(0.05);
    const V3 box = v(0.5, 0.3, 0.8), frame = v(0.6, 0.5, 0.8);
    const V2 rectangle(b, c);
    add("sphere", Claim::exact, [=](const V3& p) { return sdfSphere(p, r); });
    const V3 up = V3(Number(2), Number(6), Number(-3)) / Number(7);  // Unit vector at both precisions.
    add("plane", Claim::exact, [=](const V3& p) { return sdfPlane(p, up, c); });
    add("boxCorner", Claim::exact, [](const V3& p) { return sdfBoxCorner(p); });
    add("box", Claim::exact, [=](const V3& p) { return sdfBox(p, box); });
    add("roundBox", Claim::exact, [=](const V3& p) { return sdfRoundBox(p, box, rounding); });
    add("boxFrame", Claim::exactOutside, [=](const V3& p) { return sdfBoxFrame(p, frame, thickness); });
    add("torus", Claim::exact, [=](const V3& p) { return sdfTorus(p, r, tube); });
    const Number narrow = angle(0.7), wide = angle(2.45);
    add("cappedTorus, narrow", Claim::exact, [=](const V3& p) { return sdfCappedTorus(p, narrow, r, thin); });
    add("cappedTorus, wide", Claim::exact, [=](const V3& p) { return sdfCappedTorus(p, wide, r, thin); });
    add("cappedTorus, closed", Claim::exact,
        [=](const V3& p) { return sdfCappedTorus(p, Number(3.14159265358979), r, thin); });
    add("link", Claim::exactOutside, [=](const V3& p) { return sdfLink(p, c, a, thickness); });
    add("infiniteCylinder", Claim::exact, [=](const V3& p) { return sdfInfiniteCylinder(p, a); });
    add("cylinder", Claim::exact, [=](const V3& p) { return sdfCylinder(p, b, a); });
    add("roundCylinder", Claim::exact, [=](const V3& p) { return sdfRoundCylinder(p, b, a, rounding); });
    const V3 from = point(-0.4, 0.1, 0), to = point(0.5, 0.3, -0.4), third = point(0, 0.5, -0.6);
    add("capsule", Claim::exact, [=](const V3& p) { return sdfCapsule(p, from, to, tube); });
    add("cappedCone, wide below", Claim::exact, [=](const V3& p) { return sdfCappedCone(p, b, r, tube); });
    add("cappedCone, wide above", Claim::exact, [=](const V3& p) { return sdfCappedCone(p, b, tube, r); });
    add("cone", Claim::exact, [=](const V3& p) { return sdfCone(p, a, r); });
    add("roundCone", Claim::exact, [=](const V3& p) { return sdfRoundCone(p, b, tube, height); });
    const V3 flat = V3(Number(0.7F), Number(0.1F), Number(0.5F)), radii = v(0.7, 0.1, 0.5);
    // Only outside, where it may be used. Three million points had a slope of at most 14.6.
    add(
        "ellipsoid, outside", Claim::steep, [=](const V3& p) { return std::max(sdfEllipsoid(p, flat), Number(0)); },
        15);
    add("ellipsoidBound", Claim::bound, [=](const V3& p) { return sdfEllipsoidBound(p, radii); });
    add("octahedron", Claim::exact, [=](const V3& p) { return sdfOctahedron(p, r); });
    add("hexPrism", Claim::exact, [=](const V3& p) { return sdfHexPrism(p, a, c); });
    add("triangularPrism", Claim::exact, [=](const V3& p) { return sdfTriangularPrism(p, a, c); });
    add("solidAngle, narrow", Claim::exact, [=](const V3& p) { return sdfSolidAngle(p, Number(0.7F), r); });
    add("solidAngle, wide", Claim::exactOutside, [=](const V3& p) { return sdfSolidAngle(p, Number(2.27F), r); });
    add("solidAngle, any", Claim::bound, [=](const V3& p) { return sdfSolidAngle(p, wide, r); });
    const Number cut = static_cast<Number>(sizes.between(-1, 1, 0.3));
    add("cutSphere, above", Claim::exact, [=](const V3& p) { return sdfCutSphere(p, r, cut); });
    add("cutSphere, below", Claim::exact, [=](const V3& p) { return sdfCutSphere(p, r, -cut); });
    add("triangle", Claim::exact, [=](const V3& p) { return sdfTriangle(p, from, to, third); });
    add("rectangle", Claim::exact, [=](const V3& p) { return sdfRectangle(V2(p.x, p.y), rectangle); });
    add("roundRectangle", Claim::exact,
        [=](const V3& p) { return sdfRoundRectangle(V2(p.x, p.y), rectangle, rounding, below); });
    add("triangleProfile", Claim::exact, [=](const V3& p) { return sdfTriangleProfile(V2(p.x, p.y), c); });
    const Number melt = static_cast<Number>(sizes.between(0, 1, 0.5));
    const auto melting = [=](auto torusMugShape) {
        return torusMugShape({melt, Number(0.35F), Number(0.12F), Number(0.28F), Number(0.66F), Number(0.045F),
                              Number(0.155F), Number(0.09F), Number(0.06F)});
    };
    if constexpr (std::is_same_v<Number, double>) {
        const auto shape = melting(glsl::torusMugShape);
        add("cupWithHandle", Claim::bound, [=](const V3& p) { return glsl::sdfCupWithHandle(p, shape); });
    } else {
        const auto shape = melting(glsl32::torusMugShape);
        add("cupWithHandle", Claim::bound, [=](const V3& p) { return glsl32::sdfCupWithHandle(p, shape); });
    }
    return list;
}

/// Returns all operators of shaders/lib/sdf_operators.glsl, on an overlapping box and ball.
template <typename Number> std::vector<LibraryField<Number>> libraryOperators(Sizes sizes = {})
{
    using V3 = glm::vec<3, Number>;
    using V2 = glm::vec<2, Number>;
    const auto n = [&](double x) { return static_cast<Number>(sizes.size(x)); };
    std::vector<LibraryField<Number>> list;
    const auto add = [&](const char* name, Claim claim, auto field, double slope = 1) {
        list.push_back({name, claim, field, slope});
    };
    const Number bx = n(0.5), by = n(0.3), bz = n(0.4), radius = n(0.5), k = n(0.3), narrow = n(0.1), gap = n(0.01);
    const V3 box(bx, by, bz);
    const auto a = [=](const V3& p) { return sdfBox(p - V3(Number(0.25), 0, 0), box); };
    const auto b = [=](const V3& p) { return sdfSphere(p + V3(Number(0.25), Number(-0.125), Number(0.125)), radius); };
    add("subtraction", Claim::bound, [=](const V3& p) { return sdfSubtraction(a(p), b(p)); });
    add("cleanSubtraction", Claim::bound, [=](const V3& p) { return sdfCleanSubtraction(a(p), b(p), gap); });
    add("smoothUnion", Claim::bound, [=](const V3& p) { return sdfSmoothUnion(a(p), b(p), k); });
    add("smoothUnionCubic", Claim::bound, [=](const V3& p) { return sdfSmoothUnionCubic(a(p), b(p), k); });
    add("smoothUnionExponential", Claim::bound,
        [=](const V3& p) { return sdfSmoothUnionExponential(a(p), b(p), narrow); });
    add("smoothSubtraction", Claim::bound, [=](const V3& p) { return sdfSmoothSubtraction(a(p), b(p), k); });
    const Number inside = static_cast<Number>(sizes.between(0, 1, 0.3));
    const Number beyond = static_cast<Number>(sizes.between(1, 4, 1.25));
    const Number before = static_cast<Number>(sizes.between(-4, 0, -0.5));
    add("mix, inside", Claim::bound, [=](const V3& p) { return sdfMix(a(p), b(p), inside); });
    add("mix, beyond 1", Claim::bound, [=](const V3& p) { return sdfMix(a(p), b(p), beyond); });
    add("mix, before 0", Claim::bound, [=](const V3& p) { return sdfMix(a(p), b(p), before); });
    add("onion", Claim::bound, [=](const V3& p) { return sdfOnion(a(p), narrow); });
    add("round", Claim::exactOutside, [=](const V3& p) { return sdfRound(a(p), narrow); });
    const Number scale = static_cast<Number>(sizes.between(0.25, 4, 1.7));
    const Number sx = static_cast<Number>(sizes.between(0.25, 4, 1.5)),
                 sy = static_cast<Number>(sizes.between(0.25, 4, 0.5));
    const V3 uneven(sx, sy, Number(1));
    add("scaled", Claim::exact, [=](const V3& p) { return sdfScaled(b(p / scale), scale); });
    add("scaled unevenly", Claim::bound, [=](const V3& p) {
        return sdfScaled(b(p / uneven), std::min({sx, sy, Number(1)}));
    });
    add("extrude", Claim::exact,
        [=](const V3& p) { return sdfExtrude(sdfRectangle(V2(p.x, p.y), V2(bx, by)), p.z, bz); });
    const V3 apart(by, narrow, 0);
    add("elongate", Claim::exactOutside, [=](const V3& p) { return sdfSphere(sdfElongate(p, apart), radius); });
    return list;
}

}  // namespace vitrine::test

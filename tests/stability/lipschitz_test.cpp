// All fields that are documented as 1-Lipschitz or exact, at random points, at float64 and float32. Fields that are
// documented as steeper are included, to show that the test would detect a violation.

#include "tests/stability/library_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using glm::dvec3;
using glm::vec3;
using namespace test;
using LibraryShape = LibraryField<double>;

std::vector<LibraryShape> everything(const Sizes& sizes = {})
{
    std::vector<LibraryShape> all = librarySolids<double>(sizes);
    for (LibraryShape& field : libraryOperators<double>(sizes)) all.push_back(std::move(field));
    return all;
}

std::vector<LibraryField<float>> everything32(const Sizes& sizes = {})
{
    std::vector<LibraryField<float>> all = librarySolids<float>(sizes);
    for (LibraryField<float>& field : libraryOperators<float>(sizes)) all.push_back(std::move(field));
    return all;
}

/// Returns the largest |f(p) - f(q)| / |p - q| over near and distant pairs.
double steepest(const std::function<double(const dvec3&)>& field, int pairs, std::uint64_t seed)
{
    test::Random random(seed);
    double slope = 0;
    for (int i = 0; i < pairs; ++i) {
        const dvec3 p = random.point(1.5);
        const double apart = std::pow(10.0, random.number(-4, 0.3));
        const dvec3 q = p + random.direction() * apart;
        slope = std::max(slope, std::abs(field(p) - field(q)) / glm::length(p - q));
    }
    return slope;
}

dvec3 gradient(const LibraryShape& named, const dvec3& p)
{
    constexpr double h = 1e-6;
    const auto& field = named.field;
    return dvec3(field(p + dvec3(h, 0, 0)) - field(p - dvec3(h, 0, 0)),
                 field(p + dvec3(0, h, 0)) - field(p - dvec3(0, h, 0)),
                 field(p + dvec3(0, 0, h)) - field(p - dvec3(0, 0, h))) /
           (2 * h);
}

TEST(Lipschitz, EverySolidAndOperatorIsAsSteepAsItSaysAndNotSteeper)
{
    for (const LibraryShape& named : everything()) {
        SCOPED_TRACE(named.name);
        const double slope = steepest(named.field, 60000, 7);
        EXPECT_LE(slope, named.slope * (1 + 1e-9));
        if (named.claim == Claim::steep) {
            EXPECT_GT(slope, 1.2) << "the fuzz no longer catches a field that is too steep";
        }
    }
}

/// Naive forms that the library corrects: each has the slope computed beside it.
TEST(Lipschitz, TheNaiveFormsAreCaught)
{
    const auto a = [](const dvec3& p) { return glsl::sdfBox(p - dvec3(0.2, 0, 0), dvec3(0.5, 0.3, 0.4)); };
    const auto b = [](const dvec3& p) { return glsl::sdfSphere(p + dvec3(0.2, -0.1, 0.1), 0.5); };
    const dvec3 scale(1.5, 0.5, 1);
    const LibraryShape naive[] = {
        {"mix at 1.25, not divided", Claim::steep, [=](const dvec3& p) { return a(p) * -0.25 + b(p) * 1.25; }, 1.5},
        {"scaled unevenly, not corrected", Claim::steep, [=](const dvec3& p) { return b(p / scale); }, 2},
        {"blended by a product", Claim::steep, [=](const dvec3& p) { return a(p) * b(p); }, 8},
    };
    for (const LibraryShape& named : naive) {
        const double slope = steepest(named.field, 60000, 7);
        EXPECT_GT(slope, 1.2) << named.name;
        EXPECT_LE(slope, named.slope + 1e-9) << named.name;
    }
}

TEST(Lipschitz, ExactFieldsLeadToTheSurfaceInOneStep)
{
    for (const LibraryShape& named : everything()) {
        if (named.claim != Claim::exact && named.claim != Claim::exactOutside) continue;
        SCOPED_TRACE(named.name);
        // A step by the distance against the gradient ends on the surface. Exceptions are points without a unique
        // nearest point, which have measure zero plus the width of the difference.
        test::Random random(11);
        int tried = 0;
        int wrong = 0;
        for (int i = 0; i < 20000; ++i) {
            const dvec3 p = random.point(1.5);
            const double d = named.field(p);
            if (named.claim == Claim::exactOutside && d <= 0) continue;
            ++tried;
            const dvec3 surface = p - gradient(named, p) * d;
            wrong += !(std::abs(named.field(surface)) < 1e-5);
        }
        EXPECT_GT(tried, 1000);
        EXPECT_LE(wrong, tried / 1000);
    }
}

TEST(Lipschitz, HoldsForEverySizeDownToNothing)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const Sizes sizes(seed);
        for (const LibraryShape& named : everything(sizes))
            EXPECT_LE(steepest(named.field, 800, seed), named.slope * (1 + 1e-9))
                << named.name << ", sizes of seed " << seed;
    }
}

/// At float32 a field may differ from float64 by the rounding of its steps, a dozen half units in the last place of 4
/// (the largest coordinate). Its slope may exceed 1 by no more.
TEST(Lipschitz, AtFloat32EveryFieldIsFiniteNearFloat64AndNoSteeper)
{
    constexpr double rounding = 12 * 0x1p-24 * 4;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const Sizes sizes(seed);
        const auto exact = everything(sizes);
        const auto rounded = everything32(sizes);
        ASSERT_EQ(exact.size(), rounded.size());
        for (std::size_t i = 0; i < exact.size(); ++i) {
            SCOPED_TRACE(exact[i].name + ", sizes of seed " + std::to_string(seed));
            ASSERT_EQ(exact[i].name, rounded[i].name);
            test::Random random(seed);
            for (int k = 0; k < 400; ++k) {
                const vec3 p(random.point(1.5));
                const vec3 q = p + vec3(random.direction() * std::pow(10.0, random.number(-4, 0.3)));
                const float atP = rounded[i].field(p);
                const float atQ = rounded[i].field(q);
                ASSERT_TRUE(std::isfinite(atP));
                ASSERT_NEAR(static_cast<double>(atP), exact[i].field(dvec3(p)), exact[i].slope * rounding);
                const double apart = glm::length(dvec3(p) - dvec3(q));
                ASSERT_LE(std::abs(static_cast<double>(atP) - static_cast<double>(atQ)),
                          exact[i].slope * (apart + 2 * rounding));
            }
        }
    }
}

TEST(Lipschitz, SubtractingMoreThanThereIsLeavesABoundAndNoSurface)
{
    const auto solid = [](const dvec3& p) { return glsl::sdfBox(p, dvec3(0.5)); };
    const auto larger = [](const dvec3& p) { return glsl::sdfSphere(p, 3); };
    // The naive form considers only the cutter inside of it, so it jumps at the cutter's face.
    const auto naive = [&](const dvec3& p) { return larger(p) < 0 ? -larger(p) : solid(p); };
    const auto ours = [&](const dvec3& p) { return glsl::sdfSubtraction(solid(p), larger(p)); };
    double naiveSlope = 0;
    double slope = 0;
    test::Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const dvec3 p = random.point(4);
        const dvec3 q = p + random.direction() * random.number(1e-4, 0.5);
        naiveSlope = std::max(naiveSlope, std::abs(naive(p) - naive(q)) / glm::length(p - q));
        slope = std::max(slope, std::abs(ours(p) - ours(q)) / glm::length(p - q));
        ASSERT_GT(ours(p), 0) << "something is left";
    }
    EXPECT_GT(naiveSlope, 10);
    EXPECT_LE(slope, 1 + 1e-9);
    glsl::Tracer tracer{ours};
    EXPECT_FALSE(tracer.sphereTrace(dvec3(0, 0, 6), dvec3(0, 0, -1), tracer.marchSettings(0, 20, 1e-3)).hit);
}

/// Ends of each solid's extent, computed by hand: |gradient| = 1 alone would not detect a wrong size.
TEST(Lipschitz, SolidsHaveTheSizesTheyAreGiven)
{
    using namespace glsl;
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

std::string textOf(const fs::path& path)
{
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Lipschitz, NoFieldOfTheLibraryIsLeftOut)
{
    const fs::path root(VITRINE_SOURCE_DIR);
    const std::string tried =
        textOf(root / "tests/stability/library_fields.h") + textOf(root / "tests/stability/torus_mug_test.cpp");
    std::set<std::string> missing;
    int found = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root / "shaders")) {
        if (entry.path().extension() != ".glsl") continue;
        const std::string text = textOf(entry.path());
        static const std::regex definition(R"((?:^|\n)(?:float|vec2|vec3)\s+(sdf\w+)\()");
        for (auto match = std::sregex_iterator(text.begin(), text.end(), definition); match != std::sregex_iterator();
             ++match) {
            ++found;
            if (tried.find((*match)[1].str() + '(') == std::string::npos) missing.insert((*match)[1]);
        }
    }
    EXPECT_GT(found, 40);
    EXPECT_EQ(missing, std::set<std::string>());
}

}  // namespace
}  // namespace vitrine

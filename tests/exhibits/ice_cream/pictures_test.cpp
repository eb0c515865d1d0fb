// Pictures of the ice cream compared with those of the reference, and with the reference's errors.

#include "tests/exhibits/ice_cream/every_solid.h"
#include "tests/exhibits/ice_cream/ice_cream_shot.h"
#include "tests/support/planned.h"

#include <cstdio>
#include <map>
#include <numbers>
#include <set>

namespace vitrine::ice_cream {
namespace {

using glm::dvec3;
using namespace test;

class IceCreamPicture : public test::GlTest {};

const IceCreamTable& t()
{
    return IceCreamShot::table();
}

void candiesOfTheReference(ParameterValues& values)
{
    const dvec3 inTheAir[]{{0.5, 1, 0.866}, {-1, 0.8, 0}, {0.5, 1.2, -0.866}};
    for (std::size_t i = 0; i < 3; ++i) {
        values.set(t().candies[7 + i].x, inTheAir[i].x);
        values.set(t().candies[7 + i].y, inTheAir[i].y);
        values.set(t().candies[7 + i].z, inTheAir[i].z);
    }
}

/// Removes all lighting, so that surfaces have flat colors.
void flat(ParameterValues& values)
{
    values.set(t().referenceSunStrength, 0.0);
    values.set(t().referenceAmbient, {dvec3(1)});
    values.set(t().ambientOcclusion, false);
    values.set(t().referenceFog, 0.0);
    values.set(t().ground, false);
}

/// Counts the pixels of each candy, which have colors of their own here, in a view from one angle of the reference's
/// orbit.
std::array<int, candyCount> candyPixels(double angle, bool placesOfTheReference)
{
    IceCreamShot shot;
    ParameterValues& values = shot.values();
    candiesOfTheReference(values);
    flat(values);
    if (placesOfTheReference) {
        values.set(t().candies[0].z, 16.0);
        values.set(t().candies[4].x, -0.06);
        values.set(t().candies[4].z, -0.11);
    }
    for (const CreamParameters& layer : t().layers) values.set(layer.color, {dvec3(0)});
    values.set(t().waferColor, {dvec3(0)});
    for (std::size_t i = 0; i < candyCount; ++i) {
        const double shade = (static_cast<double>(i) + 1) / candyCount;
        values.set(t().candies[i].color, {dvec3(shade, 1 - shade, 0.5)});
    }
    shot.from({3 * std::sin(angle), 1.5, 2 * std::cos(angle)}, {0, 0.5, 0}).size(784, 441);
    const Picture p = shot.take();
    std::array<int, candyCount> pixels{};
    p.each([&](int x, int y) {
        const dvec3 c = p.color(x, y);
        if (!p.hit(x, y) || !(c.r + c.g > 1e-6)) return;
        const double shade = c.r / (c.r + c.g);
        const int candy = static_cast<int>(std::lround(shade * candyCount)) - 1;
        if (candy >= 0 && candy < static_cast<int>(candyCount) && std::abs(shade * candyCount - candy - 1) < 0.02)
            ++pixels[static_cast<std::size_t>(candy)];
    });
    return pixels;
}

/// Returns the number of candies visible from the reference's orbit.
int candiesSeen(bool placesOfTheReference)
{
    std::array<int, candyCount> most{};
    for (int side = 0; side < 6; ++side) {
        const auto pixels = candyPixels(side * std::numbers::pi / 3, placesOfTheReference);
        for (std::size_t i = 0; i < candyCount; ++i) most[i] = std::max(most[i], pixels[i]);
    }
    int seen = 0;
    for (std::size_t i = 0; i < candyCount; ++i) {
        std::printf("candy %zu: %d pixels\n", i + 1, most[i]);
        seen += most[i] >= 20;
    }
    return seen;
}

TEST_F(IceCreamPicture, TenCandiesAreSeenFromTheWayAroundIt)
{
    EXPECT_EQ(candiesSeen(false), 10);
    EXPECT_EQ(candiesSeen(true), 8)
        << "the reference has the first one behind the camera and the fifth one in the cream";
}

TEST_F(IceCreamPicture, UndersidesAreDarkerThanTops)
{
    IceCreamShot shot;
    flat(shot.values());
    // Equal colors, so that only the normals make a difference.
    for (const CreamParameters& layer : t().layers) shot.values().set(layer.color, {dvec3(1)});
    for (const CandyParameters& candy : t().candies) shot.values().set(candy.color, {dvec3(1)});
    shot.values().set(t().waferColor, {dvec3(1)});
    shot.from({0, 0.6, 2.4}, {0, 0.6, 0});
    const Picture p = shot.take();
    double top = 0, largest = 0, inverted = 0;
    p.each([&](int x, int y) {
        if (p.hit(x, y)) top = std::max(top, p.luminance(x, y) / (0.5 + 0.5 * p.normal(x, y).y));
    });
    int under = 0;
    p.each([&](int x, int y) {
        if (!p.hit(x, y)) return;
        const double seen = p.luminance(x, y) / top, up = p.normal(x, y).y;
        under += up < -0.2;
        largest = std::max(largest, std::abs(seen - (0.5 + 0.5 * up)));
        inverted = std::max(inverted, std::abs(seen - (0.5 - 0.5 * up)));
    });
    EXPECT_GT(under, 50);
    EXPECT_LT(largest, 0.02);
    EXPECT_GT(inverted, 0.5) << "the reference, whose y points down, lights the undersides";
}

/// Returns the reference's shading formula for one pixel, from its normal.
dvec3 blinnPhong(const ParameterValues& values, const dvec3& n, const dvec3& toEye, const dvec3& color,
                 double roughness)
{
    const dvec3 l = values[t().referenceSun].value;
    const double diffuse = std::max(glm::dot(n, l), 0.0);
    const double shine =
        std::pow(std::max(glm::dot(n, glm::normalize(l + toEye)), 0.0), std::exp2(10 * (1 - roughness)));
    return (color + shine) * diffuse * values[t().referenceSunColor].value * values[t().referenceSunStrength];
}

TEST_F(IceCreamPicture, RoughnessIsTheReferencesExponent)
{
    for (const double roughness : {0.25, 0.65}) {
        IceCreamShot shot;
        ParameterValues& values = shot.values();
        values.set(t().show, IceCreamParts::upper);
        values.set(t().referenceAmbient, {dvec3(0)});
        values.set(t().shadowMethod, SdfShadow::none);
        values.set(t().referenceFog, 0.0);
        values.set(t().ground, false);
        values.set(t().creamRoughness, roughness);
        // View in which the highlight is visible.
        shot.from({-1.2, 1.9, 1.2}, {0, 1.15, 0}, 0.5);
        const Picture p = shot.take();
        double scale = 0;
        dvec3 most(0);
        std::vector<std::pair<double, double>> pairs;
        p.each([&](int x, int y) {
            if (!p.hit(x, y)) return;
            const dvec3 toEye = glm::normalize(p.view.eye - shot.foot() - shot.pointAt(p, x, y));
            const dvec3 expected =
                blinnPhong(values, p.normal(x, y), toEye, values[t().layers[1].color].value, roughness);
            pairs.emplace_back(p.color(x, y).g, expected.g);
            most = glm::max(most, expected);
            scale += p.color(x, y).g;
        });
        double sum = 0;
        for (const auto& [seen, expected] : pairs) sum += expected;
        scale /= sum;  // Exposure, which the reference does not have.
        double largest = 0;
        for (const auto& [seen, expected] : pairs) largest = std::max(largest, std::abs(seen / scale - expected));
        EXPECT_GT(pairs.size(), 500U);
        EXPECT_GT(most.g, 0.75) << "no highlight is in the picture";
        EXPECT_LT(largest, 0.02 * most.g) << roughness;
    }
}

/// Returns the brightness of a point of the ground with shadows relative to that without.
double shareOfSun(const glm::dvec2& at, SdfShadow method)
{
    IceCreamShot shot;
    shot.values().set(t().referenceAmbient, {dvec3(0)});
    shot.values().set(t().referenceFog, 0.0);
    // A low sun makes a long shadow.
    shot.values().set(t().referenceSun, {glm::normalize(dvec3(-1, 0.12, 0))});
    shot.from({at.x, 0.5, at.y + 0.001}, {at.x, 0, at.y}, 0.05).size(8, 8);
    shot.values().set(t().shadowMethod, method);
    const double with = shot.take().mean();
    shot.values().set(t().shadowMethod, SdfShadow::none);
    return with / shot.take().mean();
}

TEST_F(IceCreamPicture, ShadowsReachFartherThanFiveMeters)
{
    // The sun's rays fall by 0.12 meters per meter: the middle of the cream, at a height of 0.9, shades the ground at
    // 7.5.
    for (const SdfShadow method : {SdfShadow::classic, SdfShadow::improved, SdfShadow::signedDistance}) {
        EXPECT_LT(shareOfSun({7.5, 0}, method), 0.05) << static_cast<int>(method) << ": the reference looks 5 m far";
        EXPECT_LT(shareOfSun({2.5, 0}, method), 0.05) << static_cast<int>(method);
        EXPECT_GT(shareOfSun({7.5, 3}, method), 0.99) << static_cast<int>(method);
        EXPECT_GT(shareOfSun({14, 0}, method), 0.99) << static_cast<int>(method) << ": beyond its end";
    }
}

TEST_F(IceCreamPicture, NormalsAreThoseOfFloat64)
{
    IceCreamShot shot;
    shot.values().set(t().ground, false);
    // Close enough for pixels finer than the step.
    shot.from({0.3, 1.3, 2}, {0.02, 0.95, 0.1}, 0.12).size(320, 180);
    const EverySolid every(iceCreamShape(t(), shot.values(), 0));
    const auto worst = [&](double step) {
        shot.values().set(t().normalStep, step);
        const Picture p = shot.take();
        std::vector<double> degrees;
        p.each([&](int x, int y) {
            if (!p.hit(x, y)) return;
            const dvec3 at = shot.pointAt(p, x, y);
            dvec3 n;
            constexpr double h = 1e-6;
            for (int axis = 0; axis < 3; ++axis) {
                dvec3 along(0);
                along[axis] = h;
                n[axis] = every.level(at + along) - every.level(at - along);
            }
            n = glm::normalize(n);
            degrees.push_back(std::atan2(glm::length(glm::cross(n, p.normal(x, y))), glm::dot(n, p.normal(x, y))) *
                              180 / std::numbers::pi);
        });
        std::sort(degrees.begin(), degrees.end());
        std::printf("step %g: median %.4f, 99 %% %.4f degrees of %zu\n", step, degrees[degrees.size() / 2],
                    degrees[degrees.size() * 99 / 100], degrees.size());
        return degrees[degrees.size() * 99 / 100];
    };
    // Within a step of a crease both sides count. Such pixels are along every edge of the wafer and the candies.
    EXPECT_LT(worst(3e-4), 0.1);
}

TEST_F(IceCreamPicture, EachStageOfTheBuildUpIsAnotherPictureAndTheLastOneIsTheWhole)
{
    IceCreamShot shot;
    shot.from({0.4, 1.5, 2}, {0, 0.6, 0}).size(128, 96);
    shot.values().set(t().lighting, IceCreamLighting::reference);
    shot.request.samples = 4;
    const Picture finished = shot.take();
    Picture before = finished;
    for (int stage = 0; stage <= static_cast<int>(IceCreamStage::finished); ++stage) {
        shot.values().set(t().stage, static_cast<IceCreamStage>(stage));
        const Picture now = shot.take();
        EXPECT_GT(test::largestDifference(now.image, before.image), 1e-3) << stage;
        before = now;
    }
    EXPECT_EQ(test::largestDifference(before.image, finished.image), 0);
    // The automatic build-up ends with the same picture.
    shot.values().set(t().stage, IceCreamStage::finished);
    shot.values().set(t().buildUp, true);
    shot.values().set(t().stageTime, 1.0);
    shot.request.frame.time = 20.5;
    EXPECT_EQ(test::largestDifference(shot.take().image, finished.image), 0);
    shot.request.frame.time = 3.5;
    EXPECT_GT(test::largestDifference(shot.take().image, finished.image), 0.01);
}

TEST_F(IceCreamPicture, EdgesAreSmoothOnlyWhenFinished)
{
    IceCreamShot shot;
    flat(shot.values());
    shot.request.samples = 16;
    const auto partly = [&] {
        const Picture p = shot.take();
        int count = 0;
        p.each([&](int x, int y) { count += p.alpha(x, y) > 0.02 && p.alpha(x, y) < 0.98; });
        return count;
    };
    EXPECT_GT(partly(), 150);
    shot.values().set(t().stage, IceCreamStage::fog);
    EXPECT_EQ(partly(), 0);
}

TEST_F(IceCreamPicture, EachPartCanBeShownAloneAndHasAColorOfItsOwn)
{
    IceCreamShot shot;
    flat(shot.values());
    shot.values().set(t().colorBy, IceCreamColors::part);
    shot.values().set(t().sprinkles, 200);
    int whole = shot.take().hits();
    std::set<std::array<int, 2>> colors;
    for (int part = 1; part <= static_cast<int>(IceCreamParts::upper); ++part) {
        shot.values().set(t().show, static_cast<IceCreamParts>(part));
        const Picture p = shot.take();
        EXPECT_GT(p.hits(), 20) << part;
        EXPECT_LT(p.hits(), whole) << part;
        std::map<std::array<int, 2>, int> hues;
        p.each([&](int x, int y) {
            const dvec3 c = p.color(x, y);
            if (p.hit(x, y))
                ++hues[{static_cast<int>(std::lround(20 * c.r / (c.r + c.g + c.b))),
                        static_cast<int>(std::lround(20 * c.g / (c.r + c.g + c.b)))}];
        });
        EXPECT_EQ(hues.size(), 1U) << part << ": one part has one color";
        colors.insert(hues.begin()->first);
    }
    EXPECT_EQ(colors.size(), static_cast<std::size_t>(IceCreamParts::upper));
    for (const IceCreamParts part : {IceCreamParts::candies, IceCreamParts::sprinkles}) {
        shot.values().set(t().show, part);
        EXPECT_GT(shot.take().hits(), 20);
    }
}

TEST_F(IceCreamPicture, TheEmojiIsFramedAndLegibleAtEverySize)
{
    for (const int size : {16, 32, 64, 256, 1024}) {
        IceCreamShot shot;
        shot.values() = t().initial();
        shot.values().set(t().plinth, false);
        shot.request.frame.averageIn = AverageIn::display;
        shot.request.samples = size > 100 ? 1 : 16;
        shot.request.frame.channels.normal = false;
        shot.request.depth = false;
        shot.size(size, size);
        shot.request.frame.camera = {{-0.4, 0.05, 1.75}, {0, -0.14, -0.2}, 0.55};
        const Picture p = shot.take();
        glm::ivec2 low(size), high(0);
        std::map<std::string, int> seen;
        p.each([&](int x, int y) {
            if (p.alpha(x, y) < 0.5) return;
            low = glm::min(low, glm::ivec2(x, y));
            high = glm::max(high, glm::ivec2(x + 1, y + 1));
            const dvec3 c = p.color(x, y) / p.alpha(x, y);
            // Cream is nearly gray; the wafer has little blue.
            if (c.b > 0.7 * c.r && c.g > 0.85 * c.r) ++seen["cream"];
            if (c.b < 0.6 * c.r && c.g > 0.5 * c.r && c.g < 0.95 * c.r) ++seen["wafer"];
        });
        EXPECT_GT(low.x, 0) << size;
        EXPECT_GE(low.y, size / 32) << size;
        EXPECT_LE(high.y, size - size / 32) << size;
        EXPECT_GT(high.y - low.y, 0.8 * size) << size << ": it fills the picture";
        EXPECT_GT(seen["cream"], 0.1 * size * size) << size;
        EXPECT_GT(seen["wafer"], 0.05 * size * size) << size;
        EXPECT_EQ(p.alpha(0, 0), 0);
        EXPECT_EQ(p.alpha(size - 1, size - 1), 0);
    }
}

TEST_F(IceCreamPicture, AThousandSprinklesLieOnTheCream)
{
    IceCreamShot shot;
    flat(shot.values());
    shot.values().set(t().sprinkles, 1000);
    shot.values().set(t().show, IceCreamParts::sprinkles);
    shot.size(784, 441);
    const IceCreamShape shape = iceCreamShape(t(), t().initial(), 0);
    const EverySolid every(shape);
    const Picture p = shot.take();
    int off = 0;
    p.each([&](int x, int y) {
        if (p.hit(x, y)) off += every.level(shot.pointAt(p, x, y)) > 0.03;
    });
    EXPECT_GT(p.hits(), 300);
    EXPECT_LT(off, p.hits() / 50) << "they are .01 thick, and the level rises up to three times as fast as it may";
}

}  // namespace
}  // namespace vitrine::ice_cream

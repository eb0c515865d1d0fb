// Sky through the day, as the window shows it, and the world outside.
#include "exhibits/noise/noise_table.h"
#include "tests/support/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vitrine::hall {
namespace {

using noise::NoiseSun;
using noise::NoiseTable;

using namespace test;

class Hours : public test::GlTest {};

/// Returns a shot of the hall at an hour.
Shot hallAt(double hour)
{
    Shot shot;
    shot.inHall();
    shot.request.frame.averageIn = AverageIn::display;
    shot.request.frame.channels.normal = false;
    shot.see({0, 1.65, 10.5}, {0, 2.4, -12});
    shot.size(96, 54);
    shot.hall().set(hallTable().sunBy, SunBy::hour);
    shot.hall().set(hallTable().timeOfDay, hour);
    return shot;
}

/// Takes a picture through the panes only, from just in front of the window.
Picture outsideAt(double hour, glm::dvec3 towards)
{
    Shot shot = hallAt(hour);
    const glm::dvec3 eye{-0.3, 2.6, -12.3};
    shot.see(eye, eye + towards);
    shot.request.frame.camera.fovY = 0.2;
    shot.hall().set(hallTable().exposure, -4.0);  // At the hall's exposure the whole sky would be white.
    return shot.size(64, 36).take();
}

double redOverBlue(const Picture& p)
{
    double red = 0, blue = 0;
    p.each([&](int x, int y) {
        red += p.color(x, y).r;
        blue += p.color(x, y).b;
    });
    return red / blue;
}

using LongHours = Hours;

TEST_F(Hours, TheSkyReddensWhereTheSunSets)
{
    const glm::dvec3 low{0.25, 0.2, -1};
    EXPECT_GT(redOverBlue(outsideAt(17.9, low)), 1.3 * redOverBlue(outsideAt(12, low)));
    EXPECT_LT(redOverBlue(outsideAt(21, low)), 0.8) << "and is blue by night";
}

TEST_F(Hours, ThereIsAWorldOutsideTheWindow)
{
    const auto mean = [](const Picture& p) {
        double sum = 0;
        int count = 0;
        p.each([&](int x, int y) {
            sum += p.luminance(x, y);
            ++count;
        });
        return sum / count;
    };
    const double sky = mean(outsideAt(14, {0.1, 0.35, -1}));
    EXPECT_LT(mean(outsideAt(14, {0.5, 0.05, -1})), 0.6 * sky) << "trees are darker than the sky";
    EXPECT_LT(mean(outsideAt(14, {0.1, -0.2, -1})), 0.6 * sky) << "and so is the lawn";
}

/// Returns the mean luminance of the noise behind its frame at an hour.
double seaAt(double hour, NoiseSun sunBy, bool inHall = true)
{
    static const NoiseTable table;
    Shot shot("noise");
    if (inHall) shot.inHall();
    shot.request.frame.averageIn = AverageIn::display;
    shot.size(64, 40);
    shot.values().set(table.sunBy, sunBy);
    shot.hall().set(hallTable().sunBy, SunBy::hour);
    shot.hall().set(hallTable().timeOfDay, hour);
    const Picture p = shot.take();
    double sum = 0;
    for (int y = 10; y < 30; ++y)  // The frame is around it.
        for (int x = 20; x < 44; ++x) sum += p.luminance(x, y);
    return sum / (20 * 24);
}

TEST_F(Hours, OfTheHallAreThoseOfTheSeaBehindItsFrame)
{
    EXPECT_NEAR(seaAt(12, NoiseSun::ownByDay) / seaAt(12, NoiseSun::own), 1, 1e-6) << "by day its sun is its own";
    double last = seaAt(12, NoiseSun::ownByDay);
    for (const double hour : {18.3, 21.0}) {
        const double light = seaAt(hour, NoiseSun::ownByDay);
        EXPECT_LT(light, 0.95 * last) << hour;
        last = light;
    }
    EXPECT_LT(last, 0.3 * seaAt(12, NoiseSun::ownByDay));
    EXPECT_GT(last, 0.003) << "the moon shines on it";
    // Controls: light of its own does not set, and alone there is no hall.
    EXPECT_GT(seaAt(21, NoiseSun::own), 0.8 * seaAt(12, NoiseSun::own));
    EXPECT_EQ(seaAt(21, NoiseSun::ownByDay, false), seaAt(12, NoiseSun::ownByDay, false));
}

/// Returns the share of pixels of the hall at an hour with level 8 or less on an 8-bit display.
double blackAt(double hour, LampsLit lamps, Picture* taken = nullptr)
{
    Shot shot = hallAt(hour);
    shot.see({1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0});
    shot.hall().set(hallTable().lamps, lamps);
    const Picture p = shot.take();
    constexpr double eight = 8.5 / 255 / 12.92;
    int black = 0, all = 0;
    p.each([&](int x, int y) {
        black += p.luminance(x, y) < eight;
        ++all;
    });
    if (taken) *taken = p;
    return static_cast<double>(black) / all;
}

TEST_F(LongHours, TheLampsMakeANightToStandIn)
{
    Picture dusk, night;
    EXPECT_LT(blackAt(18.2, LampsLit::automatic, &dusk), 0.03);
    EXPECT_LT(blackAt(22, LampsLit::automatic, &night), 0.03);
    EXPECT_GT(blackAt(22, LampsLit::off), 0.5) << "which is dark without them";
    for (const Picture* p : {&dusk, &night}) {
        EXPECT_GT(p->mean(), 0.07);
        EXPECT_LT(p->mean(), 0.25);
        EXPECT_GT(redOverBlue(*p), 1.2) << "their light is warm";
    }
}

TEST_F(Hours, TheNightHasPoolsOfLight)
{
    const auto levelsOf = [](double vault, double spots) {
        Shot shot = hallAt(21);
        shot.see({1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0});
        shot.hall().set(hallTable().lampStrength, vault);
        shot.hall().set(hallTable().spotStrength, spots);
        shot.request.frame.averageIn = AverageIn::radiance;
        const Picture p = shot.take();
        std::vector<double> levels;
        p.each([&](int x, int y) { levels.push_back(p.luminance(x, y)); });
        std::sort(levels.begin(), levels.end());
        return levels;
    };
    // The ratio of bright to dark places, as in photographs of museums at night.
    const auto contrast = [](const std::vector<double>& levels) {
        return levels[levels.size() * 95 / 100] / levels[levels.size() * 5 / 100];
    };
    EXPECT_GE(contrast(levelsOf(1, 1)), 12);
    EXPECT_LT(contrast(levelsOf(5, 0)), 12) << "the lamps of the vault alone light it evenly";
}

TEST_F(LongHours, LampsWithoutStrengthAreNoLampsToTheBit)
{
    Shot shot = hallAt(20);
    shot.hall().set(hallTable().lampStrength, 0.0);
    shot.hall().set(hallTable().spotStrength, 0.0);
    const render::Image none = shot.take().image;
    shot.request.frame.runEverything = true;
    EXPECT_EQ(test::largestDifference(shot.take().image, none), 0) << "also where they are reckoned with all the same";
    shot.request.frame.runEverything = false;
    shot.hall().set(hallTable().lamps, LampsLit::off);
    EXPECT_EQ(test::largestDifference(shot.take().image, none), 0);
    shot.hall().resetParameter(hallTable().lamps.row);
    shot.hall().set(hallTable().lampStrength, 0.5);
    EXPECT_GT(test::largestDifference(shot.take().image, none), 0.01);
    shot.hall().set(hallTable().lampStrength, 0.0);
    shot.hall().set(hallTable().spotStrength, 0.1);
    EXPECT_GT(test::largestDifference(shot.take().image, none), 0.01);
}

}  // namespace
}  // namespace vitrine::hall

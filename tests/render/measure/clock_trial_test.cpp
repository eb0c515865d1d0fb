// Choice of the clock: false clocks are detected.

#include "render/measure/clock_trial.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace vitrine {
namespace {

using namespace render;

/// Returns samples of loads of 2, 4 and 8 ms, three times each. The functions give each clock's result for the true
/// time.
std::vector<ClockSample> trial(const std::function<double(double)>& query,
                               const std::function<double(double)>& wall = {},
                               const std::function<double(double)>& cpu = {})
{
    std::vector<ClockSample> samples;
    for (int run = 0; run < 3; ++run) {
        for (const double load : {1.0, 2.0, 4.0}) {
            const double truth = 0.002 * load;
            const double slower = run == 1 ? 1.5 : 1;  // Other work disturbs one run.
            samples.push_back(
                {load, query(truth), slower * (wall ? wall(truth) : truth), cpu ? cpu(truth) : 2 * truth});
        }
    }
    return samples;
}

double honest(double t)
{
    return t;
}

TEST(Clocks, AnHonestTimerQueryIsUsedOnHardware)
{
    const ClockChoice choice = chooseClock(trial(honest), false, 1e-6);
    EXPECT_EQ(choice.method, ClockMethod::query);
    EXPECT_TRUE(choice.trusted);
    EXPECT_EQ(choice.overheadSeconds, 1e-6);
}

TEST(Clocks, AQueryThatSeesOnlyTheLastTileIsCaught)
{
    // Like llvmpipe: a sixtieth, but in proportion.
    const ClockChoice choice = chooseClock(trial([](double t) { return t / 60; }), false, 0);
    EXPECT_EQ(choice.method, ClockMethod::wall);
    EXPECT_TRUE(choice.trusted);
    EXPECT_NE(choice.why.find("not used"), std::string::npos) << choice.why;
}

TEST(Clocks, AQueryThatDoesNotScaleIsCaught)
{
    EXPECT_EQ(chooseClock(trial([](double) { return 0.004; }), false, 0).method, ClockMethod::wall);
    EXPECT_EQ(chooseClock(trial([](double) { return 40e-9; }), false, 0).method, ClockMethod::wall);
    EXPECT_EQ(chooseClock(trial([](double) { return 0.0; }), false, 0).method, ClockMethod::wall);
}

TEST(Clocks, AQueryThatIsAQuarterOffIsCaughtAndATenthIsNot)
{
    EXPECT_EQ(chooseClock(trial([](double t) { return 1.25 * t; }), false, 0).method, ClockMethod::wall);
    EXPECT_EQ(chooseClock(trial([](double t) { return 0.75 * t; }), false, 0).method, ClockMethod::wall);
    EXPECT_EQ(chooseClock(trial([](double t) { return 1.1 * t; }), false, 0).method, ClockMethod::query);
}

TEST(Clocks, ASoftwareRendererIsTimedByTheProcessorWhateverItsQueriesSay)
{
    const ClockChoice choice = chooseClock(trial(honest), true, 0);
    EXPECT_EQ(choice.method, ClockMethod::cpu);
    EXPECT_TRUE(choice.trusted);
}

TEST(Clocks, AClockThatDoesNotGrowWithTheWorkIsNotTrusted)
{
    EXPECT_FALSE(chooseClock(trial(honest, {}, [](double) { return 0.005; }), true, 0).trusted);
    EXPECT_FALSE(chooseClock(trial([](double) { return 0.0; }, [](double) { return 0.016; }), false, 0).trusted)
        << "a wall clock that waits for the display";
}

TEST(Clocks, NothingIsTrustedWithoutATrial)
{
    EXPECT_FALSE(chooseClock({}, false, 0).trusted);
    EXPECT_FALSE(chooseClock({}, true, 0).trusted);
}

}  // namespace
}  // namespace vitrine

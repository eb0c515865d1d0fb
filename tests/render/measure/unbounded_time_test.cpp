// Time that strangers' shaders may take: other programs do not count.

#include "render/gl/unbounded_time.h"
#include "render/measure/clock.h"

#include <gtest/gtest.h>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace vitrine {
namespace {

using namespace render;

/// Clocks of two threads that draw and of one that sleeps, which a test moves on.
struct MovedClocks {
    double wall = 0;
    ThreadTimes threads{{7, {}}, {8, {}}, {9, {}}};

    /// Both threads are ready for `seconds`, and get this part of it on a processor.
    void pass(double seconds, double share = 1)
    {
        wall += seconds;
        for (const int thread : {7, 8}) {
            threads[thread].running += seconds * share;
            threads[thread].waiting += seconds * (1 - share);
        }
    }
    [[nodiscard]] gl::UnboundedTime::Clocks clocks()
    {
        return {[this] { return wall; }, [this] { return threads; }};
    }
};

/// Draws a frame of 60 x 60 pixels whose bands take `seconds` each, and returns whether its time was over.
bool drawFrame(gl::UnboundedTime& time, MovedClocks& clocks, double seconds, double share = 1)
{
    time.beginFrame();
    while (time.nextBand({60, 60})) clocks.pass(seconds, share);
    return time.isOver();
}

TEST(UnboundedTime, DoesNotCountTheWaitForAProcessor)
{
    MovedClocks clocks;
    gl::UnboundedTime time(true, clocks.clocks());
    time.setLimit(4);
    EXPECT_FALSE(drawFrame(time, clocks, 0.06));      // At most 60 bands of 60 ms: 3.6 s.
    EXPECT_FALSE(drawFrame(time, clocks, 0.6, 0.1));  // As much work, and ten times as long by the wall clock.
    EXPECT_TRUE(drawFrame(time, clocks, 0.6));        // The same time by the wall clock, and ten times the work.
    EXPECT_TRUE(time.isTooSlow(1));
}

TEST(UnboundedTime, CountsTheWallClockWithoutThreadTimes)
{
    MovedClocks clocks;
    gl::UnboundedTime time(true, {[&] { return clocks.wall; }, [] { return ThreadTimes(); }});
    time.setLimit(4);
    EXPECT_FALSE(drawFrame(time, clocks, 0.06));
    EXPECT_TRUE(drawFrame(time, clocks, 0.6, 0.1));
}

TEST(UnboundedTime, GivesASecondTryWhereTheWaitIsNotMeasured)
{
    MovedClocks clocks;
    gl::UnboundedTime time(false, clocks.clocks());
    time.setLimit(4);
    EXPECT_TRUE(drawFrame(time, clocks, 3));
    EXPECT_FALSE(time.isTooSlow(1));
    // A frame within the limit in between: the next one that takes too long is the first again.
    EXPECT_FALSE(drawFrame(time, clocks, 0.01));
    EXPECT_TRUE(drawFrame(time, clocks, 3));
    EXPECT_FALSE(time.isTooSlow(1));
    EXPECT_TRUE(drawFrame(time, clocks, 3));
    EXPECT_FALSE(time.isTooSlow(2));
    EXPECT_TRUE(time.isTooSlow(1));
}

TEST(UnboundedTime, NewAndEndedThreadsDoNotDistortIt)
{
    const ThreadTimes before{{1, {5, 1}}, {2, {100, 3}}}, after{{1, {6, 2}}, {3, {1, 1}}};
    EXPECT_DOUBLE_EQ(withoutWaiting(4, before, after), 2);
    EXPECT_DOUBLE_EQ(withoutWaiting(4, before, before), 4);
    EXPECT_DOUBLE_EQ(withoutWaiting(4, {}, {}), 4);
}

TEST(UnboundedTime, TheKernelTellsRunningFromWaiting)
{
    if (threadTimes().empty()) GTEST_SKIP() << "this kernel keeps no times of threads";
    // Two processes share one processor.
    cpu_set_t all, one;
    ::sched_getaffinity(0, sizeof all, &all);
    CPU_ZERO(&one);
    CPU_SET(::sched_getcpu(), &one);
    ::sched_setaffinity(0, sizeof one, &one);
    const pid_t other = ::fork();
    if (other == 0)
        for (volatile unsigned turns = 0;;) turns = turns + 1;
    const ThreadTimes before = threadTimes();
    const double begun = wallSeconds(), used = processCpuSeconds();
    while (processCpuSeconds() - used < 0.3) {
    }
    const double wall = wallSeconds() - begun;
    const double alone = withoutWaiting(wall, before, threadTimes());
    ::kill(other, SIGKILL);
    ::waitpid(other, nullptr, 0);
    ::sched_setaffinity(0, sizeof all, &all);
    EXPECT_GT(wall, 0.45);
    EXPECT_NEAR(alone, 0.3, 0.06);
}

}  // namespace
}  // namespace vitrine

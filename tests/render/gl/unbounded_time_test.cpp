// Limit of the time that shaders of visitors may take in a frame: what counts, on a processor and on a graphics card.

#include "render/gl/unbounded_time.h"
#include "render/measure/clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace vitrine::render::gl {
namespace {

constexpr glm::ivec2 size{64, 64};
constexpr double seconds = 0.05;

/// Returns a frame in which one band takes as long as `draw`.
template <typename Draw> UnboundedTime frameWith(bool software, const Draw& draw)
{
    UnboundedTime time(software);
    time.setLimit(seconds);
    time.beginFrame();
    EXPECT_TRUE(time.nextBand(size));
    draw();
    (void)time.nextBand(size);
    return time;
}

void wait()
{
    std::this_thread::sleep_for(std::chrono::duration<double>(2 * seconds));
}

TEST(UnboundedTime, LeavesOutWaitingWhereAProcessorDraws)
{
    EXPECT_FALSE(frameWith(true, wait).isOver()) << "other processes kept it waiting";
    EXPECT_TRUE(frameWith(true, [] {
                    const double begun = processCpuSeconds();
                    while (processCpuSeconds() < begun + 2 * seconds) {
                    }
                }).isOver());
}

TEST(UnboundedTime, CountsWaitingForAGraphicsCard)
{
    EXPECT_TRUE(frameWith(false, wait).isOver());
}

}  // namespace
}  // namespace vitrine::render::gl

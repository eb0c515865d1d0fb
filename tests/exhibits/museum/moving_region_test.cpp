// Moving objects in a static picture: the region that contains them, and abandoned frames.

#include "exhibits/framework/scene/glare.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <stdexcept>
#include <thread>

using namespace vitrine;

namespace {

class MovingRegion : public test::GlTest {
protected:
    glm::ivec2 size_{480, 288};
    Museum& museum_ = test::gallery().museum;
    SceneState sceneState_ = museum_.initialSceneState();

    /// Returns a request at the entrance, where the card rolls in the distance.
    FrameRequest at(double time)
    {
        FrameRequest request;
        request.camera = sceneState_.camera;
        request.raster.size = size_;
        request.time = time;
        return request;
    }
    /// Returns times at which something is animated, the first ones of different objects.
    std::vector<double> movingMoments()
    {
        std::vector<double> moments;
        for (double time = 0; time < 60 && moments.size() < 3; time += 0.25)
            if (test::nextChange(museum_, sceneState_, at(time)) <= 0 &&
                (moments.empty() || time > moments.back() + 0.6))
                moments.push_back(time);
        return moments;
    }
    int samples_ = 2;
    render::gl::ScreenPixels whole(render::gl::Renderer& renderer, FrameRequest request)
    {
        request.samples = samples_;
        for (request.sample = 0; request.sample < request.samples; ++request.sample)
            (void)renderer.draw(test::planned(museum_, sceneState_, request, renderer.persistentState()));
        return renderer.screenPixels("frame", size_, glm::ivec2(0), size_);
    }

    /// Gives a frame of other settings up before each `stride`-th pass, and expects the next frame of the first
    /// settings to have every bit that it has by a fresh renderer.
    void giveUpBeforeEvery(int stride);
};

/// The same at each third pass: a minute.
class LongMovingRegion : public MovingRegion {};

/// Returns whether a pixel is in the region; the picture is `height` pixels high, with the top row first.
bool inside(const PictureRegion& region, int x, int y, int height)
{
    const int fromBelow = height - 1 - y;
    return x >= region.offset.x && x < region.offset.x + region.size.x && fromBelow >= region.offset.y &&
           fromBelow < region.offset.y + region.size.y;
}

}  // namespace

TEST_F(LongMovingRegion, AtTheEntranceItHoldsAllThatMovesAndIsSmall)
{
    const auto renderer = test::gallery().renderer.sibling();
    const render::gl::ScreenPixels before = whole(*renderer, at(0));
    const auto region = museum_.movingRegion(museum_.prepare(sceneState_, at(0)), at(0));
    ASSERT_TRUE(region);
    EXPECT_GT(region->size.x * region->size.y, 0);
    EXPECT_LT(region->size.x * region->size.y, size_.x * size_.y / 16);
    EXPECT_EQ(region->offset % 2, glm::ivec2(0));
    int moved = 0;
    int elsewhere = 0;
    const std::vector<double> moments = movingMoments();
    ASSERT_EQ(moments.size(), 3U);
    for (const double time : moments) {
        EXPECT_EQ(museum_.movingRegion(museum_.prepare(sceneState_, at(time)), at(time)), region);
        const render::gl::ScreenPixels after = whole(*renderer, at(time));
        for (int y = 0; y < size_.y; ++y)
            for (int x = 0; x < size_.x; ++x) {
                const std::size_t pixel = static_cast<std::size_t>(y * size_.x + x) * 4;
                if (std::equal(before.rgba.begin() + static_cast<std::ptrdiff_t>(pixel),
                               before.rgba.begin() + static_cast<std::ptrdiff_t>(pixel) + 4,
                               after.rgba.begin() + static_cast<std::ptrdiff_t>(pixel)))
                    continue;
                ++(inside(*region, x, y, size_.y) ? moved : elsewhere);
            }
    }
    EXPECT_GT(moved, 20);
    EXPECT_EQ(elsewhere, 0);
}

TEST_F(LongMovingRegion, DrawnByItselfItIsThatPartOfTheWholePicture)
{
    const auto renderer = test::gallery().renderer.sibling();
    const auto region = museum_.movingRegion(museum_.prepare(sceneState_, at(0)), at(0));
    ASSERT_TRUE(region);
    const std::vector<double> moments = movingMoments();
    ASSERT_FALSE(moments.empty());
    const render::gl::ScreenPixels all = whole(*renderer, at(moments.front()));
    constexpr int apron = 8;
    FrameRequest request = at(moments.front());
    const glm::ivec2 low = glm::max(region->offset - apron, glm::ivec2(0));
    request.raster.offset = low;
    request.raster.tile = glm::min(region->offset + region->size + apron, size_) - low;
    request.samples = 2;
    request.halos = halosOf(renderer->read(glareSpreadImage), size_);
    const auto other = test::gallery().renderer.sibling();
    for (request.sample = 0; request.sample < 2; ++request.sample)
        (void)other->draw(test::planned(museum_, sceneState_, request, other->persistentState()));
    const render::gl::ScreenPixels part = other->screenPixels("frame", size_, low, request.raster.tile);
    int worst = 0;
    for (int y = 0; y < region->size.y; ++y)
        for (int x = 0; x < region->size.x; ++x)
            for (int c = 0; c < 3; ++c) {
                const glm::ivec2 from = region->offset + glm::ivec2(x, y);
                const auto a = all.rgba[static_cast<std::size_t>((size_.y - 1 - from.y) * size_.x + from.x) * 4 +
                                        static_cast<std::size_t>(c)];
                const glm::ivec2 at = from - low;
                const auto b = part.rgba[static_cast<std::size_t>((part.height - 1 - at.y) * part.width + at.x) * 4 +
                                         static_cast<std::size_t>(c)];
                worst = std::max(worst, std::abs(a - b));
            }
    EXPECT_LE(worst, 1);
}

void MovingRegion::giveUpBeforeEvery(int stride)
{
    samples_ = 1;
    size_ = {160, 96};
    SceneState other = sceneState_;
    const auto fur = museum_.find("fur").value();
    other.values[fur].setParameter(*other.values[fur].table().find("ballLength"), 0.1);
    other.hall().setParameter(*other.hall().table().find("shadowMapSize"), 512.0);
    const SceneState first = sceneState_;
    const auto fresh = test::gallery().renderer.sibling();
    const render::gl::ScreenPixels wanted = whole(*fresh, at(0));
    const auto renderer = test::gallery().renderer.sibling();
    (void)whole(*renderer, at(0));
    int passes = 0;
    bool finished = false;
    for (int most = 0; !finished; most += stride) {
        int asked = 0;
        renderer->abandonWhen([&] { return asked++ == most; });
        sceneState_ = other;
        try {
            (void)renderer->draw(test::planned(museum_, sceneState_, at(1.3), renderer->persistentState()));
            finished = true;
        } catch (const render::gl::Abandoned&) {
            ++passes;
        }
        renderer->abandonWhen({});
        sceneState_ = first;
        const render::gl::ScreenPixels drawn = whole(*renderer, at(0));
        ASSERT_EQ(drawn.rgba, wanted.rgba) << "given up before pass " << most;
    }
    EXPECT_GE(passes, 5);
}

TEST_F(MovingRegion, AFrameGivenUpAnywhereLeavesTheNextOneAsItWouldHaveBeen)
{
    giveUpBeforeEvery(11);
}

TEST_F(LongMovingRegion, AFrameGivenUpAnywhereLeavesTheNextOneAsItWouldHaveBeen)
{
    giveUpBeforeEvery(3);
}

TEST_F(MovingRegion, ARendererDrawsOnItsOwnThreadOnly)
{
    const auto renderer = test::gallery().renderer.sibling();
    const render::FramePlan plan = test::planned(museum_, sceneState_, at(0));
    bool refused = false;
    std::thread([&] {
        try {
            (void)renderer->draw(plan);
        } catch (const std::logic_error&) {
            refused = true;
        }
    }).join();
    EXPECT_TRUE(refused);
}

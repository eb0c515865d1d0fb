// Pictures with shifted lenses, and the views of a print.

#include "exhibits/printing/view_maker.h"
#include "tests/support/gallery.h"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using namespace test;

class ViewsTest : public test::GlTest {};

TEST_F(ViewsTest, AShiftedLensSeesItsPartOfAWiderPicture)
{
    Shot wide;
    wide.size(96, 48);
    wide.request.frame.transparent = false;
    const Picture all = wide.take();
    // The same pixels from the 16th on: a multiple of 8, so that blocks of the cone pre-pass are equal.
    Shot part = wide;
    part.size(48, 48);
    part.request.frame.camera.lensShift.x = (16 + 24 - 48) * 2 * std::tan(wide.request.frame.camera.fovY / 2) / 48;
    const Picture seen = part.take();
    int far = 0;
    seen.each([&](int x, int y) {
        const glm::dvec3 there = all.color(x + 16, y);
        far += !(glm::length(seen.color(x, y) - there) <= 0.01 * (0.1 + glm::length(there)));
        if (seen.hit(x, y) && all.hit(x + 16, y)) {
            // A ray may stop half a pixel before the surface, which is this part of its length.
            EXPECT_NEAR(seen.depth(x, y) / all.depth(x + 16, y), 1, 0.01) << x << ',' << y;
        }
    });
    // Rays are rounded to float, so pixels on outlines may differ.
    EXPECT_LE(far, 48 * 48 / 200);
    EXPECT_GT(test::colorDifference(seen, Shot(wide).size(48, 48).take()),
              0.01);  // Control: without the shift the picture differs.
}

TEST_F(ViewsTest, TilesOfAShiftedLensJoinToTheBit)
{
    Shot shot;
    shot.size(61, 45);
    shot.request.frame.transparent = false;
    shot.request.frame.camera.lensShift = {0.11, -0.07};
    shot.request.samples = 2;
    const Picture whole = shot.take();
    shot.request.largestTile = 24;
    EXPECT_EQ(test::largestDifference(shot.take().image, whole.image), 0);
}

TEST_F(ViewsTest, EveryViewIsThePictureOfItsShotAndComesInOrder)
{
    Shot shot;
    shot.size(30, 20);
    printing::PrintSettings s;
    s.sheet = printing::derivedSheet("test", 40, 30);
    s.views = 3;
    const printing::ViewShot base{shot.sceneState, shot.request};
    const printing::ViewRig rig(printing::PrintLayout(s), shot.request.frame.camera, {30, 20}, {0.5, 0});
    std::vector<printing::ViewShot> shots = printing::shotsOf(rig, base);
    printing::turn(shots, 0.7);
    std::vector<render::Image> views;
    printing::ViewMaker maker(gallery().museum, gallery().renderer, shots, [&](int k, const render::Image& image) {
        EXPECT_EQ(static_cast<std::size_t>(k), views.size());
        views.push_back(image);
    });
    double last = 0;
    while (maker.step()) {
        EXPECT_GT(maker.progress(), last);
        last = maker.progress();
    }
    EXPECT_EQ(last, 1);
    EXPECT_FALSE(maker.step());
    ASSERT_EQ(views.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        PictureMaker alone(gallery().museum, gallery().renderer, shots[k].sceneState, shots[k].request);
        while (alone.step()) {
        }
        EXPECT_EQ(test::largestDifference(views[k], alone.picture()), 0) << k;
    }
    EXPECT_GT(test::largestDifference(views[0], views[2]), 0.01);
}

TEST_F(ViewsTest, MeasuresHowFarTheSceneReaches)
{
    Shot shot;
    shot.size(60, 40);
    const printing::DepthRange alone =
        printing::measuredDepth(gallery().museum, gallery().renderer, {shot.sceneState, shot.request});
    const Picture picture = shot.take();
    double nearest = 1e9;
    picture.each([&](int x, int y) { nearest = std::min(nearest, picture.depth(x, y)); });
    EXPECT_NEAR(alone.nearest, nearest, 0.05);
    EXPECT_TRUE(std::isinf(alone.farthest));  // Nothing is behind it.
}

}  // namespace
}  // namespace vitrine

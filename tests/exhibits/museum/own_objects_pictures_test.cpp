// Pictures of the visitor's own objects: each at its place, with the rest of the picture unchanged.

#include "render/files/assets.h"
#include "tests/support/gallery.h"

#include <algorithm>

namespace vitrine {
namespace {

using namespace test;

class OwnObjectsPictures : public test::GlTest {};

/// Returns a shot of the hall from its entrance without indirect light, so that changes stay local.
Shot plainHall()
{
    Shot shot;
    shot.inHall().size(192, 108);
    shot.request.frame.camera = gallery().museum.initialSceneState().camera;
    shot.request.frame.subject.reset();
    shot.request.frame.time = 0;
    shot.hall().set(hallTable().sunShadows, false);
    shot.hall().set(hallTable().reflectionProbe, false);
    shot.hall().set(hallTable().contactShadows, false);
    return shot;
}

using LongOwnObjectsPictures = OwnObjectsPictures;

TEST_F(LongOwnObjectsPictures, EachStandsAtItsPlaceAndTakingOneAwayChangesItsPixelsAlone)
{
    Shot shot = plainHall();
    const Picture none = shot.take();
    for (const hall::OwnObjectParameters& rows : hallTable().objects) {
        shot.hall().set(rows.model, render::asset("models/teddy.glb").string());
        shot.hall().set(rows.modelSize, 1.2);
    }
    const Picture all = shot.take();
    const auto prepared = gallery().museum.prepare(shot.sceneState, shot.request.frame);
    const std::vector<OwnObjectShown> objects = gallery().museum.surroundings().ownObjects(prepared);
    ASSERT_EQ(objects.size(), hall::mostOwnObjects);
    for (const OwnObjectShown& one : objects) {
        SCOPED_TRACE(one.which);
        const hall::OwnObjectParameters& rows = hallTable().objects[one.which];
        Shot without = shot;
        without.hall().set(rows.model, std::string());
        const Picture picture = without.take();
        // Bounds of the object and of the plinth below it.
        render::Box box = one.box;
        box.low -= glm::dvec3(0.15, one.box.low.y, 0.15);
        box.high += 0.15;
        int changed = 0, inBox = 0;
        picture.each([&](int x, int y) {
            if (all.color(x, y) == picture.color(x, y)) return;
            ++changed;
            const glm::dvec2 ndc((x + 0.5) / picture.width() * 2 - 1, 1 - (y + 0.5) / picture.height() * 2);
            const render::Ray ray{picture.view.eye, picture.view.direction(ndc)};
            inBox += std::isfinite(render::firstHit(ray, box));
        });
        EXPECT_GT(changed, 8);
        EXPECT_EQ(inBox, changed);
    }
    // Without objects, the hall is exactly as before.
    for (const hall::OwnObjectParameters& rows : hallTable().objects) shot.hall().set(rows.model, std::string());
    EXPECT_EQ(test::largestDifference(none.image, shot.take().image), 0);
}

}  // namespace
}  // namespace vitrine

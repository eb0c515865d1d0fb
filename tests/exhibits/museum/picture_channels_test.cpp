// Channels of a picture besides its color.

#include "tests/support/gallery.h"
#include "tests/support/tables.h"

namespace vitrine {
namespace {

using namespace test;

class PictureChannels : public test::GlTest {};

/// Returns the base color at a pixel of a picture with the channels normal and albedo.
glm::dvec3 albedoAt(const Picture& picture, int x, int y)
{
    return {picture.image.at(x, y, 8), picture.image.at(x, y, 9), picture.image.at(x, y, 10)};
}

TEST_F(PictureChannels, AlbedoIsTheColorOfTheMaterialInAnyLight)
{
    const glm::dvec3 color(0.75, 0.5, 0.125);  // Exact as half floats.
    Shot shot;
    shot.request.frame.channels = {.normal = true, .albedo = true};
    shot.values().set(sdfTable().baseColor, ColorValue{color});
    for (const bool shownAsMesh : {false, true}) {
        shot.values().set(sdfTable().shownAs, shownAsMesh ? SdfShown::mesh : SdfShown::field);
        for (const double sun : {0.1, 0.9}) {
            shot.hall().set(hallTable().sunElevation, sun);
            const Picture picture = shot.take();
            ASSERT_EQ(picture.image.channelNames[8], "albedo.R");
            int hits = 0;
            picture.each([&](int x, int y) {
                const glm::dvec3 expected = picture.hit(x, y) ? color : glm::dvec3(0);
                hits += picture.hit(x, y) ? 1 : 0;
                EXPECT_EQ(albedoAt(picture, x, y), expected) << x << ' ' << y;
            });
            EXPECT_GT(hits, 100);
        }
    }
}

TEST_F(PictureChannels, AlbedoOfTheHallDoesNotDependOnLightAndIsAReflectance)
{
    Shot shot;
    shot.inHall().size(64, 36);
    shot.request.frame.channels = {.normal = true, .albedo = true};
    const Picture evening = shot.take();
    shot.hall().set(hallTable().sunElevation, 0.9);
    const Picture noon = shot.take();
    double sum = 0;
    evening.each([&](int x, int y) {
        const glm::dvec3 albedo = albedoAt(evening, x, y);
        EXPECT_EQ(albedo, albedoAt(noon, x, y)) << x << ' ' << y;
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(albedo[c] >= 0 && albedo[c] <= 1) << x << ' ' << y;
        sum += albedo.y;
    });
    EXPECT_GT(sum / (64 * 36), 0.1) << "walls are light";
    EXPECT_GT(largestDifference(evening.image, noon.image), 0.01);
}

}  // namespace
}  // namespace vitrine

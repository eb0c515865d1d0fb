// Legibility of plaques: letters contrast with their plates in all light, and lie within them.
#include "exhibits/hall/hall_scene.h"
#include "exhibits/hall/plaque_text.h"
#include "tests/support/gallery.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vitrine::hall {
namespace {

using namespace test;

class LongPlaques : public test::GlTest {};

/// Returns a shot of a plate from a distance of a meter, with nothing else in the picture.
Shot plaqueShot(const glm::dmat4& worldFromPlaque)
{
    Shot shot;
    shot.inHall();
    shot.request.frame.averageIn = AverageIn::display;
    shot.request.frame.channels.normal = false;
    shot.see(glm::dvec3(worldFromPlaque * glm::dvec4(0, 0.02, 1, 1)), glm::dvec3(worldFromPlaque[3]));
    shot.request.frame.camera.fovY = 0.23;
    return shot.size(240, 144);
}

/// Returns the ratio of the luminance of the letters' brightest parts to that of the plate, on the display.
double contrastOf(const Picture& p)
{
    std::vector<double> values;
    p.each([&](int x, int y) { values.push_back(p.luminance(x, y)); });
    std::sort(values.begin(), values.end());
    return values[values.size() * 98 / 100] / std::max(values[values.size() / 4], 1e-6);
}

TEST_F(LongPlaques, CanBeReadInEveryLightOfTheDay)
{
    int plates = 0;
    for (const auto& [number, place] : test::building().places()) {
        if (!place.worldFromPlaque) continue;
        ++plates;
        Shot shot = plaqueShot(*place.worldFromPlaque);
        EXPECT_GT(contrastOf(shot.take()), 3) << number;
        shot.hall().set(hallTable().sunStrength, 0.0);
        EXPECT_GT(contrastOf(shot.take()), 3) << number << " in the shade";
        shot.hall().resetParameter(hallTable().sunStrength.row);
        shot.hall().set(hallTable().sunBy, SunBy::hour);
        // Two of six hours for each plate, in turn: each hour is seen on at least three of them.
        for (const int turn : {0, 3}) {
            const double hour = 6.0 + 3.0 * ((plates + turn) % 6);
            shot.hall().set(hallTable().timeOfDay, hour);
            EXPECT_GT(contrastOf(shot.take()), 3) << number << " at " << hour;
        }
    }
    EXPECT_EQ(plates, static_cast<int>(test::building().places().size()));
}

TEST(PlaqueText, FillsItsPlateAndStaysWithinIt)
{
    std::vector<ExhibitSlot> slots;
    for (int place = 1; place <= 9; ++place)
        slots.push_back({.place = place, .title = "Title", .summary = "Few words.", .tryThis = ""});
    slots[1].summary =
        "Many words that go on for as long as a summary may, so that they need several lines of the plate.";
    slots[1].tryThis = "walk past it, then go so near that you see its parts, and turn back to the middle of the hall.";
    const PlaqueText text(test::building(), slots);
    double widest = 0, lowest = 1;
    for (const PlaqueText::Plaque& plaque : text.plaques()) {
        glm::vec3 low(1), high(-1);
        for (const render::Vertex& v : plaque.mesh->vertices) {
            EXPECT_LT(std::abs(v.position.x), 0.21F) << plaque.mesh->name;
            EXPECT_LT(std::abs(v.position.y), 0.13F) << plaque.mesh->name;
            widest = std::max(widest, static_cast<double>(v.position.x));
            if (plaque.mesh->name == "plaque 2") lowest = std::min(lowest, static_cast<double>(v.position.y));
            low = glm::min(low, v.position);
            high = glm::max(high, v.position);
        }
        // The text is centered on the plate.
        EXPECT_NEAR(low.x, -high.x, 1e-5) << plaque.mesh->name;
        EXPECT_NEAR(low.y, -high.y, 1e-5) << plaque.mesh->name;
    }
    EXPECT_GT(widest, 0.15);
    EXPECT_LT(lowest, -0.05) << "the lower half is not left empty";
}

}  // namespace
}  // namespace vitrine::hall

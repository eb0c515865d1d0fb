// Elements that the building's file describes by the names of its nodes.
#include "exhibits/fur/coat.h"
#include "exhibits/hall/spotlights.h"
#include "exhibits/lenticular/card_sheet.h"
#include "exhibits/lenticular/lenticular.h"
#include "render/files/assets.h"
#include "render/scene/gltf.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::hall {
namespace {

using std::numbers::pi;

TEST(HallModel, HasAnOpeningInTheFarWallAndOneInTheVault)
{
    const HallModel& hall = test::building();
    const render::Box& room = hall.room();
    ASSERT_EQ(hall.openings().size(), 2U);
    const render::Box &window = hall.openings()[0], &oculus = hall.openings()[1];
    // Each spans the wall that it is in, and lies within the sides of the room.
    EXPECT_LT(window.low.z, room.low.z);
    EXPECT_GT(window.high.z, room.low.z);
    EXPECT_GT(oculus.high.y, room.high.y);
    EXPECT_LE(oculus.low.y, room.high.y);
    for (const int axis : {0, 1}) {
        EXPECT_GT(window.low[axis], room.low[axis]);
        EXPECT_LT(window.high[axis], room.high[axis]);
    }
    for (const int axis : {0, 2}) {
        EXPECT_GT(oculus.low[axis], room.low[axis]);
        EXPECT_LT(oculus.high[axis], room.high[axis]);
    }
    // They are open: a ray through the center of either hits no wall.
    for (const render::Box& opening : hall.openings()) {
        const render::Ray out{{0, 1.65, 0.3}, opening.center() - glm::dvec3(0, 1.65, 0.3)};
        for (const render::MeshInstance& part : hall.walls())
            EXPECT_GT(render::firstHit(out, part, render::Faces::front), 1);
    }
}

TEST(HallModel, CapturesTheProbeInTheAirBetweenTheWallsThatItStandsFor)
{
    const HallModel& hall = test::building();
    EXPECT_TRUE(hall.room().contains(hall.probe()));
    EXPECT_TRUE(hall.probeRoom().contains(hall.probe()));
    for (const int axis : {0, 2}) EXPECT_NEAR(hall.probeRoom().high[axis], hall.room().high[axis], 1e-6);
}

TEST(HallModel, HasThePitThatTheFurIsMadeFor)
{
    const render::Model file = render::loadGltf(render::asset("models/hall.glb"));
    const auto pit = std::find_if(file.markers.begin(), file.markers.end(),
                                  [](const render::Marker& marker) { return marker.name == "pit_3"; });
    ASSERT_NE(pit, file.markers.end());
    const render::Box box = render::Box{glm::dvec3(-1), glm::dvec3(1)}.transformed(
        glm::inverse(test::building().place(3)->worldFromPlace) * pit->modelFromMarker);
    EXPECT_NEAR(box.high.x, fur::pitRadius, 1e-6);
    EXPECT_NEAR(box.high.z, fur::pitRadius, 1e-6);
    EXPECT_NEAR(box.low.x, -fur::pitRadius, 1e-6);
    EXPECT_NEAR(box.low.y, 0, 1e-6);
    EXPECT_NEAR(box.high.y, fur::pitRim, 1e-6);
}

TEST(HallModel, KnowsWhichPlacesAreFramesInItsWalls)
{
    const HallModel& hall = test::building();
    for (const auto& [number, place] : hall.places())
        EXPECT_EQ(isInWall(place, hall.room()), number >= 5 && number != freePlinthPlace) << number;
    // A frame on the wall of the door, which is not where any of the others hangs.
    Place door;
    door.worldFromPlace =
        glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(2, 1.65, hall.room().high.z)), pi, glm::dvec3(0, 1, 0));
    EXPECT_TRUE(isInWall(door, hall.room()));
    Place turned = door, away = door;
    turned.worldFromPlace = glm::rotate(door.worldFromPlace, pi, glm::dvec3(0, 1, 0));
    EXPECT_FALSE(isInWall(turned, hall.room()));
    away.worldFromPlace = glm::translate(door.worldFromPlace, glm::dvec3(0, 0, 1));
    EXPECT_FALSE(isInWall(away, hall.room()));
}

TEST(HallModel, HasABarThatTheCardLeansAgainst)
{
    // The bar's front: the largest face behind the middle of the card that leans back and faces the visitor.
    double largest = 0;
    glm::dvec3 normal(0), place(0);
    const Place& card = *test::building().place(2);
    for (const render::MeshInstance& part : card.stand) {
        const glm::dmat4 placeFromPart = glm::inverse(card.worldFromPlace) * part.modelFromPart;
        const std::vector<std::uint32_t>& indices = part.mesh->indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return glm::dvec3(placeFromPart * glm::dvec4(part.mesh->vertices[indices[i + k]].position, 1));
            };
            const glm::dvec3 a = corner(0), across = glm::cross(corner(1) - a, corner(2) - a);
            const double area = 0.5 * glm::length(across);
            const glm::dvec3 n = area > 0 ? across / (2 * area) : glm::dvec3(0);
            if (std::abs(n.x) > 1e-3 || n.y < 0.1 || n.z < n.y || area <= largest) continue;
            if (std::abs(a.y - lenticular::cardMiddle().y) > 0.1) continue;
            largest = area;
            normal = n;
            place = a;
        }
    }
    ASSERT_GT(largest, 1e-3);  // Square meters.
    EXPECT_NEAR(std::atan2(normal.y, normal.z), lenticular::cardLean, 1e-3) << "LEAN in assets/models/hall_props.py";
    // It touches the back of the card, which is 5 mm thick.
    const glm::dvec3 onCard(glm::inverse(lenticular::exhibitFromCard()) * glm::dvec4(place, 1));
    EXPECT_NEAR(onCard.z, -2 * lenticular::cardHalfSize.z, 1e-3);
}

}  // namespace
}  // namespace vitrine::hall

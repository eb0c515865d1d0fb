// Tours: in files, and through a real building.

#include "exhibits/hall/walk.h"
#include "exhibits/recording/record.h"
#include "exhibits/recording/tour.h"
#include "exhibits/recording/way_around.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vitrine::recording {
namespace {

using glm::dvec3;
using test::museum;

std::string complaintOf(const std::string& text)
{
    try {
        static_cast<void>(parseTour(text, "tour.json"));
        return {};
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), ErrorKind::file);
        return failure.what();
    }
}

Tour twoViews(const dvec3& a, const dvec3& b)
{
    return {"Two", {{"here", {a, a + dvec3(0, 0, -1)}}, {"there", {b, b + dvec3(0, 0, -1)}}}, false, Pace::eased};
}

TEST(TourFile, ComesBackAsItWas)
{
    Tour tour = twoViews({0.1, 1.65, 10.5}, {1.0 / 3, 1.7, 2});
    tour.closed = true;
    tour.pace = Pace::constant;
    tour.bookmarks[1].name = "Über \"dem\" Meer";
    const Tour again = parseTour(tourText(tour), "tour.json");
    EXPECT_EQ(again.name, tour.name);
    EXPECT_EQ(again.bookmarks, tour.bookmarks);
    EXPECT_TRUE(again.closed);
    EXPECT_EQ(again.pace, Pace::constant);
    EXPECT_TRUE(again.notes.empty());
    EXPECT_EQ(tourText(again), tourText(tour));
}

TEST(TourFile, WhatIsWrongIsNamedByLineAndKey)
{
    const std::string head = "{\"format\": \"vitrine-tour\",\n\"version\": 1,\n";
    const std::string camera = "\"camera\": {\"eye\": [0, 1, 2], \"target\": [0, 1, 0]}";
    EXPECT_EQ(complaintOf(head + "\"bookmarks\": [{" + camera + "}]}"), "");
    const auto expect = [](const std::string& text, const std::vector<std::string>& parts) {
        const std::string said = complaintOf(text);
        for (const std::string& part : parts) EXPECT_NE(said.find(part), std::string::npos) << part << " in: " << said;
    };
    expect("{", {"tour.json, line 1"});
    expect("[]", {"tour.json", "object"});
    expect("{\"version\": 1}", {"format", "missing"});
    expect("{\"format\": \"vitrine-preset\"}", {"vitrine-preset", "not a tour"});
    expect("{\"format\": \"vitrine-tour\",\n\"version\": 2}", {"line 2, version", "newer"});
    expect("{\"format\": \"vitrine-tour\",\n\"version\": \"1\"}", {"line 2, version"});
    expect(head + "\"bookmarks\": []}", {"line 3, bookmarks", "at least one"});
    expect(head + "\"bookmarks\": [7]}", {"bookmarks[0]", "object"});
    expect(head + "\"bookmarks\": [{\"name\": 7, " + camera + "}]}", {"bookmarks[0].name", "text"});
    expect(head + "\"bookmarks\": [{" + camera + "},\n{\"name\": \"b\"}]}", {"line 4", "bookmarks[1]", "camera"});
    expect(head + "\"bookmarks\": [\n{\"camera\": {\"eye\": [0, 1], \"target\": [0, 1, 0]}}]}",
           {"line 4", "bookmarks[0].camera.eye", "three numbers"});
    expect(head + "\"bookmarks\": [{\"camera\": {\"eye\": [0, 1, 2]}}]}", {"bookmarks[0].camera", "target"});
    expect(head + "\"pace\": \"fast\", \"bookmarks\": [{" + camera + "}]}", {"line 3, pace", "fast", "eased"});
    expect(head + "\"closed\": 1, \"bookmarks\": [{" + camera + "}]}", {"closed", "true or false"});
    const Tour noted = parseTour(head + "\"speed\": 1, \"bookmarks\": [{\"x\": 1, " + camera + "}]}", "tour.json");
    EXPECT_EQ(noted.notes.size(), 2U);
}

TEST(TourPath, GoesStraightWhereNothingStands)
{
    const CameraPath path =
        tourPath(museum().surroundings().obstacles(), twoViews({-0.5, 1.65, 10.5}, {0.5, 1.65, 10.5}));
    EXPECT_NEAR(path.length(), 1, 1e-6);
}

/// Returns the smallest distance in meters between an eye of the path and an obstacle. Independent of the tour's code.
double clearance(const CameraPath& path)
{
    double nearest = 1e9;
    for (int i = 0; i <= 4000; ++i) {
        const dvec3 eye = path.at(i / 4000.0).eye;
        for (const hall::Collider& collider : test::building().colliders()) {
            const dvec3 p = dvec3(collider.localFromWorld * glm::dvec4(eye, 1));
            const double dy = std::max(std::abs(p.y) - collider.halfSize.y, 0.0);
            const double flat = collider.cylinder ? std::max(std::hypot(p.x, p.z) - collider.halfSize.x, 0.0)
                                                  : std::hypot(std::max(std::abs(p.x) - collider.halfSize.x, 0.0),
                                                               std::max(std::abs(p.z) - collider.halfSize.z, 0.0));
            nearest = std::min(nearest, std::hypot(flat, dy));
        }
    }
    return nearest;
}

TEST(TourPath, IsLedRoundWhatStandsBetween)
{
    // From one side of each collider of the museum that is as high as a visitor to the other.
    int tried = 0;
    for (const hall::Collider& collider : test::building().colliders()) {
        const glm::dmat4 world = glm::inverse(collider.localFromWorld);
        const double reach = collider.halfSize.x + 0.9;
        dvec3 a = dvec3(world * glm::dvec4(-reach, 0, 0, 1)), b = dvec3(world * glm::dvec4(reach, 0, 0, 1));
        a.y = b.y = 0.8;  // Below the tops of plinths.
        const bool inside = std::abs(a.x) < 6 && std::abs(b.x) < 6 && std::abs(a.z) < 12 && std::abs(b.z) < 12;
        if (!inside || museum().surroundings().obstacles().cameraPasses(a, b) ||
            !museum().surroundings().obstacles().cameraPasses(a, a) ||
            !museum().surroundings().obstacles().cameraPasses(b, b))
            continue;
        const CameraPath path = tourPath(museum().surroundings().obstacles(), twoViews(a, b));
        EXPECT_GE(clearance(path), hall::cameraRadius - 0.01);
        EXPECT_GT(path.length(), glm::length(a - b));
        ++tried;
    }
    EXPECT_GT(tried, 0);
}

TEST(TourPath, IsLedRoundTheVisitorsOwnObjects)
{
    const hall::HallTable& table = test::hallTable();
    const hall::OwnObjectParameters& rows = table.objects[1];
    SceneState sceneState = museum().initialSceneState();
    sceneState.hall().set(rows.model, render::asset("models/teddy.glb").string());
    sceneState.hall().set(rows.modelStand, hall::ObjectStand::ownPlinth);
    sceneState.hall().set(rows.modelAcross, 0.0);
    sceneState.hall().set(rows.modelAlong, 10.2);
    const Obstacles obstacles = museum().surroundings().obstacles(sceneState);
    ASSERT_GT(obstacles.count(), museum().surroundings().obstacles().count());
    const Tour past = twoViews({-1.6, 0.9, 10.2}, {1.6, 0.9, 10.2});
    EXPECT_NEAR(tourPath(museum().surroundings().obstacles(), past).length(), 3.2, 1e-6) << "nothing else stands there";
    const CameraPath path = tourPath(obstacles, past);
    EXPECT_GT(path.length(), 3.3);
    // The sides of the plinth, at least 0.18 m from its center, stay out of the camera's reach.
    for (int i = 0; i <= 2000; ++i) {
        const dvec3 eye = path.at(i / 2000.0).eye;
        EXPECT_GT(std::max(std::abs(eye.x), std::abs(eye.z - 10.2)), 0.18 + hall::cameraRadius - 0.01) << i;
    }
    // The museum's own tour leaves out the view that the object blocks.
    const Tour before = museumTour(museum(), museum().initialSceneState());
    const dvec3 eye = before.bookmarks.front().camera.eye;
    sceneState.hall().set(rows.modelAcross, before.bookmarks.back().camera.eye.x);
    sceneState.hall().set(rows.modelAlong, before.bookmarks.back().camera.eye.z);
    sceneState.hall().set(rows.modelPlinthHeight, 1.2);
    const Tour after = museumTour(museum(), sceneState);
    EXPECT_EQ(after.bookmarks.front().camera.eye, eye);
    EXPECT_LT(after.bookmarks.size(), before.bookmarks.size());
    EXPECT_NO_THROW(static_cast<void>(tourPath(museum().surroundings().obstacles(sceneState), after)));
}

TEST(TourPath, ErrorsNameTheBookmarks)
{
    const auto said = [](const dvec3& a, const dvec3& b) -> std::string {
        try {
            static_cast<void>(tourPath(museum().surroundings().obstacles(), twoViews(a, b)));
            return {};
        } catch (const Failure& failure) {
            return failure.what();
        }
    };
    const hall::Collider& solid = test::building().colliders().front();
    const dvec3 middle = dvec3(glm::inverse(solid.localFromWorld) * glm::dvec4(0, 0, 0, 1));
    EXPECT_NE(said({0, 1.65, 10.5}, middle).find("\"there\" is inside"), std::string::npos);
    const std::string out = said({0, 1.65, 10.5}, {0, 1.65, 500});
    EXPECT_NE(out.find("\"here\" to \"there\""), std::string::npos) << out;
    // The largest coordinates that a file may have; must end within seconds.
    const std::string far = said({0, 1.65, 10.5}, {1e6, -1e6, 1e6});
    EXPECT_NE(far.find("\"here\" to \"there\""), std::string::npos) << far;
}

TEST(TourPath, TheMuseumsOwnPassesEveryExhibitAndHitsNothing)
{
    const SceneState sceneState = museum().initialSceneState();
    const Tour tour = museumTour(museum(), sceneState);
    for (const MuseumExhibit& each : museum().exhibits()) {
        const auto isIt = [&](const Bookmark& bookmark) {
            return bookmark.camera == museum().bestView(each.index, sceneState.values[each.index]);
        };
        EXPECT_TRUE(std::any_of(tour.bookmarks.begin(), tour.bookmarks.end(), isIt)) << each.exhibit.name();
    }
    const CameraPath path = tourPath(museum().surroundings().obstacles(), tour);
    EXPECT_GE(clearance(path), hall::cameraRadius - 0.01);
    EXPECT_EQ(path.at(0), path.at(1));
    for (const Bookmark& bookmark : tour.bookmarks) {
        double nearest = 1e9;
        for (int i = 0; i <= 8000; ++i)
            nearest = std::min(nearest, glm::length(path.at(i / 8000.0).eye - bookmark.camera.eye));
        EXPECT_LT(nearest, path.length() / 8000) << bookmark.name;
    }
}

TEST(WayAround, IsFreeBetweenAllOfItsPlaces)
{
    const dvec3 from(0, 1.65, 11), to(0, 1.65, -11);
    for (const double stride : {3.0, 0.5}) {
        std::vector<dvec3> way = wayAround(museum().surroundings().obstacles(), from, to, stride);
        ASSERT_FALSE(way.empty());
        way.insert(way.begin(), from);
        way.push_back(to);
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            EXPECT_TRUE(museum().surroundings().obstacles().cameraPasses(way[i], way[i + 1])) << i;
            EXPECT_LE(glm::length(way[i + 1] - way[i]), stride + 1e-9) << i;
        }
    }
    EXPECT_TRUE(wayAround(museum().surroundings().obstacles(), from, {0, 1.65, 300}, 2).empty());
}

TEST(FramePath, CountsFromOne)
{
    EXPECT_EQ(framePath("frames/%04d.png", 0), "frames/0001.png");
    EXPECT_EQ(framePath("a%d.png", 11), "a12.png");
    EXPECT_EQ(framePath("%02d.png", 122), "123.png");
}

TEST(FramePath, OtherNamesAreRefused)
{
    const RecordingRequest request;
    for (const char* good : {"a.mp4", "f/%04d.png", "f/x-%d.png", "a.apng"})
        EXPECT_EQ(whyNotRecordable(request, good), "") << good;
    for (const char* bad : {"a.png", "a.avi", "%s.png", "%04d%d.png", "%04d.jpg", "%.png", "%0d.png", ""})
        EXPECT_NE(whyNotRecordable(request, bad), "") << bad;
}

}  // namespace
}  // namespace vitrine::recording

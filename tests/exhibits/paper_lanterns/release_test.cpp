// The lantern that the button releases, among the others.

#include "exhibits/paper_lanterns/lake_release.h"
#include "tests/exhibits/paper_lanterns/lake_at_float64.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vitrine::paper_lanterns {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace test;

/// Returns the lake at a time, `since` seconds after a lantern was released.
glsl::Lake lakeSince(const ParameterValues& values, double seconds, double since)
{
    glsl::Lake made = lakeAtFloat64(values, seconds);
    copyLake(made.lake, lakeBlock(lanternsTable(), values, seconds, {since, seconds - since}));
    return made;
}

/// Returns points of a lantern: around the edges of its base, and around its tube at five heights.
std::vector<dvec3> placesOn(const glsl::Lake& lake)
{
    std::vector<dvec3> places;
    const double side = lake.lake.baseHalfWidth;
    for (int i = 0; i < 16; ++i)
        for (const double up : {-1.0, 1.0})
            for (int edge = 0; edge < 4; ++edge) {
                const double along = side * (2 * i / 15.0 - 1), across = edge % 2 == 0 ? side : -side;
                const double y = up * lake.lake.baseHalfHeight;
                places.push_back(edge < 2 ? dvec3(along, y, across) : dvec3(across, y, along));
            }
    for (int i = 0; i < 24; ++i)
        for (int level = 0; level <= 4; ++level) {
            const double angle = 2 * 3.14159265358979 * i / 24;
            places.emplace_back(lake.lake.paperRadius * std::cos(angle), 0.25 * level * lake.lake.paperHeight,
                                lake.lake.paperRadius * std::sin(angle));
        }
    return places;
}

bool isWithin(glsl::Lake& lake, const std::vector<dvec3>& places, const glsl::Lake::Lantern& a,
              const glsl::Lake::Lantern& b)
{
    const glm::dmat3 fromA = lake.lakeFromLantern(a), fromB = lake.lakeFromLantern(b);
    for (const dvec3& place : places)
        if (lake.lanternField((fromA * place + a.place - b.place) * fromB).distance < -1e-3) return true;
    return false;
}

/// Returns whether the lantern intersects one of the lattice.
bool touchesAny(glsl::Lake& lake, const glsl::Lake::Lantern& free)
{
    const std::vector<dvec3> places = placesOn(lake);
    const dvec2 at = dvec2(free.place.x - lake.lake.corner.x, lake.lake.corner.y - free.place.z) / lake.lake.cell;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            const glm::ivec2 cell(static_cast<int>(std::floor(at.x)) + x, static_cast<int>(std::floor(at.y)) + y);
            if (!lake.inLattice(cell)) continue;
            const auto other = lake.lanternOfCell(cell);
            if (other.light < 0 || glm::distance(other.place, free.place) > 5) continue;
            if (isWithin(lake, places, free, other) || isWithin(lake, places, other, free)) return true;
        }
    return false;
}

struct Voyage {
    int touched = 0, straightOn = 0;  ///< Times of contact on its path, and on a straight path.
    double far = 0;                   ///< Distance traveled in meters.
    double jump = 0;                  ///< Longest distance in a fiftieth of a second.
};

Voyage voyage(const ParameterValues& values, double begun)
{
    Voyage found;
    dvec3 first(0);
    for (double since = 0; since < releasedFor; since += 2.5) {
        glsl::Lake lake = lakeSince(values, begun + since, since);
        auto free = lake.releasedLantern();
        if (since == 0) first = free.place;
        found.touched += touchesAny(lake, free);
        found.far = std::max(found.far, glm::distance(free.place, first));
        const auto next = lakeSince(values, begun + since + 0.02, since + 0.02).releasedLantern();
        found.jump = std::max(found.jump, glm::distance(free.place, next.place));
        const dvec2 way = 0.55 * since * straightAhead();
        free.place = first + dvec3(way.x, 0, way.y);
        const auto ride = lake.rideAt({free.place.x, free.place.z});
        free.place.y = ride.height;
        free.tilt = ride.slope;
        found.straightOn += touchesAny(lake, free);
    }
    return found;
}

/// Returns the initial lake, the festival's crowd, and the storm.
std::vector<ParameterValues> lakes()
{
    const PaperLanternsTable& t = lanternsTable();
    std::vector<ParameterValues> all(3, t.initial());
    all[1].set(t.crowding, 1.0);
    all[1].set(t.spacing, 4.6);
    all[2].set(t.waveHeight, 3.4);
    all[2].set(t.spacing, 11.0);
    all[2].set(t.drift, 0.6);
    for (ParameterValues& values : all) values.set(t.release, LakeRelease::driftsAway);
    return all;
}

TEST(LanternsAfloat, OneThatDriftsAwaySteersClearOfTheOthers)
{
    int straightOn = 0;
    std::vector<double> far;
    for (const ParameterValues& values : lakes())
        for (const double begun : {0.0, 311.0}) {
            const Voyage found = voyage(values, begun);
            EXPECT_EQ(found.touched, 0);
            EXPECT_LT(found.jump, 0.12);
            straightOn += found.straightOn;
            far.push_back(found.far);
        }
    EXPECT_GT(straightOn, 20);
    EXPECT_GT(far[0], 6);
    EXPECT_GT(far[4], 6);
}

TEST(LanternsAfloat, OneThatRisesTouchesNoOtherOnItsWayUp)
{
    for (ParameterValues values : lakes()) {
        values.set(lanternsTable().release, LakeRelease::rises);
        const Voyage found = voyage(values, 20);
        EXPECT_EQ(found.touched, 0);
        EXPECT_GT(found.far, 20);
    }
}

/// Numbers of distance computations between two lanterns, over the times of `expectSameWay`.
struct Reckoned {
    int near = 0, far = 0, most = 0;
};

/// Expects that lanterns 34 m farther away change nothing, bit by bit.
Reckoned expectSameWay(const ParameterValues& values, double begun)
{
    Reckoned sum;
    for (const double since : {0.0, 7.3, 21.0, 59.95, 1e4}) {
        LakeBlock near = lakeBlock(lanternsTable(), values, begun + since), far = near;
        const int gaps = setReleased(lanternsTable(), values, begun + since, {since, begun}, near).gaps;
        sum.near += gaps;
        sum.far += setReleased(lanternsTable(), values, begun + since, {since, begun}, far, 34).gaps;
        sum.most = std::max(sum.most, gaps);
        EXPECT_EQ(near.released, far.released) << since;
        EXPECT_EQ(near.releasedPose, far.releasedPose);
        EXPECT_EQ(near.freedCell, far.freedCell);
    }
    return sum;
}

TEST(LanternsAfloat, OnlyThoseThatOneMayMeetAreLookedAt)
{
    Reckoned all;
    for (ParameterValues values : lakes())
        for (const LakeRelease release : {LakeRelease::rises, LakeRelease::driftsAway}) {
            values.set(lanternsTable().release, release);
            const Reckoned one = expectSameWay(values, 311);
            all.near += one.near;
            all.far += one.far;
            all.most = std::max(all.most, one.most);
        }
    EXPECT_GT(all.far, 20 * all.near);
    EXPECT_LT(all.most, 2000);
}

TEST(LanternsAfloat, OneThatHasComeToRestStaysWhereItIs)
{
    const PaperLanternsTable& t = lanternsTable();
    ParameterValues values = lakes()[1];
    values.set(t.drift, 0.0);
    const auto placeAt = [&](double since) {
        const glm::vec4 free = lakeBlock(t, values, since, {since, 0}).released;
        return glm::vec2(free.x, free.z);
    };
    // Between others without space, also within a step of its path.
    for (const double since : {20.03, 20.05, 20.09, 33.37, 59.9}) EXPECT_EQ(placeAt(since), placeAt(20)) << since;
    EXPECT_GT(glm::distance(placeAt(0), placeAt(20)), 0.3);
}

/// Returns a crowd without space for another lantern, so that one of its own leaves.
ParameterValues fullLake()
{
    const PaperLanternsTable& t = lanternsTable();
    ParameterValues values = t.initial();
    values.set(t.crowding, 1.0);
    values.set(t.spacing, 1.0);  // The least that a lantern needs.
    values.set(t.release, LakeRelease::driftsAway);
    return values;
}

TEST(LanternsAfloat, OneThatWasSetFreeStaysTheSameWhenTimeStands)
{
    const PaperLanternsTable& t = lanternsTable();
    ParameterValues values = fullLake();
    values.set(t.drift, 0.6);
    const auto at = [&](bool runs, double time) {
        values.set(t.animate, runs);
        return lakeBlock(t, values, lakeTime(t, values, time), lakePress(t, values, time, time - 40));
    };
    const LakeBlock first = at(true, 40);
    for (const double time : {44.0, 60.0, 300.0}) {
        const LakeBlock runs = at(true, time), stands = at(false, time);
        EXPECT_EQ(runs.freedCell, first.freedCell);
        EXPECT_EQ(stands.freedCell, first.freedCell);
        EXPECT_EQ(stands.releasedPose.z, runs.releasedPose.z);
        if (runs.released.w < 0) continue;
        // The lake with all lanterns is displaced by its drift.
        const dvec2 drifted = values[t.drift] * time * windOf(t, values);
        EXPECT_NEAR(runs.released.x - stands.released.x, drifted.x, 1e-4);
        EXPECT_NEAR(runs.released.z - stands.released.z, drifted.y, 1e-4);
    }
    // Starting from the present position of the lake would select another lantern.
    const LakeBlock other = lakeBlock(t, values, 0, {4, -4});
    EXPECT_NE(other.freedCell, first.freedCell);
}

TEST(LanternsAfloat, OneThatWasSetFreeStaysTheSameWhenItsCellHasLeftTheLake)
{
    const PaperLanternsTable& t = lanternsTable();
    ParameterValues values = fullLake();
    values.set(t.drift, 3.0);
    const LakeBlock first = lakeBlock(t, values, 100, {0, 100});
    int left = 0;
    for (double since = 2.5; since < 60; since += 2.5) {
        const LakeBlock block = lakeBlock(t, values, 100 + since, {since, 100});
        EXPECT_EQ(block.freedCell, first.freedCell) << since;
        EXPECT_EQ(block.releasedPose.z, first.releasedPose.z);
        const glm::ivec2 cell = block.freedCell - block.firstCell;
        left += cell.x < 0 || cell.y < 0 || cell.x >= block.cells.x || cell.y >= block.cells.y;
    }
    EXPECT_GT(left, 5);
}

TEST(LanternsAfloat, OneOfACrowdLeavesItsCellEmpty)
{
    ParameterValues values = fullLake();
    const auto afloat = [&](double seconds, double since) {
        glsl::Lake lake = lakeSince(values, seconds, since);
        int count = 0;
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 30; ++x) count += lake.lanternOfCell({x, y}).light >= 0;
        return count;
    };
    EXPECT_EQ(afloat(10, INFINITY), 900);
    EXPECT_EQ(afloat(10, 0), 899);
    EXPECT_EQ(afloat(15, 5), 899);
    EXPECT_EQ(afloat(200, 190), 899) << "it is gone for good";
    // It begins at its old place.
    glsl::Lake before = lakeSince(values, 10, INFINITY), after = lakeSince(values, 10, 0);
    const auto free = after.releasedLantern();
    const auto was = before.lanternOfCell(after.lake.freedCell - after.lake.firstCell);
    EXPECT_NEAR(glm::distance(free.place, was.place), 0, 1e-4);
    EXPECT_NEAR(free.turn, was.turn, 1e-5);
    EXPECT_NEAR(free.light, was.light, 1e-5);
    // With space around, a new lantern appears, and none is missing.
    values.set(lanternsTable().spacing, 30.0);
    EXPECT_EQ(afloat(10, 5), 900);
}

}  // namespace
}  // namespace vitrine::paper_lanterns

// Pictures of the lake, compared with closed forms and with each other.

#include "tests/exhibits/paper_lanterns/lake_shot.h"
#include "tests/support/plan_steps.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vitrine::paper_lanterns {
namespace {

using namespace test;
using glm::dvec3;

const PaperLanternsTable& rows()
{
    return lanternsTable();
}

class LakePictures : public GlTest {};

/// Returns the mean luminance of the rows from `first` to `last`.
double meanOf(const Picture& p, int first, int last)
{
    double sum = 0;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < p.width(); ++x) sum += p.luminance(x, y);
    return sum / ((last - first) * p.width());
}

TEST_F(LakePictures, EachLightIsOnlyItsOwn)
{
    LakeShot shot;
    shot.inTheDark().set(rows().ripples, 0.02);
    const double lit = meanOf(shot.take(), 31, 60);
    shot.set(rows().candles, false);
    const Picture dark = shot.take();
    // Only airglow: the sky is darker than a thousandth of the lanterns.
    EXPECT_LT(meanOf(dark, 31, 60), 0.02 * lit);
    EXPECT_LT(meanOf(dark, 31, 60), 0.004);
    EXPECT_GT(meanOf(dark, 0, 29), 0);
    shot.set(rows().moon, 2.0);
    EXPECT_GT(meanOf(shot.take(), 31, 60), 3 * meanOf(dark, 31, 60));
}

TEST_F(LakePictures, ShowsThreePartsAndTheWater)
{
    LakeShot shot;
    shot.set(rows().show, LakeShow::parts).set(rows().fog, 0.0).set(rows().pointSize, 0.5);
    const auto count = [&] {
        const Picture p = shot.take();
        glm::ivec3 parts(0);
        p.each([&](int x, int y) {
            const dvec3 c = p.color(x, y);
            if (y < 34 || c.x + c.y < 0.15) return;
            parts += glm::ivec3(c.x > 1.3 * c.y && c.x > 3 * c.z, c.y > 1.2 * c.x && c.y > 1.2 * c.z, c.z > 1.5 * c.x);
        });
        return parts;
    };
    const glm::ivec3 parts = count();
    EXPECT_GT(parts.x, 100);
    EXPECT_GT(parts.y, 20);
    EXPECT_GT(parts.z, 20);
    // A frame of thin wire is hardly visible; without lanterns there are no parts.
    shot.set(rows().ringWire, 0.005).set(rows().postWire, 0.005).set(rows().frameBlend, 0.0);
    EXPECT_LT(count().z, parts.z / 2);
    shot.set(rows().crowding, 0.0);
    EXPECT_EQ(count(), glm::ivec3(0));
}

TEST_F(LakePictures, PaperIsLitOnBothSides)
{
    // View into a lantern from above: its inside, and the outside of others.
    LakeShot shot;
    shot.inTheDark().set(rows().lanterns, 1).set(rows().crowding, 1.0).set(rows().irregularity, 0.0);
    shot.request.frame.camera = {{0, 0.3, -1.2}, {0, -1.3, -3.1}, 0.5};
    const Picture p = shot.take();
    double brightest = 0;
    int lit = 0;
    p.each([&](int x, int y) {
        brightest = std::max(brightest, p.luminance(x, y));
        lit += p.luminance(x, y) > 0.1;
    });
    EXPECT_GT(lit, 300);
    shot.set(rows().paperThickness, 20.0);
    const Picture thick = shot.take();
    double outside = 0, before = 0;
    // The lower part of the picture shows the paper's outside: thick paper transmits less.
    for (int x = 30; x < 66; ++x) {
        outside += thick.luminance(x, 42);
        before += p.luminance(x, 42);
    }
    EXPECT_LT(outside, 0.5 * before);
}

TEST_F(LakePictures, TheFlameIsSeenThroughTheOpening)
{
    LakeShot shot;
    shot.inTheDark();
    const auto l = shot.withOneLantern();
    const dvec3 flame = l.place + dvec3(0, lanternsTable().initial()[rows().flameHeight], 0);
    // From above, through the opening, and from the side, through the paper.
    const Picture above = shot.from(flame + dvec3(0.4, 6, 0.4), flame, 0.5).take();
    const Picture beside = shot.from(flame + dvec3(6, 0, 0.4), flame, 0.5).take();
    const double naked = above.luminance(48, 30);
    EXPECT_GT(naked, 8 * beside.luminance(48, 30));
    EXPECT_GT(beside.luminance(48, 30), 4 * beside.luminance(48, 10));
    EXPECT_LT(above.mean(), 0.1 * naked);
}

TEST_F(LakePictures, AVisitorsPanoramaIsTheSkyAndIsMirrored)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "sky.hdr";
    // Red in front, green behind.
    writePanorama(file, [](const dvec3& d) { return d.z < 0 ? dvec3(1, 0, 0) : dvec3(0, 1, 0); });
    LakeShot shot;
    shot.set(rows().panorama, file.string()).set(rows().fog, 0.0).set(rows().crowding, 0.0).set(rows().moon, 0.0);
    const Picture p = shot.take();
    EXPECT_GT(p.color(48, 5).x, 0.2);
    EXPECT_LT(p.color(48, 5).y, 0.01);
    EXPECT_GT(p.color(48, 36).x, 4 * p.color(48, 36).y);
}

TEST_F(LakePictures, HorizonHasTheColorOfTheMist)
{
    LakeShot shot;
    shot.set(rows().fog, 0.05).set(rows().candles, false).set(rows().horizonColor, ColorValue{{0.1, 0.4, 0.2}});
    const Picture p = shot.take();
    const dvec3 c = p.color(48, 29);
    EXPECT_NEAR(c.y / c.x, 4, 0.3);
    EXPECT_NEAR(c.y / c.z, 2, 0.15);
    // Without mist, the horizon has the color of the sky.
    shot.set(rows().fog, 0.0);
    const dvec3 clear = shot.take().color(48, 29);
    EXPECT_GT(std::abs(clear.y / clear.x - 4), 1);
}

TEST_F(LakePictures, CalmWaterMirrorsALanternWhereItStands)
{
    LakeShot shot;
    shot.inTheDark().set(rows().lanterns, 1).set(rows().crowding, 1.0).set(rows().irregularity, 0.0);
    shot.set(rows().turned, 0.0);
    shot.request.frame.raster.size = {96, 96};
    shot.request.frame.camera = {{0, -0.7, -0.5}, {0, -1.5, -3.0}, 0.8};
    const Picture p = shot.take();
    shot.set(rows().bounces, 0);
    const Picture without = shot.take();
    // The mirror image is below the lantern and equally wide.
    double sum = 0, column = 0, own = 0, ownColumn = 0;
    p.each([&](int x, int y) {
        const double added = p.luminance(x, y) - without.luminance(x, y);
        sum += added;
        column += added * x;
        own += without.luminance(x, y);
        ownColumn += without.luminance(x, y) * x;
    });
    EXPECT_GT(sum, 0.005 * own);
    EXPECT_NEAR(column / sum, ownColumn / own, 1.5);
}

TEST_F(LakePictures, HeightsAndNormalsAreExaggerated)
{
    for (const LakeShow show : {LakeShow::heights, LakeShow::normals}) {
        LakeShot shot;
        shot.set(rows().show, show).set(rows().crowding, 0.0);
        const Picture plain = shot.take();
        shot.set(rows().exaggeration, 8.0);
        EXPECT_GT(colorDifference(plain, shot.take()), 0.02);
    }
}

TEST_F(LakePictures, LanternsLightTheWaterAndEachOther)
{
    LakeShot shot;
    shot.inTheDark().set(rows().bounces, 0).set(rows().waterColor, ColorValue{{0.3, 0.3, 0.3}});
    shot.set(rows().lightCells, 9);
    const double glowing = meanOf(shot.take(), 40, 60);
    shot.set(rows().lightCells, 0);
    EXPECT_GT(glowing, 1.03 * meanOf(shot.take(), 40, 60));
    // Bases and frames, with and without light from the neighbors' flames.
    shot.set(rows().show, LakeShow::parts).set(rows().pointSize, 0.5);
    const Picture parts = shot.take();
    shot.set(rows().show, LakeShow::picture);
    const Picture alone = shot.take();
    shot.set(rows().lightCells, 9);
    const Picture together = shot.take();
    double most = 0;
    parts.each([&](int x, int y) {
        const dvec3 part = parts.color(x, y);
        if (part.y < 1.2 * part.x || part.y < 1.2 * part.z) return;
        const double more = together.luminance(x, y) / alone.luminance(x, y) - 1;
        EXPECT_GT(more, -1e-3) << x << ' ' << y;
        most = std::max(most, more);
    });
    EXPECT_GT(most, 0.03);
}

TEST_F(LakePictures, EachBounceAddsLessAndNoneIsBlack)
{
    LakeShot shot;
    shot.set(rows().waveHeight, 3.0);
    std::vector<Picture> pictures;
    for (int i = 0; i <= 3; ++i) {
        shot.set(rows().bounces, i);
        pictures.push_back(shot.take());
    }
    const double first = colorDifference(pictures[0], pictures[1]);
    const double second = colorDifference(pictures[1], pictures[2]);
    EXPECT_GT(first, 0.002);
    EXPECT_LT(second, 0.5 * first);
    EXPECT_LE(colorDifference(pictures[2], pictures[3]), second);
}

TEST_F(LakePictures, ALanternThatIsSetFreeRises)
{
    LakeShot shot;
    shot.inTheDark().set(rows().crowding, 0.0);
    const auto heightAt = [&](double since) {
        shot.request.frame.sincePressed.assign(gallery().museum.subjects().size(), since);
        const Picture p = shot.take();
        double sum = 0, rowsSum = 0;
        p.each([&](int x, int y) {
            if (p.luminance(x, y) < 0.1) return;
            sum += 1;
            rowsSum += y;
        });
        return sum > 0 ? rowsSum / sum : -1;
    };
    const double early = heightAt(1), later = heightAt(6), high = heightAt(9);
    EXPECT_GT(early, later);
    EXPECT_GT(later, high);
    EXPECT_GT(high, 0);
    EXPECT_EQ(heightAt(releasedFor + 1), -1);
}

TEST_F(LakePictures, FarLanternsAreAsBrightAsPointsAsWhenTheyAreMarched)
{
    LakeShot shot;
    shot.inTheDark().set(rows().bounces, 0).set(rows().flicker, 0.0).set(rows().fibers, 0.0);
    shot.request.frame.camera.fovY = 0.25;
    shot.request.samples = 16;
    shot.set(rows().pointSize, 0.5).set(rows().hitTolerance, 0.01).set(rows().meanSize, 0.02);
    const double marched = shot.take().mean();
    shot.set(rows().pointSize, 60.0);
    EXPECT_NEAR(shot.take().mean() / marched, 1, 0.1);
    // Beyond the rows that are walked, their mean is used.
    shot.set(rows().pointSize, 5.0).set(rows().rows, 9);
    EXPECT_NEAR(shot.take().mean() / marched, 1, 0.2);
}

TEST_F(LakePictures, AreFiniteWhereverTheCameraIsAndWhenever)
{
    const render::Camera cameras[] = {
        {{0, -1.8, -1}, {0.3, -1.2, -4}, 0.9},     // Under water.
        {{0, -1.45, -3.2}, {0.3, -1.4, -4}, 1.2},  // At the place of a lantern's inside.
        {{0, 3e5, 1e6}, {0, 0, 0}, 0.5},           // Far away.
        {{0, -1.6, -3}, {0, 5, -3.001}, 0.9},      // Straight up.
        {{0, 2, -3}, {0, -5, -3.001}, 0.9},        // Straight down.
    };
    for (const LakeLook look : {LakeLook::physical, LakeLook::reference})
        for (const double moment : {0.0, 1e6})
            for (const render::Camera& camera : cameras) {
                LakeShot shot;
                shot.request.frame.raster.size = {48, 30};
                shot.set(rows().look, look).set(rows().moment, moment).set(rows().irregularity, 0.0);
                if (moment > 0) shot.set(rows().lanterns, 1).set(rows().crowding, 1.0);
                shot.request.frame.camera = camera;
                EXPECT_EQ(notFinite(shot.take().image, 4), "");
            }
}

/// Returns the mean change per pixel if the view moves by a pixel.
double lakeShimmer(int samples)
{
    LakeShot shot;
    shot.request.frame.raster.size = {160, 100};
    shot.request.frame.averageIn = AverageIn::display;
    shot.set(rows().stars, 0.0);
    shot.request.samples = samples;
    const Picture before = shot.take();
    shot.request.frame.camera.lensShift.y = 2 * before.view.tanHalfFov.y / before.height();
    const Picture after = shot.take();
    double sum = 0;
    before.each([&](int x, int y) { sum += glm::length(after.color(x, y) - before.color(x, y)); });
    return sum / (before.width() * before.height());
}

TEST_F(LakePictures, ShimmerLittleMoreWithOneSampleThanWith16)
{
    EXPECT_LT(lakeShimmer(1), 1.5 * lakeShimmer(16));
}

/// Returns the exponent of a power law: the number of values above `b` falls as `b` to the power of the negative of it.
/// The maximum-likelihood estimate of Hill 1975 ("A Simple General Approach to Inference About the Tail of a
/// Distribution") for the values above `least`; its standard deviation is the exponent over the root of their number.
double exponentAbove(const std::vector<double>& values, double least, int& count)
{
    double sum = 0;
    count = 0;
    for (const double value : values) {
        if (value <= least) continue;
        sum += std::log(value / least);
        ++count;
    }
    return count / sum;
}

/// Returns the light of each star in a picture of the sky overhead: the sum of the pixels around each maximum.
std::vector<double> starsOverhead()
{
    LakeShot shot;
    shot.inTheDark().set(rows().crowding, 0.0).size(640, 640);
    shot.from({0, 3, 0}, {0.3, 103, -0.2}, 1.1);
    const Picture without = shot.take();
    shot.set(rows().stars, 1.0);
    const Picture with = shot.take();
    const auto light = [&](int x, int y) { return with.luminance(x, y) - without.luminance(x, y); };
    std::vector<double> stars;
    constexpr int reach = 2;
    for (int y = reach; y < with.height() - reach; ++y)
        for (int x = reach; x < with.width() - reach; ++x) {
            const double here = light(x, y);
            double sum = 0;
            bool isLargest = here > 0;
            for (int j = -reach; j <= reach; ++j)
                for (int i = -reach; i <= reach; ++i) {
                    const double there = light(x + i, y + j);
                    sum += there;
                    isLargest = isLargest && (there < here || (i == 0 && j == 0));
                }
            if (isLargest) stars.push_back(sum);
        }
    return stars;
}

TEST_F(LakePictures, StarsOfTheSkyAreAsManyForEachMagnitudeAsAboveTheEarth)
{
    // 3.16 times as many stars with each magnitude (a factor of 2.512): an exponent of log 3.16 / log 2.512.
    const double expected = std::log(3.16) / std::log(2.512);
    std::vector<double> stars = starsOverhead();
    ASSERT_GT(stars.size(), 800U);
    std::sort(stars.begin(), stars.end());
    // The faintest ones are lost among the others.
    for (const double share : {0.4, 0.7}) {
        const double least = stars[static_cast<std::size_t>(share * static_cast<double>(stars.size()))];
        int count = 0;
        const double exponent = exponentAbove(stars, least, count);
        EXPECT_NEAR(exponent, expected, 3 * expected / std::sqrt(count)) << count << " stars above " << least;
    }
    // Control: stars of uniform brightness, and a law with half the exponent, are told apart.
    for (const double other : {0.5 * expected, 2 * expected}) {
        std::vector<double> drawn;
        for (int i = 0; i < 500; ++i) drawn.push_back(std::pow((i + 0.5) / 500, -1 / other));
        int count = 0;
        EXPECT_GT(std::abs(exponentAbove(drawn, 1.0, count) - expected), 3 * expected / std::sqrt(500.0));
    }
}

TEST_F(LakePictures, PlanLeavesOutWhatNoSettingCallsFor)
{
    LakeShot shot;
    const auto plan = [&] { return planned(gallery().museum, shot.sceneState, shot.request.frame); };
    const render::FramePlan whole = plan();
    EXPECT_TRUE(runs(whole, "paper_lanterns/lake"));
    EXPECT_TRUE(runs(whole, "paper_lanterns/float"));
    for (const char* part : {"waves", "moon", "reflection", "mist", "stars"})
        EXPECT_EQ(reasonFor(whole, std::string("paper_lanterns/") + part), "not in the plan") << part;
    shot.inTheDark().set(rows().bounces, 0).set(rows().crowding, 0.0);
    const render::FramePlan least = plan();
    EXPECT_TRUE(runs(least, "paper_lanterns/lake"));
    for (const char* part : {"float", "waves", "moon", "moon_shadow", "reflection", "mist", "stars", "halo"})
        EXPECT_NE(least.findSkipped(std::string("paper_lanterns/") + part), nullptr) << part;
}

TEST_F(LakePictures, CostNothingInTheHallWhereTheyAreNotSeen)
{
    LakeShot shot;
    shot.request.frame.alone = std::nullopt;
    shot.request.frame.camera = gallery().museum.bestView(shot.exhibit, shot.values());
    EXPECT_TRUE(runs(planned(gallery().museum, shot.sceneState, shot.request.frame), "paper_lanterns/"));
    shot.request.frame.camera.target = 2.0 * shot.request.frame.camera.eye - shot.request.frame.camera.target;
    EXPECT_FALSE(runs(planned(gallery().museum, shot.sceneState, shot.request.frame), "paper_lanterns/"));
}

}  // namespace
}  // namespace vitrine::paper_lanterns

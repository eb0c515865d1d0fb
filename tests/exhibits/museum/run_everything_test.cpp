// Running all passes changes no bit, with random settings of every exhibit and of the hall, from random places, at
// extreme times and sizes.
//   VITRINE_SCAN_PRESETS=500   number of settings of each, instead of 8
//   VITRINE_SCAN_SEED=123      first seed; a failure names its own

#include "exhibits/exhibits.h"
#include "exhibits/stability/stability_scan.h"
#include "tests/support/environment_number.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/string_cast.hpp>

namespace vitrine {
namespace {

using test::gallery;

/// Images of a picture, and the passes that ran.
struct Drawn {
    std::vector<render::Image> images;
    std::string passes;
    std::string leftOut;  ///< Skipped passes with their reasons.
};

Drawn drawn(stability::ScanCase c, bool runEverything)
{
    c.frame.runEverything = runEverything;
    c.frame.channels.evaluations = false;  // These count the work, which differs.
    const render::FramePlan plan =
        test::planned(gallery().museum, c.sceneState, c.frame, gallery().renderer.persistentState());
    (void)gallery().renderer.draw(plan);
    Drawn result{{gallery().renderer.read("frame"), gallery().renderer.read(depthImage)}, toString(plan), {}};
    for (const render::CulledPass& skipped : plan.skipped())
        result.leftOut += "\n    " + skipped.name + ": " + skipped.reason;
    if (c.frame.averageIn == AverageIn::radiance) result.images.push_back(gallery().renderer.read(radianceImage));
    if (c.frame.channels.normal) result.images.push_back(gallery().renderer.read(normalImage));
    return result;
}

class RunEverything : public test::GlTest, public testing::WithParamInterface<std::string> {};

TEST_P(RunEverything, ChangesNoBitWhateverIsSetAndFromWhereverItIsSeen)
{
    const std::uint64_t first = test::environmentNumber("VITRINE_SCAN_SEED", 1);
    const std::uint64_t count = test::environmentNumber("VITRINE_SCAN_PRESETS", 8);
    const std::size_t exhibit = *gallery().museum.find(GetParam());
    int leftOut = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const stability::ScanCase c = stability::scanCase(gallery().museum, exhibit,
                                                          seed * 7919);  // Consecutive seeds would have the same light.
        const Drawn needed = drawn(c, false);
        const Drawn everything = drawn(c, true);
        leftOut += needed.passes != everything.passes;
        ASSERT_EQ(needed.images.size(), everything.images.size());
        for (std::size_t i = 0; i < needed.images.size(); ++i)
            EXPECT_EQ(test::largestDifference(needed.images[i], everything.images[i]), 0)
                << "VITRINE_SCAN_SEED=" << seed << ", image " << i << ", seen from "
                << glm::to_string(c.frame.camera.eye) << " towards " << glm::to_string(c.frame.camera.target)
                << "\n  needed:     " << needed.passes << "\n  everything: " << everything.passes
                << "\n  left out:" << needed.leftOut;
    }
    EXPECT_GT(leftOut, 0) << "nothing was ever left out: this proves nothing";
}

std::vector<std::string> namesOfAll()
{
    std::vector<std::string> names{"hall"};
    for (const auto& exhibit : allExhibits()) names.emplace_back(exhibit->name());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Exhibits, RunEverything, testing::ValuesIn(namesOfAll()),
                         [](const auto& p) { return p.param; });

using HighJump = test::GlTest;

/// Furry bodies high in the air, in front of a camera that looks over their resting places.
TEST_F(HighJump, IsSeenWhereItIs)
{
    test::Shot shot;
    const std::size_t fur = *gallery().museum.find("fur");
    ParameterValues& values = shot.sceneState.values[fur];
    values.setParameter(*values.table().find("jump"), 8.0);
    values.setParameter(*values.table().find("frozenAt"), 0.7);
    const glm::dvec3 place(gallery().museum.worldFromExhibit(fur)[3]);
    shot.inHall().size(80, 45).see(place + glm::dvec3(0, 1.6, 5), place + glm::dvec3(0, 4.6, 0));
    shot.request.frame.subject.reset();
    shot.request.frame.camera.fovY = 0.87;
    const test::Picture needed = shot.take();
    shot.request.frame.runEverything = true;
    EXPECT_EQ(test::largestDifference(shot.take().image, needed.image), 0);
    shot.request.frame.runEverything = false;
    const test::Picture jumping = shot.take();
    values.setParameter(*values.table().find("frozenAt"), 0.0);
    EXPECT_GT(test::largestDifference(shot.take().image, jumping.image), 0.05) << "no body is in this picture";
}

}  // namespace
}  // namespace vitrine

// Plans of all shipped presets.

#include "tests/support/scenes_of_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace vitrine {
namespace {

using namespace test;

/// Returns the plans of all presets by name ("sdf_morph/glass"), seen from the preset's camera or the exhibit's best
/// view.
std::map<std::string, render::FramePlan> plansOfPresets(bool everything = false)
{
    std::map<std::string, render::FramePlan> plans;
    auto scenes = scenesOfPresets();
    for (auto& [name, scene] : scenes) {
        scene.request.runEverything = everything;
        scene.request.channels = {.normal = everything, .evaluations = everything};
        plans.emplace(name, scene.plan());
    }
    return plans;
}

TEST(PlansOfPresets, RunEachStepOnceInTheOrderOfTheStagesAndForAReason)
{
    const auto plans = plansOfPresets();
    EXPECT_GE(plans.size(), 11U);
    for (const auto& [name, plan] : plans) {
        std::set<std::string> names;
        render::PassPhase phase = render::PassPhase::simulate;
        for (const render::Pass& pass : plan.passes()) {
            EXPECT_TRUE(names.insert(pass.name).second) << name << " runs " << pass.name << " twice";
            EXPECT_GE(pass.phase, phase) << name << ": " << pass.name;
            phase = pass.phase;
            EXPECT_FALSE(pass.reason.empty()) << name << ": " << pass.name;
            EXPECT_FALSE(pass.bound.isZero()) << name << ": " << pass.name;
        }
        for (const render::CulledPass& step : plan.skipped()) {
            EXPECT_FALSE(names.contains(step.name)) << name << " runs and skips " << step.name;
            EXPECT_GE(step.reason.size(), 5U) << name << ": " << step.name;
        }
    }
}

TEST(PlansOfPresets, NameOnlyWhatTheyDeclare)
{
    for (const bool everything : {false, true})
        for (const auto& [name, plan] : plansOfPresets(everything))
            EXPECT_EQ(plan.errors(), std::vector<std::string>()) << name;
}

TEST(PlansOfPresets, LeaveOutWhatTheyDoNotShow)
{
    const auto plans = plansOfPresets();
    EXPECT_NE(plans.at("sdf_morph/facets").find("sdf_morph/mesh"), nullptr);
    EXPECT_EQ(plans.at("sdf_morph/old-gold").find("sdf_morph/mesh"), nullptr);
    EXPECT_NE(plans.at("sdf_morph/a-box-too-small").find("sdf_morph/box"), nullptr);
    EXPECT_EQ(plans.at("sdf_morph/glass").find("sdf_morph/box"), nullptr);
}

}  // namespace
}  // namespace vitrine

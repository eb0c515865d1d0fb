// Bounds without a picture: their arithmetic, and the bounds in plans. tests/exhibits/museum/bounds_test.cpp measures
// bounds in pictures.

#include "render/plan/frame_plan.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using namespace render;
using namespace test;

TEST(ContributionBound, IsInProportionToEveryFactor)
{
    const ContributionBound bound = boundOf(0.5, 3, {{0.5, "a"}, {4, "b"}});
    EXPECT_DOUBLE_EQ(bound.relative, 1);
    EXPECT_DOUBLE_EQ(bound.absolute, 6);
    EXPECT_FALSE(bound.isZero());
    EXPECT_TRUE(bound.whyNone.empty());
}

TEST(ContributionBound, OfNothingIsZeroWhateverItWouldBeAndTheFirstCauseIsTold)
{
    for (const double other : {1.0, double{INFINITY}, std::nan("")}) {
        const ContributionBound bound = boundOf(other, INFINITY, {{other, "there"}, {0, "first"}, {0, "second"}});
        EXPECT_TRUE(bound.isZero()) << other;
        EXPECT_EQ(bound.whyNone, "first");
    }
    EXPECT_TRUE(boundOf(1, 1, {{-2, "below zero"}}).isZero());
    // The plain product of infinity and 0 would be NaN: neither 0 nor a bound.
}

TEST(ContributionBound, WhatNobodyKnowsIsNotKnownAndNeverZero)
{
    EXPECT_FALSE(ContributionBound{}.isKnown());
    EXPECT_FALSE(ContributionBound{}.isZero());
    EXPECT_FALSE(boundOf(0, 1, {{std::nan(""), "a setting"}}).isKnown());
    EXPECT_EQ(toString(ContributionBound{}), "");
}

TEST(ContributionBound, ReadsAsASentence)
{
    EXPECT_EQ(toString(ContributionBound{0.4, 0.3, {}}),
              "changes a pixel by at most 40 % of its light and 0.3 of the light of white");
    EXPECT_EQ(toString(ContributionBound{0.4, 0, {}}), "changes a pixel by at most 40 % of its light");
    EXPECT_EQ(toString(ContributionBound{0, 0.25, {}}), "changes a pixel by at most 0.25 of the light of white");
    EXPECT_EQ(toString(ContributionBound{1, 0, {}}), "may change any pixel");
    EXPECT_EQ(toString(ContributionBound{0, 695, {}}), "may change any pixel");
    EXPECT_EQ(toString(ContributionBound{0, 0, "off"}), "changes nothing");
}

TEST(FramePlanNeeds, AnEffectOfBoundZeroIsListedAndLeftOutUnlessEverythingRuns)
{
    for (const bool everything : {false, true}) {
        FramePlan plan;
        plan.runEverything = everything;
        Pass pass;
        EXPECT_EQ(plan.includeIfEffective(pass, {"gone", boundOf(1, 0, {{0, "it is off"}})}), everything);
        EXPECT_TRUE(plan.includeIfEffective(pass, {"here", boundOf(1, 0, {})}));
        EXPECT_EQ(pass.effects.size(), everything ? 2U : 1U);
        EXPECT_EQ(plan.includeIfEffective(boundOf(0, 1, {{0, "too dark"}}), {"one", "two"}), everything);
        for (const auto& [name, reason] :
             {std::pair("gone", "it is off"), std::pair("one", "too dark"), std::pair("two", "too dark")}) {
            EXPECT_EQ(reasonFor(plan, name), everything ? "not in the plan" : reason) << name;
        }
    }
}

TEST(BoundsOfPlans, AHallWithoutLightHasNoProbeAndNoShadow)
{
    Scene scene;
    scene.hall().set(hallTable().sunStrength, 0.0);
    EXPECT_TRUE(test::runs(scene.plan(), "probe/")) << "the sky still shines";
    scene.hall().set(hallTable().skyStrength, 0.0);
    EXPECT_TRUE(test::runs(scene.plan(), "probe/")) << "the lamps of exhibits and pictures still do";
    scene.hall().set(hallTable().spotStrength, 0.0);
    for (const auto& [exhibit, row] :
         {std::pair("paper_lanterns", "hallGlow"), {"fur", "lamp"}, {"lenticular", "lamp"}}) {
        ParameterValues& values = scene.sceneState.values[test::museum().find(exhibit).value()];
        values.setParameter(values.table().find(row).value(), 0.0);
    }
    const FramePlan plan = scene.plan();
    EXPECT_EQ(reasonFor(plan, "probe"), "there is no light to reflect");
    EXPECT_TRUE(plan.findSkipped("probe")->boundIsZero);
    EXPECT_FALSE(plan.images().contains("probe"));
    EXPECT_EQ(plan.find("probe/sky/0"), nullptr);
    EXPECT_TRUE(plan.findSkipped("hall/shadow")->boundIsZero);
    scene.request.runEverything = true;
    EXPECT_NE(scene.plan().find("probe/sky/0"), nullptr);
}

TEST(BoundsOfPlans, GlassIsNotDarkenedByOcclusionSoThatNoneIsEvaluated)
{
    Scene scene;
    scene.object().set(sdfTable().ambientOcclusion, true);
    const auto occlusion = [&] {
        const FramePlan plan = scene.plan();
        const auto& effects = plan.find("sdf_morph/march")->effects;
        return std::any_of(effects.begin(), effects.end(),
                           [](const Effect& e) { return e.name == "sdf_morph/occlusion"; });
    };
    EXPECT_TRUE(occlusion());
    scene.object().set(sdfTable().material, SdfMaterial::glass);
    EXPECT_FALSE(occlusion());
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/occlusion"), "glass scatters nothing of the room's light");
    scene.object().set(sdfTable().heatMap, SdfHeatMap::evaluations);
    EXPECT_TRUE(occlusion()) << "a heat map shows what it costs";
}

TEST(BoundsOfPlans, EveryBoundThatIsStatedIsPositiveAndGrowsWithTheSun)
{
    Scene scene;
    const auto shadow = [&](double strength) {
        scene.hall().set(hallTable().sunStrength, strength);
        return scene.plan().find("hall/shadow")->bound.absolute;
    };
    EXPECT_NEAR(shadow(4), 4 * shadow(1), 1e-9);
    const FramePlan plan = scene.plan();
    for (const Pass& pass : plan.passes()) {
        EXPECT_FALSE(pass.bound.isZero()) << pass.name;
        EXPECT_GE(pass.bound.relative, 0) << pass.name;
        EXPECT_GE(pass.bound.absolute, 0) << pass.name;
        for (const Effect& effect : pass.effects) EXPECT_FALSE(effect.bound.isZero()) << effect.name;
    }
}

}  // namespace
}  // namespace vitrine

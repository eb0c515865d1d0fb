// Plans of all shipped presets.

#include "render/glsl/shader_source.h"
#include "tests/support/scenes_of_presets.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <set>

namespace vitrine {
namespace {

using namespace test;

/// Returns the plans of all presets by name ("sdf_morph/glass"), seen from the preset's camera or the exhibit's best
/// view.
const std::map<std::string, render::FramePlan>& plansOfPresets(bool everything = false)
{
    static std::array<std::map<std::string, render::FramePlan>, 2> made;  // Planned once for all tests of this file.
    auto& plans = made.at(everything ? 1 : 0);
    if (!plans.empty()) return plans;
    auto scenes = scenesOfPresets();
    for (auto& [name, scene] : scenes) {
        scene.request.runEverything = everything;
        scene.request.channels = {.normal = everything, .evaluations = everything, .albedo = everything};
        plans.emplace(name, scene.plan());
    }
    return plans;
}

TEST(LongPlansOfPresets, RunEachStepOnceInTheOrderOfTheStagesAndForAReason)
{
    const auto& plans = plansOfPresets();
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

/// Texts of one program, by their stage ("frag").
using ProgramTexts = std::map<std::string, std::string>;

/// Adds the complete texts of a program, and of the programs that stand in for it.
void addProgram(const render::ShaderKey& key, const render::ShaderSource& source, std::set<ProgramTexts>& programs)
{
    ProgramTexts texts;
    for (const auto& [stage, file] :
         {std::pair{"vert", key.vertex}, std::pair{"frag", key.fragment}, std::pair{"comp", key.compute}})
        if (!file.empty()) texts[stage] = source.load(file, key.defines, key.prelude, key.sources.get()).text;
    if (!texts.empty()) programs.insert(std::move(texts));
    for (const auto& other : {key.meanwhile, key.specialized})
        if (other) addProgram(*other, source, programs);
}

/// Returns what the reference compiler complains about in a program; empty if it accepts the stages and their links.
/// A process of the compiler for each program would take most of its time for its start.
std::string complaintAbout(const ProgramTexts& texts)
{
    const std::map<std::string, EShLanguage> stages{
        {"vert", EShLangVertex}, {"frag", EShLangFragment}, {"comp", EShLangCompute}};
    std::deque<glslang::TShader> shaders;  // Must outlive the program.
    glslang::TProgram program;
    for (const auto& [stage, text] : texts) {
        glslang::TShader& shader = shaders.emplace_back(stages.at(stage));
        const char* const lines = text.c_str();
        shader.setStrings(&lines, 1);
        if (!shader.parse(GetDefaultResources(), 110, false, EShMsgDefault)) return shader.getInfoLog();
        program.addShader(&shader);
    }
    return program.link(EShMsgDefault) ? std::string() : "link: " + std::string(program.getInfoLog());
}

TEST(LongPlansOfPresets, DrawWithProgramsThatTheReferenceCompilerAccepts)
{
    const render::ShaderSource source;
    std::set<ProgramTexts> programs;
    for (const bool everything : {false, true})
        for (const auto& [name, plan] : plansOfPresets(everything))
            for (const render::FramePlan& drawn : {plan, plan.withDeferredShading().value_or(plan)})
                for (const render::Pass& pass : drawn.passes()) addProgram(pass.shader, source, programs);
    ASSERT_GE(programs.size(), 100U);
    glslang::InitializeProcess();
    for (const ProgramTexts& texts : programs) EXPECT_EQ(complaintAbout(texts), "");
    // Controls: wrong programs are refused, each stage by itself and both together.
    const std::string head = "#version 450 core\n";
    EXPECT_NE(complaintAbout({{"frag", head + "void main() { undeclared = 1.0; }\n"}}).find("'undeclared'"),
              std::string::npos);
    const std::string writes =
        head + "layout(location = 0) out vec2 a;\nvoid main() { a = vec2(0); gl_Position = vec4(a, 0, 1); }\n";
    const std::string reads =
        head + "layout(location = 0) in vec3 a;\nlayout(location = 0) out vec4 c;\nvoid main() { c = vec4(a, 1); }\n";
    EXPECT_EQ(complaintAbout({{"vert", writes}, {"frag", reads}}).substr(0, 6), "link: ");
    glslang::FinalizeProcess();
}

TEST(PlansOfPresets, NameOnlyWhatTheyDeclare)
{
    for (const bool everything : {false, true})
        for (const auto& [name, plan] : plansOfPresets(everything))
            EXPECT_EQ(plan.errors(), std::vector<std::string>()) << name;
}

TEST(PlansOfPresets, LeaveOutWhatTheyDoNotShow)
{
    const auto& plans = plansOfPresets();
    EXPECT_NE(plans.at("sdf_morph/facets").find("sdf_morph/mesh"), nullptr);
    EXPECT_EQ(plans.at("sdf_morph/old-gold").find("sdf_morph/mesh"), nullptr);
    EXPECT_NE(plans.at("sdf_morph/a-box-too-small").find("sdf_morph/box"), nullptr);
    EXPECT_EQ(plans.at("sdf_morph/glass").find("sdf_morph/box"), nullptr);
}

}  // namespace
}  // namespace vitrine

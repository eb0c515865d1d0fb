// Plans of all shipped presets.

#include "render/glsl/shader_source.h"
#include "tests/support/scenes_of_presets.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

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

TEST(PlansOfPresets, DrawWithProgramsThatTheReferenceCompilerAccepts)
{
    const std::string compiler = VITRINE_GLSLANG;
    if (compiler.empty()) GTEST_SKIP() << "glslangValidator was not found when the build was configured";
    const render::ShaderSource source;
    std::set<ProgramTexts> programs;
    for (const bool everything : {false, true})
        for (const auto& [name, plan] : plansOfPresets(everything))
            for (const render::Pass& pass : plan.passes()) addProgram(pass.shader, source, programs);
    ASSERT_GE(programs.size(), 100U);
    ProgramTexts control;  // Must be refused.
    control["frag"] = "#version 450 core\nvoid main() { undeclared = 1.0; }\n";
    programs.insert(control);

    int failures = 0;
    for (const ProgramTexts& texts : programs) {
        const TemporaryFolder folder;
        std::string command = compiler + " -l";  // Links the stages, too.
        for (const auto& [stage, text] : texts) {
            std::ofstream(folder / ("program." + stage)) << text;
            command += " " + (folder / ("program." + stage)).string();
        }
        if (std::system((command + " > " + (folder / "log").string()).c_str()) == 0) continue;
        ++failures;
        std::stringstream log;
        log << std::ifstream(folder / "log").rdbuf();
        EXPECT_NE(log.str().find("'undeclared'"), std::string::npos) << log.str();
    }
    EXPECT_EQ(failures, 1);
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

// Files that a scene state names and that are missing: every plan works without them and reports it.

#include "exhibits/fur/fur_table.h"
#include "exhibits/lenticular/lenticular_table.h"
#include "exhibits/museum/named_files.h"
#include "render/files/assets.h"
#include "render/plan/diagnostics.h"
#include "tests/support/failures.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using test::museum;

/// Parameter that names a file, with a view in which the file matters.
struct FileScene : test::Scene {
    std::size_t exhibit;
    std::string parameter, label;

    FileScene(const char* name, const char* row, const char* shownAs)
        : exhibit(*museum().find(name)), parameter(row), label(shownAs)
    {
        if (exhibit != 0) see(museum().bestView(exhibit, sceneState.values[exhibit]));
    }
    FileScene& name(const std::filesystem::path& path)
    {
        sceneState.values[exhibit].setParameter(*sceneState.values[exhibit].table().find(parameter), path.string());
        return *this;
    }
    [[nodiscard]] std::vector<std::string> unreadable() const
    {
        std::vector<std::string> sentences;
        for (const render::CulledPass& complaint : render::Diagnostics().begun(plan().skipped()))
            if (!complaint.unreadable.empty()) sentences.push_back(lineOf(complaint));
        return sentences;
    }
    [[nodiscard]] double next() const { return test::nextChange(museum(), sceneState, request); }
};

std::vector<FileScene> scenes()
{
    return {{"hall", "environment", "Environment of The hall"},
            {"hall", "model", "Model of The hall"},
            {"fur", "ringModel", "Ring model of Fur with Physics"},
            {"lenticular", "frontPrint", "Front print of Lenticular Card"}};
}

TEST(MissingFiles, AreLeftOutOfThePlanWhichSaysWhichParameterNamesWhichFile)
{
    const test::TemporaryFolder folder;
    for (FileScene& scene : scenes()) {
        SCOPED_TRACE(scene.label);
        const std::vector<render::Pass> whole = scene.plan().passes();
        const double next = scene.next();
        for (const char* file : {"gone.glb", "noise.glb"}) {
            const std::filesystem::path path = folder / file;
            if (std::string(file) == "noise.glb") test::writeBytes(path, std::string(300, '\x17'));
            scene.name(path);
            render::FramePlan plan;
            ASSERT_NO_THROW(plan = scene.plan());
            EXPECT_EQ(plan.passes().size(), whole.size()) << "what is not there takes nothing with it";
            EXPECT_EQ(scene.next(), next);
            const std::vector<std::string> said = scene.unreadable();
            ASSERT_EQ(said.size(), 1U);
            EXPECT_EQ(said[0].rfind(scene.label + ": ", 0), 0U) << said[0];
            EXPECT_NE(said[0].find(path.string()), std::string::npos) << said[0];
            EXPECT_NE(said[0].find("until it can be read."), std::string::npos) << said[0];
        }
    }
}

TEST(MissingFiles, EndAPictureThatNeedsThem)
{
    const test::TemporaryFolder folder;
    for (FileScene& scene : scenes()) {
        SCOPED_TRACE(scene.label);
        scene.name(folder / "gone.glb").request.needsFiles = true;
        const std::string said = test::failureOf([&] { return scene.plan(); });
        EXPECT_EQ(said.rfind(scene.label + ": ", 0), 0U) << said;
    }
}

TEST(MissingFiles, AreDrawnWhenTheyComeBackAndLeftOutWhenTheyGo)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "bear.glb";
    for (const auto& [name, row] : {std::pair{"hall", "model"}, {"fur", "ringModel"}}) {
        SCOPED_TRACE(row);
        FileScene scene(name, row, "");
        const auto draws = [&] {
            std::size_t count = 0;
            const render::FramePlan plan = scene.plan();
            for (const render::Pass& pass : plan.passes())
                for (const render::Draw& draw : pass.draws) count += draw.mesh ? draw.mesh->vertices.size() : 0;
            return count;
        };
        scene.name({});
        const std::size_t without = draws();
        EXPECT_FALSE(namesFiles(scene.sceneState));
        scene.name(path);
        EXPECT_TRUE(namesFiles(scene.sceneState));
        EXPECT_EQ(draws(), without);
        const std::uint64_t before = stateOfFiles(museum().subjects(), scene.sceneState);
        EXPECT_EQ(stateOfFiles(museum().subjects(), scene.sceneState), before);
        std::filesystem::copy_file(render::asset("models/teddy.glb"), path);
        EXPECT_NE(stateOfFiles(museum().subjects(), scene.sceneState), before) << "whoever waits for it is not told";
        EXPECT_NE(draws(), without);
        EXPECT_TRUE(scene.unreadable().empty());
        std::filesystem::remove(path);
        EXPECT_EQ(draws(), without);
        EXPECT_EQ(scene.unreadable().size(), 1U);
    }
}

TEST(ChangedFiles, HaveWhatIsKeptOfThemDrawnAnew)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "picture.png";
    FileScene scene("hall", "environment", "");
    std::filesystem::copy_file(render::asset("frames/turning_mug/view_00.png"), path);
    scene.name(path);
    const render::PersistentState kept = test::keptAfter(scene.plan());
    EXPECT_FALSE(test::runs(scene.plan(kept), "probe/"));
    std::filesystem::remove(path);
    std::filesystem::copy_file(render::asset("frames/turning_mug/view_08.png"), path);
    EXPECT_TRUE(test::runs(scene.plan(kept), "probe/")) << "the probe shows the old picture";
}

}  // namespace
}  // namespace vitrine

// Plans of the exhibit, without a GPU: features that a scene lacks are left out, and unreadable files change nothing.

#include "exhibits/sdf_scenes/scene_reader.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "render/files/assets.h"
#include "shaders/lib/bindings.glsl"
#include "tests/support/museum_on_paper.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace vitrine {
namespace {

using namespace test;

const scenes::SdfScenesTable& table()
{
    static const scenes::SdfScenesTable made;
    return made;
}

/// Test scene with the exhibit showing a scene file, seen from the front of its frame.
struct Shown : test::Scene {
    std::size_t exhibit = *museum().find("sdf_scenes");
    std::vector<Message> unreadable;

    explicit Shown(const std::string& file = {})
    {
        values().set(table().scene, file);
        read();
        see(museum().bestView(exhibit, values()));
    }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[exhibit]; }
    void read()
    {
        TabledSceneState tabled = museum().readTables(sceneState);
        sceneState = std::move(tabled.sceneState);
        unreadable = std::move(tabled.unreadable);
    }
    [[nodiscard]] bool defines(std::string_view word) const
    {
        const render::FramePlan made = plan();
        const render::Pass* pass = made.find("sdf_scenes/scene");
        return pass && std::any_of(pass->shader.defines.begin(), pass->shader.defines.end(),
                                   [&](const std::string& define) { return define.starts_with(word); });
    }
};

TEST(SceneExhibit, HasAButtonOnlyWhereSomethingMoves)
{
    Shown moving(render::asset("scenes/waves.json").string()), still(render::asset("scenes/box.json").string());
    const auto& button = *capability<HasButton>(museum().subject(moving.exhibit));
    EXPECT_EQ(button.whyDisabled(moving.values()), Message());
    EXPECT_EQ(button.whyDisabled(still.values()), "Nothing in this scene moves with time; choose another scene.");
}

TEST(SceneExhibit, SeesAllOfASceneThatNamesNoCamera)
{
    const auto shownOf = [](const std::string& root, const std::string& head = "") {
        return scenes::shownScene(
            scenes::readScene(R"({"format": "vitrine-scene", "version": 1, )" + head + R"("root": )" + root + "}",
                              "a.json", {})
                .scene);
    };
    for (const double size : {0.001, 0.05, 1.0, 5.0, 1000.0})
        for (const double aside : {0.0, 7.0}) {
            const std::string s = std::to_string(size), x = std::to_string(aside * size);
            const auto shown = shownOf(R"({"kind": "box", "size": [)" + s + ", " + s + ", " + s +
                                       R"(], "translate": [)" + x + ", 0, 0]}");
            const std::vector<double> numbers = shown->scene->numbersAt(0);
            const scenes::SceneCamera camera = scenes::sceneCamera(*shown->scene, numbers, 0);
            const glm::dvec3 middle(aside * size, 0, 0);
            const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
            double widest = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p = middle + 0.5 * size *
                                                  glm::dvec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                                             (corner & 4) != 0 ? 1 : -1);
                const glm::dvec3 to = p - camera.eye;
                ASSERT_GT(glm::dot(to, ahead), 0);
                widest = std::max(widest, std::acos(glm::dot(glm::normalize(to), ahead)));
            }
            // All of it is visible, and fills a large part of the picture's height.
            EXPECT_LT(widest, 0.5 * camera.fovY) << size;
            EXPECT_GT(widest, 0.18 * camera.fovY) << size;
            const auto words = shown->program->words(numbers);
            EXPECT_GT(scenes::sceneStage(*shown, words, numbers).farthest, glm::length(camera.eye - middle) + size);
        }
    // A camera in the file is kept, and so is the usual one for an infinite scene.
    const std::string camera = R"("camera": {"position": [0, 0, 3], "target": [0, 0, 0]}, )";
    const auto own = shownOf(R"({"kind": "sphere", "radius": 200})", camera);
    EXPECT_EQ(scenes::sceneCamera(*own->scene, own->scene->numbersAt(0), 0).eye, glm::dvec3(0, 0, 3));
    const auto noise = shownOf(R"({"kind": "noise"})");
    EXPECT_EQ(scenes::sceneCamera(*noise->scene, noise->scene->numbersAt(0), 0).eye, glm::dvec3(0, 1.5, 5));
    // A small movement of a shape does not move the camera.
    const auto eyeFor = [&](const char* x) {
        const auto shown = shownOf(std::string(R"({"kind": "sphere", "radius": 1, "translate": [)") + x + ", 0, 0]}");
        return scenes::sceneCamera(*shown->scene, shown->scene->numbersAt(0), 0).eye;
    };
    EXPECT_EQ(eyeFor("0.3"), eyeFor("0.32"));
}

TEST(SceneExhibit, HasNothingInItsShaderThatTheSceneDoesNotContain)
{
    const Shown torus("torus.json"), ambient("ambient_occlusion.json"), still("still_life.json");
    EXPECT_FALSE(torus.defines("GLASS"));
    EXPECT_EQ(reasonFor(torus.plan(), "sdf_scenes/glass"), "nothing is made of glass");
    EXPECT_EQ(reasonFor(torus.plan(), "sdf_scenes/lamps"), "no light of the scene has an area");
    EXPECT_FALSE(ambient.defines("MIRRORS"));
    EXPECT_EQ(reasonFor(ambient.plan(), "sdf_scenes/reflections"), "nothing in the scene mirrors");
    for (const char* word : {"GLASS", "MIRRORS", "LAMPS", "LIGHTS", "SHADOWS"})
        EXPECT_TRUE(still.defines(word)) << word;
    Shown off("still_life.json");
    off.values().set(table().shadowMethod, scenes::SceneShadow::none);
    off.values().set(table().occlusionMethod, scenes::SceneOcclusion::none);
    EXPECT_FALSE(off.defines("SHADOWS"));
    EXPECT_FALSE(off.defines("OCCLUSION"));
    EXPECT_EQ(reasonFor(off.plan(), "sdf_scenes/occlusion"), "ambient occlusion is switched off");
}

TEST(SceneExhibit, HasASliderForEachParameterOfItsScene)
{
    Shown shown("mercury.json");
    const auto row = shown.values().table().find("cling");
    ASSERT_TRUE(row);
    const ParameterInfo& info = shown.values().rows()[*row];
    EXPECT_EQ(info.unit, Unit::meter);
    EXPECT_EQ(info.range.high, 1.2);
    EXPECT_EQ(info.group, "Mercury");
    EXPECT_FALSE(info.help.empty());
    const auto block = [&] { return shown.plan().find("sdf_scenes/scene")->blocks.at(BLOCK_EXHIBIT); };
    const render::Bytes before = block();
    shown.values().setParameter(*row, 0.1);
    EXPECT_NE(block(), before);
    // Another scene has other parameters, and keeps the values of common ones.
    shown.values().set(table().hitTolerance, 3.0);
    shown.values().set(table().scene, std::string("dahlia.json"));
    shown.read();
    EXPECT_FALSE(shown.values().table().find("cling"));
    EXPECT_TRUE(shown.values().table().find("bloom"));
    EXPECT_EQ(shown.values()[table().hitTolerance], 3);
}

TEST(SceneExhibit, AParameterThatIsCalledAsARowOfTheTableHasANameOfItsOwn)
{
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.json") << R"({"format": "vitrine-scene", "version": 1,
 "parameters": {"bounces": {"value": 1, "range": [0, 2]}}, "root": {"kind": "sphere", "radius": "1 m * bounces"}})";
    Shown shown((folder / "a.json").string());
    ASSERT_TRUE(shown.unreadable.empty()) << shown.unreadable.front();
    EXPECT_TRUE(shown.values().table().find("ownBounces"));
}

TEST(SceneExhibit, AFileThatCannotBeReadKeepsTheLastSceneAndIsReadAgain)
{
    const test::TemporaryFolder folder;
    const std::string path = (folder / "a.json").string();
    const auto write = [&](const std::string& root) {
        std::ofstream(path)
            << "{\"format\": \"vitrine-scene\", \"version\": 1,\n\"parameters\": {\"size\": {\"value\": 1, \"unit\": "
               "\"m\", \"range\": [0.1, 2]}},\n\"root\": " +
                   root + "}\n";
    };
    write(R"({"kind": "sphere", "radius": "size"})");
    Shown shown(path);
    ASSERT_TRUE(shown.unreadable.empty()) << shown.unreadable.front();
    shown.values().setParameter(*shown.values().table().find("size"), 1.5);
    const render::FramePlan good = shown.plan();
    write(R"({"kind": "sphere", "raduis": 1})");
    shown.read();
    ASSERT_EQ(shown.unreadable.size(), 1U);
    EXPECT_NE(shown.unreadable.front().english().find("a.json:3:"), std::string::npos) << shown.unreadable.front();
    EXPECT_NE(shown.unreadable.front().english().find("did you mean \"radius\"?"), std::string::npos)
        << shown.unreadable.front();
    const render::FramePlan kept = shown.plan();
    EXPECT_EQ(kept.find("sdf_scenes/scene")->shader, good.find("sdf_scenes/scene")->shader);
    EXPECT_EQ(kept.find("sdf_scenes/scene")->blocks, good.find("sdf_scenes/scene")->blocks);
    write(R"({"kind": "union", "children": [{"kind": "sphere", "radius": "size"}, {"kind": "box"}]})");
    shown.read();
    EXPECT_TRUE(shown.unreadable.empty());
    EXPECT_FALSE(shown.plan().find("sdf_scenes/scene")->shader == good.find("sdf_scenes/scene")->shader);
    EXPECT_EQ(std::get<double>(shown.values().row(*shown.values().table().find("size"))), 1.5) << "sliders stay";
}

TEST(SceneExhibit, OutOfViewItPlansNothing)
{
    Shown shown;
    const glm::dvec3 eye = shown.request.camera.eye;
    shown.see(eye, 2.0 * eye - shown.request.camera.target);
    EXPECT_EQ(shown.plan().find("sdf_scenes/scene"), nullptr);
    EXPECT_EQ(reasonFor(shown.plan(), "sdf_scenes"), "out of view");
}

TEST(SceneExhibit, EveryShippedSceneIsSeenFromItsOwnCamera)
{
    for (const char* name : {"torus", "primitives", "environment_mapping_1", "mercury", "dahlia"}) {
        Shown shown(std::string(name) + ".json");
        const auto& scene = *static_cast<const scenes::SdfScenesTable&>(shown.values().table()).shown;
        const scenes::SceneCamera camera = scenes::sceneCamera(*scene.scene, scene.scene->numbersAt(0), 0);
        const render::Camera view = museum().exhibit(shown.exhibit).bestView(shown.values());
        const Portal portal = scenes::scenePortal(camera, scene.toOpening);
        const glm::dvec3 eye(portal.workFromExhibit * glm::dvec4(view.eye, 1));
        const glm::dvec3 ahead(portal.workFromExhibit * glm::dvec4(view.target - view.eye, 0));
        EXPECT_LT(glm::distance(eye, camera.eye), 1e-9) << name;
        EXPECT_GT(glm::dot(glm::normalize(ahead), glm::normalize(camera.target - camera.eye)), 1 - 1e-12) << name;
        // The opening clips nothing of the camera's view.
        EXPECT_LE(scene.toOpening, scenes::SceneField(scene.scene).distance(camera.eye) + 1e-9) << name;
        const render::Camera round = {camera.eye, camera.target, camera.fovY};
        const scenes::SceneCamera turned = scenes::sceneCamera(*scene.scene, scene.scene->numbersAt(0), 1.0);
        EXPECT_NEAR(glm::distance(turned.eye, turned.target), glm::distance(round.eye, round.target), 1e-9) << "E15";
    }
}

TEST(SceneExhibit, OnlyWhatMovesIsDrawnAgain)
{
    Shown still("torus.json"), moving("mercury.json");
    const Exhibit& exhibit = museum().exhibit(still.exhibit);
    still.values().set(table().animate, true);
    EXPECT_EQ(exhibit.nextChange(still.values(), 1), std::numeric_limits<double>::infinity());
    EXPECT_EQ(exhibit.nextChange(moving.values(), 1), std::numeric_limits<double>::infinity());
    moving.values().set(table().animate, true);
    EXPECT_EQ(exhibit.nextChange(moving.values(), 1), 0);
    still.values().set(table().orbitSpeed, 0.1);
    EXPECT_EQ(exhibit.nextChange(still.values(), 1), 0);
}

TEST(SceneExhibit, WithoutTheSceneThatIsThereAtFirstShowsASphereAndSaysWhy)
{
    render::AssetStore assets;
    EXPECT_EQ(scenes::SdfScenes().dynamicParameters(table().initial(), assets).why, "");
    const test::TemporaryFolder folder;
    const scenes::SdfScenes alone(folder.path() / "mercury.json");
    const std::string why = alone.dynamicParameters(alone.parameters().initial(), assets).why.english();
    EXPECT_NE(why.find("mercury.json"), std::string::npos) << why;
    EXPECT_TRUE(why.ends_with('.')) << why;
    EXPECT_GT(alone.bestView(alone.parameters().initial()).fovY, 0);
}

}  // namespace
}  // namespace vitrine

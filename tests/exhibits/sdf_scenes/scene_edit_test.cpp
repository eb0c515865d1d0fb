// Saving scenes: unedited parts keep their text, and written ones can be read again.

#include "render/files/json_text.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include "render/files/number_text.h"
#include "render/files/read_file.h"

#include <filesystem>

namespace vitrine {
namespace {

using render::JsonText;

const std::string sceneOfTwo = "{\"format\" : \"vitrine-scene\",\"version\":1,\n"
                               "\t\"root\": { \"kind\":\"union\",   \"children\": [\n"
                               "      {\"kind\": \"sphere\", \"radius\": 0.50},\n"
                               "      {\"kind\": \"box\"}  ] } }\n\n";

TEST(SceneEdit, AChangedNumberChangesNothingElse)
{
    const JsonText text(sceneOfTwo, "a.json");
    std::string expected = sceneOfTwo;
    expected.replace(expected.find("0.50"), 4, "0.75");
    EXPECT_EQ(text.withValue(text.at("root.children[0].radius").value(), "0.75"), expected);
}

TEST(SceneEdit, EveryEditIsReadAgainAndCanBeTakenBack)
{
    const JsonText text(sceneOfTwo, "a.json");
    const std::string added = text.withMember(text.at("root.children[1]").value(), "material", "\"red\"");
    EXPECT_NE(added.find("{\"kind\": \"box\", \"material\": \"red\"}"), std::string::npos) << added;
    const JsonText withMaterial(added, "a.json");
    EXPECT_EQ(withMaterial.without(withMaterial.at("root.children[1].material").value()), sceneOfTwo);

    const std::string longer = text.withElement(text.at("root.children").value(), 2, "{\"kind\": \"torus\"}");
    EXPECT_NE(longer.find("{\"kind\": \"box\"},\n      {\"kind\": \"torus\"}  ]"), std::string::npos) << longer;
    const JsonText three(longer, "a.json");
    EXPECT_EQ(three.without(three.at("root.children[2]").value()), sceneOfTwo);
    EXPECT_EQ(test::readText(longer).scene->nodes.size(), 4U);

    const std::string before = text.withElement(text.at("root.children").value(), 0, "{\"kind\": \"torus\"}");
    EXPECT_NE(before.find("[\n      {\"kind\": \"torus\"},\n      {\"kind\": \"sphere\""), std::string::npos) << before;
    const JsonText first(before, "a.json");
    EXPECT_EQ(first.without(first.at("root.children[0]").value()), sceneOfTwo);
}

TEST(SceneEdit, WrappingANodeKeepsItsText)
{
    const JsonText text(sceneOfTwo, "a.json");
    const std::uint32_t node = text.at("root.children[0]").value();
    const std::string wrapped =
        text.withValue(node, "{\"kind\": \"round\", \"child\": " + std::string(text.written(node)) + "}");
    EXPECT_NE(wrapped.find("\"child\": {\"kind\": \"sphere\", \"radius\": 0.50}}"), std::string::npos);
    ASSERT_TRUE(test::readText(wrapped).scene);
}

/// Loading, saving and loading gives the same text; also after writing every number of every scene with another value
/// and back.
TEST(SceneEdit, RoundTripsEveryNumberOfTheShippedScenes)
{
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes")) {
        if (entry.path().filename() == "scene.schema.json") continue;
        const std::string original = render::readFile(entry.path(), 1U << 20U);
        const scenes::ReadScene read = test::readText(original);
        ASSERT_TRUE(read.scene) << test::findingsText(read);
        const JsonText& text = *read.scene->files.front().text;
        EXPECT_EQ(text.text(), original);
        for (std::uint32_t i = 0; i < text.values().size(); ++i) {
            EXPECT_EQ(text.at(text.path(i)), i);
            if (text.value(i).type != render::JsonSpan::Type::number) continue;
            const std::string changed = text.withValue(i, "0.3125");
            const JsonText other(changed, "b.json");
            EXPECT_EQ(other.number(i), 0.3125);
            EXPECT_EQ(other.withValue(i, text.written(i)), original);
        }
    }
}

TEST(SceneEdit, RandomTreesSurviveRandomEdits)
{
    test::Random random(51);
    for (int sample = 0; sample < 300; ++sample) {
        const std::string original = test::sceneText(test::randomTree(random, 3));
        const JsonText text(original, "a.json");
        // A member is removed from a node and appended to it again: the scene is the same.
        const auto scene = test::readText(original).scene;
        const scenes::Node& node =
            scene->nodes[static_cast<std::size_t>(random.below(static_cast<int>(scene->nodes.size())))];
        const std::vector<std::uint32_t> members = text.children(node.origin.value);
        const std::uint32_t member = members[static_cast<std::size_t>(random.below(static_cast<int>(members.size())))];
        const std::string key = text.key(member);
        const std::string path = text.path(node.origin.value);
        const JsonText shorter(text.without(member), "a.json");
        const std::string again = shorter.withMember(shorter.at(path).value(), key, text.written(member));
        const scenes::ReadScene read = test::readText(again);
        ASSERT_TRUE(read.scene) << again;
        const scenes::SceneField before(scene);
        const scenes::SceneField after(read.scene);
        for (int i = 0; i < 10; ++i) {
            const glm::dvec3 p = random.point(2);
            ASSERT_EQ(before.distance(p), after.distance(p));
        }
    }
}

}  // namespace
}  // namespace vitrine

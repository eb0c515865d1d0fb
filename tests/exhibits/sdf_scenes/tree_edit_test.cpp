// Edits of a scene's tree: each result can be read, has the intended effect, and leaves the rest of the text unchanged.

#include "exhibits/sdf_scenes/record_kinds.h"
#include "exhibits/sdf_scenes/scene_edit.h"
#include "render/failure.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include <algorithm>

namespace vitrine {
namespace {

using render::JsonText;
using scenes::EditedScene;
using scenes::findKind;
using scenes::NodeKind;
using scenes::SceneEdit;

const std::string sceneOfThree =
    test::sceneText("{ \"kind\":\"union\",   \"children\": [\n"
                    "      {\"kind\": \"sphere\", \"name\": \"ball\", \"radius\": 0.50},\n"
                    "      {\"kind\": \"box\", \"translate\": [1, 0, 0]},\n"
                    "      {\"kind\": \"round\", \"radius\": 0.1, \"child\": {\"kind\": \"torus\"}}  ] }");

std::shared_ptr<const scenes::Scene> readAgain(const std::string& text)
{
    const scenes::ReadScene read = test::readText(text);
    EXPECT_TRUE(read.scene) << test::findingsText(read) << '\n' << text;
    return read.scene;
}

/// Returns the largest difference of two scenes' distances at random points.
double largestDifference(const std::string& a, const std::string& b)
{
    const scenes::SceneField before(readAgain(a)), after(readAgain(b));
    test::Random random(7);
    double largest = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 p = random.point(3);
        largest = std::max(largest, std::abs(before.distance(p) - after.distance(p)));
    }
    return largest;
}

std::string kindAt(const std::string& text, const std::string& path)
{
    const JsonText json(text, "a.json");
    const auto node = json.at(path);
    const auto kind = node ? json.member(*node, "kind") : std::nullopt;
    return kind ? json.string(*kind) : std::string();
}

TEST(TreeEdit, EveryKindCanBeAddedAndTakenAwayAgain)
{
    for (const NodeKind& kind : scenes::nodeKinds())
        for (const std::size_t before : {std::size_t{0}, std::size_t{1}, std::size_t{99}}) {
            const EditedScene added = SceneEdit(sceneOfThree).added("root", before, kind);
            EXPECT_EQ(kindAt(added.text, added.path), kind.name);
            (void)readAgain(added.text);
            const EditedScene again = SceneEdit(added.text).removed(added.path);
            EXPECT_EQ(again.text, sceneOfThree) << kind.name;
            EXPECT_EQ(again.path, "root");
        }
}

TEST(TreeEdit, ACopyHasANameOfItsOwnAndChangesNoDistance)
{
    const EditedScene copy = SceneEdit(sceneOfThree).duplicated("root.children[0]");
    EXPECT_EQ(copy.path, "root.children[1]");
    EXPECT_EQ(largestDifference(sceneOfThree, copy.text), 0);
    EXPECT_EQ(readAgain(copy.text)->nodes[2].name, "ball 2");
    EXPECT_NE(copy.text.find("{\"kind\": \"sphere\", \"name\": \"ball\", \"radius\": 0.50}"), std::string::npos);
    EXPECT_EQ(readAgain(SceneEdit(copy.text).duplicated("root.children[0]").text)->nodes[2].name, "ball 3");
    // Only where there is space for a copy.
    for (const std::string node : {"root", "root.children[2].child"}) {
        const EditedScene both = SceneEdit(sceneOfThree).duplicated(node);
        EXPECT_EQ(both.path, node + ".children[1]");
        EXPECT_EQ(kindAt(both.text, node), "union");
        EXPECT_EQ(largestDifference(sceneOfThree, both.text), 0);
    }
}

TEST(TreeEdit, WhatIsWrappedCanBeUnwrapped)
{
    for (const NodeKind& kind : scenes::nodeKinds()) {
        if (kind.form == scenes::Form::shape) continue;
        for (const std::string node : {"root", "root.children[1]", "root.children[2].child"}) {
            const EditedScene inside = SceneEdit(sceneOfThree).wrapped(node, kind);
            EXPECT_EQ(kindAt(inside.text, inside.path), kind.name);
            (void)readAgain(inside.text);
            if (kind.form == scenes::Form::pair) continue;
            EXPECT_EQ(SceneEdit(inside.text).unwrapped(inside.path).text, sceneOfThree) << kind.name;
        }
    }
}

TEST(TreeEdit, AnOperationThatWouldBeEmptyGoesWithItsLastChild)
{
    const EditedScene gone = SceneEdit(sceneOfThree).removed("root.children[2].child");
    EXPECT_EQ(gone.path, "root");
    EXPECT_EQ(readAgain(gone.text)->nodes.size(), 3U);
    // If one of a pair is removed, the other one stays.
    const std::string pair = SceneEdit(sceneOfThree).wrapped("root.children[1]", *findKind("morph")).text;
    const EditedScene left = SceneEdit(pair).removed("root.children[1].children[1]");
    EXPECT_EQ(left.text, sceneOfThree);
}

TEST(TreeEdit, MovingReordersAndReparents)
{
    const std::string unions = SceneEdit(sceneOfThree).wrapped("root.children[1]", *findKind("union")).text;
    const std::vector<std::string> nodes{"root.children[0]", "root.children[1]", "root.children[2]"};
    for (const std::string& node : nodes)
        for (std::size_t to = 0; to <= 3; ++to) {
            const EditedScene moved = SceneEdit(unions).moved(node, "root", to);
            EXPECT_EQ(kindAt(moved.text, moved.path), kindAt(unions, node)) << node << " before " << to;
            EXPECT_EQ(readAgain(moved.text)->nodes.size(), readAgain(unions)->nodes.size());
            EXPECT_EQ(largestDifference(unions, moved.text), 0);
        }
    // Into a list behind it, in front of it, and out again.
    for (const std::string& node : {nodes[0], nodes[2]}) {
        const EditedScene in = SceneEdit(unions).moved(node, nodes[1], 0);
        EXPECT_EQ(kindAt(in.text, in.path), kindAt(unions, node));
        EXPECT_EQ(largestDifference(unions, in.text), 0);
        const EditedScene out = SceneEdit(in.text).moved(in.path, "root", node == nodes[0] ? 0 : 99);
        EXPECT_EQ(out.path, node);
        EXPECT_EQ(largestDifference(unions, out.text), 0);
    }
}

TEST(TreeEdit, AnotherKindKeepsWhatItHasToo)
{
    const std::string sized =
        test::sceneText("{\"kind\": \"union\", \"blend\": \"cubic\", \"blendWidth\": 0.2, \"children\": ["
                        "{\"kind\": \"box\", \"size\": [1, 2, 3], \"translate\": [1, 0, 0]},"
                        "{\"kind\": \"sphere\", \"radius\": 0.4}]}");
    const std::string rounded = SceneEdit(sized).ofKind("root.children[0]", *findKind("roundBox")).text;
    EXPECT_NE(rounded.find("{\"kind\": \"roundBox\", \"size\": [1, 2, 3], \"translate\": [1, 0, 0]}"),
              std::string::npos)
        << rounded;
    (void)readAgain(rounded);
    EXPECT_EQ(SceneEdit(rounded).ofKind("root.children[0]", *findKind("box")).text, sized);
    const std::string cut = SceneEdit(sized).ofKind("root", *findKind("intersection")).text;
    EXPECT_NE(cut.find("\"blend\": \"cubic\", \"blendWidth\": 0.2"), std::string::npos);
    // Every shape can become any other, and every operation any other of one child.
    const std::string one = test::sceneText("{\"kind\": \"union\", \"children\": [{\"kind\": \"sphere\"}]}");
    for (const NodeKind& from : scenes::nodeKinds())
        for (const NodeKind& to : scenes::nodeKinds()) {
            if (from.form == scenes::Form::pair || to.form == scenes::Form::pair ||
                (from.form == scenes::Form::shape) != (to.form == scenes::Form::shape))
                continue;
            test::Random random(3);
            const std::string text =
                from.form == scenes::Form::shape
                    ? test::sceneText(test::randomNode(from, random))
                    : SceneEdit(test::sceneText("{\"kind\": \"sphere\"}")).wrapped("root", from).text;
            const EditedScene other = SceneEdit(text).ofKind("root", to);
            EXPECT_EQ(kindAt(other.text, "root"), to.name);
            if (from.form == scenes::Form::shape) continue;
            (void)readAgain(other.text);
        }
}

TEST(TreeEdit, SoloShowsOneNodeAndAllShownTheRest)
{
    const std::string nested = SceneEdit(sceneOfThree).wrapped("root.children[1]", *findKind("union")).text;
    const std::string crowded = SceneEdit(nested).added("root.children[1]", 1, *findKind("torus")).text;
    const EditedScene alone = SceneEdit(crowded).solo("root.children[1].children[0]");
    const std::string box = test::sceneText("{\"kind\": \"box\", \"translate\": [1, 0, 0]}");
    EXPECT_EQ(largestDifference(alone.text, box), 0);
    EXPECT_EQ(SceneEdit(alone.text).allShown().text, crowded);
    EXPECT_EQ(SceneEdit(alone.text).solo("root.children[1].children[0]").text, alone.text);
    const std::string hidden = SceneEdit(crowded).hidden("root.children[0]", true).text;
    EXPECT_GT(largestDifference(crowded, hidden), 0.01);
    EXPECT_EQ(SceneEdit(hidden).hidden("root.children[0]", false).text, crowded);
}

TEST(TreeEdit, NumbersAreWrittenInTheUnitOfTheFile)
{
    const scenes::Field& rotate = scenes::placeFields()[1];
    ASSERT_EQ(rotate.name, "rotate");
    const EditedScene turned =
        SceneEdit(sceneOfThree).withNumbers("root.children[1]", rotate, {0, 0, std::acos(-1.0) / 2});
    EXPECT_NE(turned.text.find("\"rotate\": [0, 0, 90]"), std::string::npos) << turned.text;
    const NodeKind& sphere = *findKind("sphere");
    const EditedScene large = SceneEdit(sceneOfThree).withNumbers("root.children[0]", sphere.fields[0], {0.75});
    std::string expected = sceneOfThree;
    expected.replace(expected.find("0.50"), 4, "0.75");
    EXPECT_EQ(large.text, expected);
    // All fields of all kinds are written so that reading gives the same values.
    test::Random random(5);
    for (const NodeKind& kind : scenes::nodeKinds()) {
        if (kind.form != scenes::Form::shape) continue;
        const std::string text = test::sceneText(test::randomNode(kind, random));
        const auto scene = readAgain(text);
        std::string changed = text;
        std::size_t number = scene->nodes[0].numbers;
        for (const scenes::Field& field : kind.fields) {
            std::vector<double> numbers(scenes::numbersOf(field.type));
            for (double& x : numbers) x = scene->numbers[number++].value;
            changed = SceneEdit(changed).withNumbers("root", field, numbers).text;
        }
        const auto again = readAgain(changed);
        for (std::size_t i = 0; i < kind.numbers(); ++i)
            EXPECT_NEAR(again->numbers[again->nodes[0].numbers + i].value,
                        scene->numbers[scene->nodes[0].numbers + i].value, 1e-12)
                << kind.name;
    }
}

TEST(TreeEdit, WhatMakesNoSenseIsRefusedInASentence)
{
    const SceneEdit edit(sceneOfThree);
    const std::vector<std::function<EditedScene()>> senseless{
        [&] { return edit.removed("root"); },
        [&] { return edit.removed("root.children[7]"); },
        [&] { return edit.renamed("materials", "x"); },
        [&] { return edit.added("root.children[0]", 0, *findKind("box")); },
        [&] { return edit.added("root.children[2]", 0, *findKind("box")); },
        [&] { return edit.wrapped("root.children[0]", *findKind("box")); },
        [&] { return edit.unwrapped("root"); },
        [&] { return edit.moved("root.children[2].child", "root", 0); },
        [&] { return edit.moved("root.children[0]", "root.children[1]", 0); },
        [&] { return edit.moved("root", "root", 0); },
        [&] { return edit.ofKind("root.children[0]", *findKind("union")); },
        [&] { return edit.ofKind("root", *findKind("sphere")); },
        [&] { return edit.ofKind("root", *findKind("round")); },
        [&] { return edit.ofKind("root", *findKind("morph")); },
        [&] {
            return SceneEdit(SceneEdit(edit.wrapped("root", *findKind("union")).text)
                                 .withNumbers("root", scenes::placeFields()[0], {1, 0, 0})
                                 .text)
                .unwrapped("root");
        }};
    for (std::size_t i = 0; i < senseless.size(); ++i) {
        try {
            (void)senseless[i]();
            ADD_FAILURE() << "number " << i << " was done";
        } catch (const Failure& failure) {
            EXPECT_EQ(std::string(failure.what()).back(), '.') << failure.what();
        }
    }
}

TEST(TreeEdit, RandomEditsOfRandomTreesAreReadAgain)
{
    test::Random random(77);
    int done = 0;
    for (int sample = 0; sample < 60; ++sample) {
        std::string text = test::sceneText(test::randomTree(random, 3));
        for (int step = 0; step < 8; ++step) {
            const auto scene = readAgain(text);
            ASSERT_TRUE(scene);
            const auto below = [&](std::size_t count) {
                return static_cast<std::size_t>(random.below(static_cast<int>(count)));
            };
            const JsonText& json = *scene->files[0].text;
            const std::string node = json.path(scene->nodes[below(scene->nodes.size())].origin.value);
            const std::string other = json.path(scene->nodes[below(scene->nodes.size())].origin.value);
            const NodeKind& kind = scenes::nodeKinds()[below(scenes::nodeKinds().size())];
            const SceneEdit edit(text);
            try {
                switch (random.below(7)) {
                case 0: text = edit.added(node, below(3), kind).text; break;
                case 1: text = edit.duplicated(node).text; break;
                case 2: text = edit.removed(node).text; break;
                case 3: text = edit.wrapped(node, *findKind("union")).text; break;
                case 4: text = edit.moved(node, other, below(3)).text; break;
                case 5: text = edit.solo(node).text; break;
                default: text = edit.renamed(node, "a \"name\"").text; break;
                }
                ++done;
            } catch (const Failure&) {
                // The edit is impossible for this node.
            }
        }
    }
    EXPECT_GT(done, 200);
}

}  // namespace
}  // namespace vitrine

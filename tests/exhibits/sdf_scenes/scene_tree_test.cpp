// Edits of the scene's tree: their effect on the document and on the shader.

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/museum/named_files.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "exhibits/sdf_scenes/scene_tree.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "render/failure.h"
#include "shaders/lib/bindings.glsl"
#include "tests/support/museum_on_paper.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <tuple>

namespace vitrine {
namespace {

using test::museum;

const std::string written = R"({"format": "vitrine-scene",   "version": 1,
 "parameters": {"gap": {"value": 1, "unit": "m", "range": [0, 3]}},
 "materials": {"red": {"model": "phong", "color": [1, 0, 0]}},
 "camera": {"position": [0, 0, 8], "target": [0, 0, 0], "fieldOfView": 40},
 "nodes": {"pair": {"kind": "union", "children": [{"kind": "sphere", "radius": 0.2}, {"kind": "box", "translate": [0, 0.6, 0]}]}},
 "root": { "kind":"union", "children": [
   {"kind": "sphere", "name": "ball",  "radius": 0.50},
   {"kind": "torus", "translate": ["gap", 0.25, 0], "rotate": [90, 0, 0]},
   {"kind": "instance", "of": "pair", "translate": [-1.5, 0, 0]},
   {"kind": "round", "radius": 0.1, "child": {"kind": "box", "translate": [0, 1.5, 0]}}
 ]}}
)";

/// Test scene with the exhibit showing its own scene.
struct Edited : test::Scene {
    test::TemporaryFolder folder;
    std::size_t exhibit = *museum().find("sdf_scenes");
    render::AssetStore assets = museum().assets();
    std::vector<Message> unreadable;

    explicit Edited(const std::string& text = written)
    {
        std::ofstream(path()) << text;
        values().set(row().scene, path());
        read();
        see(museum().bestView(exhibit, values()));
    }
    [[nodiscard]] std::string path() const { return (folder / "a.json").string(); }
    [[nodiscard]] const scenes::SdfScenes& shown() const
    {
        return static_cast<const scenes::SdfScenes&>(museum().exhibit(exhibit));
    }
    [[nodiscard]] const scenes::SdfScenesTable& row() const { return shown().parameters(); }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[exhibit]; }
    void read()
    {
        TabledSceneState tabled = museum().readTables(sceneState);
        sceneState = std::move(tabled.sceneState);
        unreadable = std::move(tabled.unreadable);
    }
    std::string edit(const TreeEdit& wanted)
    {
        EditedTree made = shown().edited(values(), wanted, assets);
        values() = made.values;
        return made.node;
    }
    void set(const char* node, const char* name, const Value& value)
    {
        const TreeParameters rows = shown().parametersOf(values(), node).value();
        values() = shown().withParameter(values(), node, rows.values.table().find(name).value(), value, assets);
    }
    [[nodiscard]] Value number(const char* node, const char* name)
    {
        const TreeParameters rows = shown().parametersOf(values(), node).value();
        return rows.values.row(rows.values.table().find(name).value());
    }
    [[nodiscard]] std::string text() { return values()[row().document]; }
    [[nodiscard]] render::Pass pass() const { return *plan().find("sdf_scenes/scene"); }
    [[nodiscard]] ExhibitState state() { return {values()}; }
    /// Returns the ray from the scene's camera to a point of the scene, in the exhibit's space.
    [[nodiscard]] render::Ray towards(const glm::dvec3& point)
    {
        const auto& table = static_cast<const scenes::SdfScenesTable&>(values().table());
        const std::vector<double> numbers = table.shown->scene->numbersAt(0);
        const Portal portal =
            scenes::scenePortal(scenes::sceneCamera(*table.shown->scene, numbers, 0), table.shown->toOpening);
        const glm::dmat4 back = glm::inverse(portal.workFromExhibit);
        const glm::dvec3 eye(back * glm::dvec4(0, 0, 8, 1));
        return {eye, glm::normalize(glm::dvec3(back * glm::dvec4(point, 1)) - eye)};
    }
};

std::vector<std::string> idsOf(const Tree& tree)
{
    std::vector<std::string> ids;
    for (const TreeNode& node : tree.nodes) ids.push_back(node.id);
    return ids;
}

TEST(SceneTree, HasTheNodesOfTheFileAndItsDefinitions)
{
    Edited e;
    ASSERT_TRUE(e.unreadable.empty()) << e.unreadable.front();
    const Tree tree = e.shown().tree(e.values());
    EXPECT_EQ(idsOf(tree), (std::vector<std::string>{"root", "root.children[0]", "root.children[1]", "root.children[2]",
                                                     "root.children[3]", "root.children[3].child", "nodes.pair",
                                                     "nodes.pair.children[0]", "nodes.pair.children[1]"}));
    EXPECT_EQ(Tree::title(tree.nodes[1]), "ball");
    EXPECT_EQ(tree.nodes[3].kind, "instance of pair");
    EXPECT_EQ(tree.nodes[5].parent, 4U);
    EXPECT_FALSE(tree.nodes[5].movable) << "the operation would be left without a child";
    EXPECT_TRUE(tree.nodes[1].movable);
    EXPECT_TRUE(tree.nodes[0].takesChildren);
    EXPECT_FALSE(tree.nodes[4].takesChildren);
    EXPECT_TRUE(tree.nodes[6].shared);
    EXPECT_EQ(tree.nodes[6].name, "pair");
    EXPECT_GT(tree.kinds.size(), 40U);
}

TEST(SceneTree, ANodesNumbersAreRowsInTheirUnits)
{
    Edited e;
    EXPECT_EQ(e.number("root.children[0]", "radius"), Value(0.5));
    EXPECT_NEAR(std::get<double>(e.number("root.children[1]", "rotateX")), std::acos(-1.0) / 2, 1e-12);
    EXPECT_EQ(e.number("root.children[1]", "translateX"), Value(1.0)) << "computed from gap";
    const TreeParameters torus = e.shown().parametersOf(e.values(), "root.children[1]").value();
    EXPECT_NE(torus.note.find("Expressions: translate x."), std::string::npos) << torus.note;
    EXPECT_TRUE(e.shown().parametersOf(e.values(), "root.children[0]").value().note.empty());
    EXPECT_FALSE(e.shown().parametersOf(e.values(), "root.children[9]"));
    const ParameterInfo& radius = torus.values.rows()[torus.values.table().find("rotateX").value()];
    EXPECT_EQ(radius.unit, Unit::degree);
}

/// The same drag changes a small sphere and a large one by the same factor.
TEST(SceneTree, SlidersOfSizesAreLogarithmic)
{
    Edited e;
    for (const auto& [node, name, initial] :
         {std::tuple{"root.children[0]", "radius", 0.5}, std::tuple{"root.children[3].child", "sizeX", 1.0}}) {
        const TreeParameters rows = e.shown().parametersOf(e.values(), node).value();
        const Range range = rows.values.rows()[rows.values.table().find(name).value()].range;
        EXPECT_EQ(range.scale, Scale::logarithmic) << node;
        EXPECT_LE(range.softHigh / range.softLow, 64.0) << node;
        EXPECT_LT(range.softLow, initial) << node;
        EXPECT_GT(range.softHigh, initial) << node;
    }
    // Numbers that may be 0 or negative stay linear.
    const TreeParameters round = e.shown().parametersOf(e.values(), "root.children[3]").value();
    for (const char* name : {"radius", "translateX"})
        EXPECT_EQ(round.values.rows()[round.values.table().find(name).value()].range.scale, Scale::linear) << name;
}

TEST(SceneTree, ANumberChangesItsOwnTextAloneAndCompilesNothing)
{
    Edited e;
    const render::Pass before = e.pass();
    e.set("root.children[0]", "radius", 0.75);
    std::string expected = written;
    expected.replace(expected.find("0.50"), 4, "0.75");
    EXPECT_EQ(e.text(), expected);
    EXPECT_EQ(e.pass().shader, before.shader);
    EXPECT_NE(e.pass().blocks.at(BLOCK_EXHIBIT), before.blocks.at(BLOCK_EXHIBIT));
    // Editing one of three numbers keeps the other two, one of which is an expression.
    e.set("root.children[1]", "translateY", 0.5);
    EXPECT_NE(e.text().find("\"translate\": [\"gap\", 0.5, 0]"), std::string::npos) << e.text();
    EXPECT_EQ(e.pass().shader, before.shader);
    e.set("root.children[0]", "material", 1.0);
    EXPECT_NE(e.text().find("\"material\": \"red\""), std::string::npos) << e.text();
    EXPECT_FALSE(e.pass().shader == before.shader) << "another material is another program";
    e.set("root.children[0]", "material", 0.0);
    EXPECT_EQ(e.text().find("\"material\": \"red\""), std::string::npos) << e.text();
}

TEST(SceneTree, EveryChangeIsReadAgain)
{
    using enum TreeEdit::What;
    Edited e;
    const auto count = [&] { return e.shown().tree(e.values()).nodes.size(); };
    EXPECT_EQ(e.edit({add, "root", "cone"}), "root.children[4]");
    EXPECT_EQ(count(), 10U);
    EXPECT_EQ(e.edit({duplicate, "root.children[0]"}), "root.children[1]");
    EXPECT_EQ(e.edit({wrap, "root.children[1]", "twist"}), "root.children[1]");
    EXPECT_EQ(e.shown().tree(e.values()).nodes[2].kind, "twist");
    EXPECT_EQ(e.edit({unwrap, "root.children[1]"}), "root.children[1]");
    EXPECT_EQ(e.edit({move, "root.children[0]", "", "root", 3}), "root.children[2]");
    EXPECT_EQ(e.edit({rename, "root.children[2]", "egg"}), "root.children[2]");
    EXPECT_EQ(e.shown().tree(e.values()).nodes[3].name, "egg");
    e.edit({kind, "root.children[2]", "box"});
    EXPECT_EQ(e.shown().tree(e.values()).nodes[3].kind, "box");
    e.edit({solo, "root.children[2]"});
    EXPECT_TRUE(e.shown().tree(e.values()).nodes[1].hidden);
    EXPECT_FALSE(e.shown().tree(e.values()).nodes[3].hidden);
    e.edit({showAll, "root"});
    EXPECT_FALSE(e.shown().tree(e.values()).nodes[1].hidden);
    e.edit({hide, "root.children[2]"});
    EXPECT_TRUE(e.shown().tree(e.values()).nodes[3].hidden);
    const std::size_t before = count();
    e.edit({remove, "root.children[2]"});
    EXPECT_EQ(count(), before - 1);
}

TEST(SceneTree, WhatMakesNoSenseChangesNothing)
{
    using enum TreeEdit::What;
    Edited e;
    EXPECT_THROW(e.edit({remove, "root"}), Failure);
    EXPECT_THROW(e.edit({add, "root.children[0]", "cone"}), Failure);
    EXPECT_THROW(e.edit({add, "root", "blob"}), Failure);
    EXPECT_THROW(e.edit({hide, "root.children[17]"}), Failure);
    EXPECT_EQ(e.text(), "");
}

TEST(SceneTree, APointOfThePictureIsTheNodeThatShowsThere)
{
    Edited e;
    const auto pick = [&](const glm::dvec3& point) { return e.shown().pick(e.state(), e.towards(point)); };
    EXPECT_EQ(pick({0, 0, 0.5}), "root.children[0]");
    EXPECT_EQ(pick({0, 1.5, 0.5}), "root.children[3].child");
    EXPECT_EQ(pick({-1.5, 0, 0.2}), "root.children[2]") << "what an instance brings is the instance";
    EXPECT_EQ(pick({-3, -2, 0}), "");
    // Not through the wall beside the frame.
    render::Ray beside = e.towards({0, 0, 0.5});
    beside.origin += glm::dvec3(5, 0, 0);
    EXPECT_EQ(e.shown().pick(e.state(), beside), "");
}

TEST(SceneTree, TheShapeOfANodeIsSeenThroughWhatStandsBeforeIt)
{
    Edited e(R"({"format": "vitrine-scene", "version": 1, "camera": {"position": [0, 0, 8], "target": [0, 0, 0]},
 "root": {"kind": "subtraction", "children": [{"kind": "box", "size": [2, 2, 2]}, {"kind": "sphere", "radius": 0.5}]}})");
    ASSERT_TRUE(e.unreadable.empty()) << e.unreadable.front();
    const auto hole = e.shown().shapeOf(e.state(), "root.children[1]");
    ASSERT_TRUE(hole);
    EXPECT_TRUE(hole->isHit(e.towards({0.4, 0, 0})));
    EXPECT_FALSE(hole->isHit(e.towards({0.6, 0, 0})));
    EXPECT_TRUE(std::isfinite(hole->box.high.x));
    EXPECT_EQ(e.shown().pick(e.state(), e.towards({0.4, 0, 0})), "root.children[0]");
    EXPECT_FALSE(e.shown().shapeOf(e.state(), "root.children[7]"));
}

TEST(SceneTree, ThePlaceOfANodeGoesBackIntoItsNumbers)
{
    Edited e;
    TreePlace place = e.shown().placeOf(e.state(), "root.children[1]").value();
    EXPECT_EQ(place.translate, glm::dvec3(1, 0.25, 0));
    const TreePlace before = place;
    const render::ShaderKey shader = e.pass().shader;
    place.translate.y = 0.75;
    e.values() = e.shown().withPlace(e.values(), "root.children[1]", before, place, e.assets);
    EXPECT_NE(e.text().find("[\"gap\", 0.75, 0]"), std::string::npos) << e.text();
    EXPECT_NE(e.text().find("\"rotate\": [90, 0, 0]"), std::string::npos) << e.text();
    EXPECT_EQ(e.pass().shader, shader) << "what is dragged compiles nothing";
    // The center of the torus is at the position of its place.
    const TreePlace now = e.shown().placeOf(e.state(), "root.children[1]").value();
    const glm::dvec3 middle(now.exhibitFromParent * glm::dvec4(now.translate, 1));
    const render::Ray ray = e.towards({1, 0.75, 0});
    EXPECT_LT(glm::length(glm::cross(glm::normalize(middle - ray.origin), ray.direction)), 1e-9);
}

/// A small ball in an operation that bends space, and the displayed position of its center.
struct BentBall {
    std::shared_ptr<const scenes::ShownScene> shown;
    TreePlace place;

    BentBall(const std::string& operation, const glm::dvec3& at)
    {
        const std::string ball = "{\"kind\": \"sphere\", \"radius\": 0.06, \"translate\": [" + std::to_string(at.x) +
                                 ", " + std::to_string(at.y) + ", " + std::to_string(at.z) + "]}";
        const std::string text = "{\"format\": \"vitrine-scene\", \"version\": 1, \"root\": {" + operation +
                                 ", \"translate\": [0.3, -0.2, 0.1], \"rotate\": [20, 40, 0], \"child\": " + ball +
                                 "}}";
        scenes::ReadScene read = scenes::readScene(text, "bent", {});
        shown = scenes::shownScene(read.scene);
        place = scenes::placeInScene(*shown, shown->scene->numbersAt(0), scenes::nodeAt(*shown->scene, "root.child"));
    }
    [[nodiscard]] glm::dvec3 middle(const glm::dvec3& moved = glm::dvec3(0)) const
    {
        return glm::dvec3(place.exhibitFromParent * glm::dvec4(place.translate + moved, 1));
    }
    /// Returns the position without the effect of the operation.
    [[nodiscard]] glm::dvec3 withoutTheOperation() const
    {
        const std::vector<double> numbers = shown->scene->numbersAt(0);
        return glm::dvec3(scenes::placeInScene(*shown, numbers, 0).rotation() * place.translate) +
               glm::dvec3(0.3, -0.2, 0.1);
    }
    [[nodiscard]] double distance(const glm::dvec3& p) const { return scenes::SceneField(shown->scene).distance(p); }
};

TEST(SceneTree, HandlesStandWhereOperationsThatBendSpaceShowTheirNode)
{
    struct Case {
        const char* operation;
        glm::dvec3 at;
        bool elsewhere = true;  ///< Not at the position without the operation.
        int dragged = 0;        ///< First axis along which space is smooth there.
    };
    const Case cases[] = {
        {R"("kind": "twist", "rate": 90)", {0.7, 0.9, 0.2}},
        {R"("kind": "twist", "rate": -400)", {0.5, 1.3, -0.4}},
        {R"("kind": "bend", "rate": 40)", {0.8, 0.5, 0.1}},
        {R"("kind": "repeat", "spacing": [1, 0, 0], "count": [2, 1, 1])", {0.1, 0.3, 0.2}},
        {R"("kind": "repeat", "spacing": [1, 1, 0], "count": [0, 0, 1])", {0.1, 0.3, 0.2}, false},
        {R"("kind": "repeatAround", "count": 5)", {0.6, 0.2, 0.3}, false},
        {R"("kind": "elongate", "size": [0.8, 0, 0])", {0.3, 0.2, 0}},
        {R"("kind": "elongate", "size": [0.8, 0, 0])", {0, 0.2, 0.1}, false, 1},
        {R"("kind": "revolve", "offset": 0.5)", {0.4, 0.3, 0}},
        {R"("kind": "mirror", "x": true)", {0.4, 0.2, 0.1}, false},
        {R"("kind": "round", "radius": 0.02)", {0.4, 0.2, 0.1}, false},
    };
    for (const Case& c : cases) {
        const BentBall ball(c.operation, c.at);
        ASSERT_EQ(ball.place.without, "") << c.operation;
        EXPECT_LT(ball.distance(ball.middle()), -0.01) << c.operation;
        if (c.elsewhere) {
            EXPECT_GT(ball.distance(ball.withoutTheOperation()), 0) << "control: " << c.operation;
        }
        // After a small drag along each axis, the ball is at the handle.
        for (int axis = c.dragged; axis < 2; ++axis) {
            glm::dvec3 moved(0);
            moved[axis] = 0.01;
            const BentBall after(c.operation, c.at + moved);
            EXPECT_LT(glm::distance(after.middle(), ball.middle(moved)), 0.002) << c.operation << ' ' << axis;
            EXPECT_LT(after.distance(ball.middle(moved)), -0.01) << c.operation << ' ' << axis;
        }
    }
}

TEST(SceneTree, HandlesOfWhatIsSeenNowhereAreSaidToBeImpossible)
{
    EXPECT_NE(BentBall(R"("kind": "mirror", "x": true)", {-0.4, 0.2, 0.1}).place.without.find("\"mirror\""),
              std::string::npos);
    EXPECT_NE(BentBall(R"("kind": "extrude", "height": 1)", {0.4, 0.2, 0.1}).place.without, "");
    EXPECT_EQ(BentBall(R"("kind": "extrude", "height": 1)", {0.4, 0.2, 0}).place.without, "") << "control";
    Edited e(R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "mirror", "x": true, "child":
 {"kind": "sphere", "translate": [-1, 0, 0]}}})");
    EXPECT_NE(e.shown().placeOf(e.state(), "root.child").value().without, "");
    EXPECT_NE(e.shown().parametersOf(e.values(), "root.child").value().note.find("No handles"), std::string::npos);
    EXPECT_EQ(e.shown().parametersOf(e.values(), "root").value().note, "");
}

TEST(SceneTree, KnowsItsFilesAndWhoseTheyAre)
{
    Edited e;
    EXPECT_TRUE(e.shown().isDocument(written));
    EXPECT_FALSE(e.shown().isDocument(R"({"format": "vitrine-preset", "version": 1})"));
    EXPECT_FALSE(e.shown().isDocument("{"));
    EXPECT_EQ(e.shown().documentText(e.values()), written);
    EXPECT_EQ(e.shown().document(e.values()).path, e.path());
    EXPECT_TRUE(e.shown().document(e.values()).writable);
    for (const char* name : {"", "torus.json"}) {
        e.values().set(e.row().scene, std::string(name));
        EXPECT_FALSE(e.shown().document(e.values()).writable) << name;
        EXPECT_TRUE(std::filesystem::exists(e.shown().document(e.values()).path)) << name;
    }
}

TEST(SceneTree, ADocumentLargerThanAPresetMayHoldIsRefused)
{
    Edited e(R"({"format": "vitrine-scene", "version": 1, "about": ")" + std::string(1 << 16, 'a') +
             R"(", "root": {"kind": "sphere"}, "nodes": {)" +
             [] {
                 std::string nodes;
                 for (int i = 0; i < 20; ++i)
                     nodes += (i > 0 ? ", \"n" : "\"n") + std::to_string(i) + R"(": {"kind": "sphere", "about": ")" +
                              std::string(60'000, 'b') + "\"}";
                 return nodes;
             }() +
             "}}");
    ASSERT_TRUE(e.unreadable.empty()) << e.unreadable.front();
    EXPECT_THROW(e.set("root", "radius", 0.75), Failure);
    EXPECT_EQ(e.text(), "");
}

TEST(SceneTree, AnotherFileTakesTheDocumentWithItAndPresetsCarryIt)
{
    Edited e;
    e.set("root.children[0]", "radius", 0.75);
    ParameterValues loaded(e.row());
    std::vector<std::string> notes;
    for (const scenes::SdfScenesTable* table = &e.row(); const File parameter : {table->scene, table->document})
        loaded.setParameter(
            parameter.row,
            valueFromText(table->rows()[parameter.row],
                          render::writeJson(jsonFromValue(table->rows()[parameter.row], e.values().row(parameter.row))),
                          notes)
                .value());
    e.values() = loaded;
    e.read();
    EXPECT_EQ(e.number("root.children[0]", "radius"), Value(0.75));
    e.values().chooseFile(e.row().scene.row, e.path());
    EXPECT_NE(e.text(), "") << "the same file";
    e.values().chooseFile(e.row().scene.row, std::string("torus.json"));
    EXPECT_EQ(e.text(), "");
}

TEST(SceneTree, FilesThatItIncludesAreWatchedAndReadAgain)
{
    Edited e;
    std::filesystem::create_directory(e.folder / "parts");
    const auto part = [&](double radius) {
        std::ofstream(e.folder / "parts" / "b.json")
            << R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "sphere", "radius": )" << radius << "}}";
    };
    part(0.5);
    std::ofstream(e.path()) << R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "union", "children": [
 {"kind": "include", "file": "parts/b.json"}, {"kind": "box", "translate": [1, 0, 0]}]}})";
    e.read();
    ASSERT_TRUE(e.unreadable.empty()) << e.unreadable.front();
    const auto radius = [&] {
        const auto& scene = *static_cast<const scenes::SdfScenesTable&>(e.values().table()).shown->scene;
        return scene.numbersAt(0)[scene.nodes.at(2).numbers];
    };
    EXPECT_EQ(radius(), 0.5);
    for (const bool withDocument : {false, true}) {
        part(0.5);
        e.read();
        const std::uint64_t before = stateOfFiles(museum().subjects(), e.sceneState);
        const auto table = e.values().sharedTable();
        e.read();
        EXPECT_EQ(e.values().sharedTable(), table) << "nothing changed";
        part(0.8125);
        EXPECT_NE(stateOfFiles(museum().subjects(), e.sceneState), before);
        e.read();
        EXPECT_EQ(radius(), 0.8125);
        if (!withDocument) e.set("root.children[1]", "translateX", 2.0);
        EXPECT_FALSE(e.text().empty());
    }
    part(0.5);
    e.read();
    EXPECT_EQ(radius(), 0.5) << "of the document, too";
}

}  // namespace
}  // namespace vitrine

// Findings about invalid input: file, line, column, key, and what to do. No crash, whatever the depth and size.

#include "render/failure.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include <chrono>
#include <map>

namespace vitrine {
namespace {

std::string first(const std::string& text)
{
    const scenes::ReadScene read = test::readText(text);
    EXPECT_FALSE(read.scene) << text;
    return read.findings.empty() ? std::string() : read.findings.front().text().english();
}

/// Returns the first finding about a root that begins in line 3, column 9.
std::string about(const std::string& root, const std::string& head = "")
{
    return first(test::sceneText(root, head));
}

TEST(SceneReader, SaysWhereWhatAndWhatToDo)
{
    EXPECT_EQ(about(R"({"kind": "sphere", "radius": 0})"),
              "test.json:3:28: root.radius: this is 0 m; give 0.0001 m to 10000 m.");
    EXPECT_EQ(about(R"({"kind": "sphere", "radius": -1})"),
              "test.json:3:28: root.radius: this is -1 m; give 0.0001 m to 10000 m.");
    EXPECT_EQ(about(R"({"kind": "sphere", "radius": true})"),
              "test.json:3:28: root.radius: this must be a number in meters, or an expression such as \"12 mm\" or "
              "\"0.5 + 0.1 * sin(t)\".");
    EXPECT_EQ(about(R"({"kind": "sphere", "raduis": 1})"),
              "test.json:3:28: root.raduis: unknown key of a sphere: \"raduis\"; did you mean \"radius\"? Known are "
              "radius, kind, "
              "name, about, material, hidden, translate, rotate and scale.");
    EXPECT_EQ(about("{\"kind\": \"union\",\n  \"children\": [{\"kind\": \"sphere\"},\n    {\"kind\": \"spere\"}]}")
                  .substr(0, 90),
              "test.json:5:6: root.children[1].kind: unknown kind of node: \"spere\"; did you mean \"sphere\"");
    EXPECT_EQ(about(R"({"kind": "sphere", "material": "gold"})", R"("materials": {"old gold": {"model": "pbr"}},)"),
              "test.json:3:28: root.material: unknown material: \"gold\"; take one of old gold.");
}

TEST(SceneReader, RefusesWhatMakesNoShape)
{
    const std::pair<const char*, const char*> bad[] = {
        {R"({"kind": "box", "size": [1, 0, 1]})", "root.size[1]: this is 0 m"},
        {R"({"kind": "triangle", "a": [4, 3, 3], "b": [4, 3, 3], "c": [4, 3, 3]})", "it has no area"},
        {R"({"kind": "triangle", "a": [0, 0, 0], "b": [1, 1, 1], "c": [3, 3, 3]})", "it has no area"},
        {R"({"kind": "plane", "normal": [0, 0, 0]})", "a direction needs a number that is not 0"},
        {R"({"kind": "vesica", "start": [1, 1, 1], "end": [1, 1, 1]})", "start and end are the same point"},
        {R"({"kind": "cappedCone", "bottomRadius": 0, "topRadius": 0})", "both radii are 0"},
        {R"({"kind": "cutSphere", "radius": 1, "cut": -1})", "the cut leaves nothing"},
        {R"({"kind": "deathStar", "radius": 1, "holeRadius": 3, "offset": 1})", "the hole takes all of it"},
        {R"({"kind": "ellipsoid", "radii": [1, 1, 0.0001]})", "more than 1000 times"},
        {R"({"kind": "sphere", "scale": 0})", "root.scale: this is 0"},
        {R"({"kind": "sphere", "scale": [1, -1, 1]})", "root.scale[1]: this is -1"},
        {R"({"kind": "union", "children": []})", "root.children: a union needs \"children\""},
        {R"({"kind": "union"})", "a union needs \"children\""},
        {R"({"kind": "morph", "children": [{"kind": "box"}]})", "a morph needs two \"children\""},
        {R"({"kind": "round"})", "a round needs a \"child\""},
        {R"({"kind": "twist", "child": 3})", "a node must be an object"},
        {R"({})", "this node has no \"kind\""},
        {R"({"kind": 3})", "this must be a text in quotes"},
        {R"({"kind": "repeat", "spacing": [1, 0, 0], "count": [0, 1, 1], "child": {"kind": "plane"}})",
         "the child is so wide"},
        {R"({"kind": "repeatAround", "count": 1000, "child": {"kind": "box"}})",
         "the child is so wide that 1000 copies"}};
    for (const auto& [root, sentence] : bad)
        EXPECT_NE(about(root).find(sentence), std::string::npos) << root << '\n' << about(root);
}

TEST(SceneReader, RefusesExpressionsThatGiveNoNumber)
{
    const std::string head = R"("parameters": {"gap": {"value": 0.1, "unit": "m", "range": [0, 1]}},)";
    const std::pair<const char*, const char*> bad[] = {
        {"gap +", "this expression gives no number"},
        {"1 / 0", "this expression gives no number"},
        {"0 / 0", "this expression gives no number"},
        {"sqrt(0 - 1)", "this expression gives no number"},
        {"30 deg", "this expression gives no number"},
        {"gap * gap", "this expression gives no number"},
        {"gapp", "unknown parameter of the scene: \"gapp\"; did you mean \"gap\"?"},
        {"radius", "unknown parameter of the scene: \"radius\""},
        {"gap - 0.1", "this is 0 m; give 0.0001 m to 10000 m"},
        {"", "this expression gives no number"}};
    for (const auto& [expression, sentence] : bad) {
        const std::string root = std::string(R"({"kind": "sphere", "radius": ")") + expression + "\"}";
        EXPECT_NE(about(root, head).find(sentence), std::string::npos) << expression << '\n' << about(root, head);
    }
    const std::string deep = R"({"kind": "sphere", "radius": ")" + std::string(60000, '(') + "\"}";
    EXPECT_NE(about(deep).find("this expression gives no number"), std::string::npos);
}

TEST(SceneReader, ComputesNumbersFromTimeAndParameters)
{
    const auto scene = test::sceneOf(
        R"json({"kind": "sphere", "radius": "max(gap, 1 cm) * 2", "translate": ["sin(t)", "mod(t, 2)", "mix(gap, 1, 0.5)"], "rotate": [0, "90 * t", "spin"]})json",
        R"("parameters": {"gap": {"value": 30, "unit": "cm", "range": [0, 200]}, "spin": {"value": 45, "unit": "deg", "range": [0, 90]}},)");
    ASSERT_TRUE(scene);
    EXPECT_TRUE(scene->animated());
    const scenes::Node& node = scene->nodes.front();
    const std::vector<double> start = scene->numbersAt(0);
    EXPECT_NEAR(start[node.numbers], 0.6, 1e-12);
    EXPECT_NEAR(start[node.rotate + 2], std::acos(-1.0) / 4, 1e-12);
    const std::vector<double> later = scene->numbersAt(3, {0.5, 1});
    EXPECT_NEAR(later[node.numbers], 1, 1e-12);
    EXPECT_NEAR(later[node.translate], std::sin(3.0), 1e-12);
    EXPECT_NEAR(later[node.translate + 1], 1, 1e-12);
    EXPECT_NEAR(later[node.translate + 2], 0.75, 1e-12);
    EXPECT_NEAR(later[node.rotate + 1], 1.5 * std::acos(-1.0), 1e-12);
    // A slider's value is clamped to the parameter's range, and the number to its own.
    EXPECT_NEAR(scene->numbersAt(0, {99})[node.numbers], 4, 1e-12);
    EXPECT_NEAR(scene->numbersAt(0, {-5})[node.numbers], 0.02, 1e-12);
}

TEST(SceneReader, RefusesParametersThatCannotBeNamed)
{
    const std::string ball = R"({"kind": "sphere"})";
    for (const char* name : {"t", "m", "sin", "pi", "2d", "a b", "deg"})
        EXPECT_NE(about(ball, std::string("\"parameters\": {\"") + name + "\": {\"value\": 0.5}},")
                      .find("parameters." + std::string(name)),
                  std::string::npos)
            << name;
    EXPECT_NE(about(ball, R"("parameters": {"a": {"value": 3}},)").find("this is 3; give 0 to 1"), std::string::npos);
    EXPECT_NE(about(ball, R"("parameters": {"a": {"value": 3, "range": [5, 1]}},)").find("the lower one first"),
              std::string::npos);
    EXPECT_NE(about(ball, R"("parameters": {"a": {"value": "t"}},)").find("cannot depend on others"),
              std::string::npos);
}

TEST(SceneReader, TakesTextThatIsNoSceneForWhatItIs)
{
    EXPECT_EQ(first(""), "test.json:1:1: the file is empty; it should hold JSON.");
    EXPECT_EQ(first("{\"format\": \"vitrine-scene\",\n  \"version\": 1,,}").substr(0, 43),
              "test.json:2:16: version: this is not valid ");
    EXPECT_EQ(first("{\"format\": 1,\n \"format\": 2}"),
              "test.json:2:9: format: this key appears twice; remove one of the two.");
    EXPECT_EQ(first("[]"), "test.json:1:1: a scene must be an object: { ... }.");
    EXPECT_EQ(first("{}").substr(0, 47), "test.json:1:1: this is not a scene; a scene beg");
    EXPECT_EQ(first(R"({"format": "vitrine-scene", "version": 2, "root": {"kind": "sphere"}})"),
              "test.json:1:29: version: this version is not known; give \"version\": 1.");
    EXPECT_EQ(first(R"({"format": "vitrine-scene", "version": 1})"),
              "test.json:1:1: this scene has no \"root\"; it is the node that is drawn.");
    EXPECT_NE(about(R"({"kind": "sphere", "radius": NaN})").find("this is not valid JSON"), std::string::npos);
    EXPECT_NE(about(R"({"kind": "sphere", "radius": 1e999})").find("too large"), std::string::npos);
}

TEST(SceneReader, FindsSeveralThingsAtOnceAndNotWithoutEnd)
{
    std::string children;
    for (int i = 0; i < 100; ++i) children += std::string(i > 0 ? ", " : "") + R"({"kind": "sphere", "radius": 0})";
    const scenes::ReadScene read =
        test::readText(test::sceneText("{\"kind\": \"union\", \"children\": [" + children + "]}"));
    EXPECT_EQ(read.findings.size(), scenes::SceneLimits().findings);
}

TEST(SceneReader, CutsCyclesOfInstances)
{
    const std::string head =
        R"("nodes": {"a": {"kind": "union", "children": [{"kind": "sphere"}, {"kind": "instance", "of": "b"}]},
        "b": {"kind": "round", "child": {"kind": "instance", "of": "a"}}},)";
    EXPECT_NE(about(R"({"kind": "instance", "of": "a"})", head).find("contains itself"), std::string::npos);
    EXPECT_NE(about(R"({"kind": "instance", "of": "c"})", head)
                  .find("unknown node under \"nodes\": \"c\"; take one of a and b."),
              std::string::npos)
        << about(R"({"kind": "instance", "of": "c"})", head);
}

TEST(SceneReader, CountsWhatInstancesBring)
{
    // Each of twenty nodes contains two of the one before: a million nodes from one page.
    std::string head = R"("nodes": {"n0": {"kind": "sphere"})";
    for (int i = 1; i <= 20; ++i) {
        const std::string before = "{\"kind\": \"instance\", \"of\": \"n" + std::to_string(i - 1) + "\"}";
        head += ",\n\"n" + std::to_string(i) + R"(": {"kind": "union", "children": [)" + before + ", " + before + "]}";
    }
    EXPECT_NE(about(R"({"kind": "instance", "of": "n20"})", head + "},").find("more than 16384 nodes"),
              std::string::npos);
    // A chain of instances has no nodes of its own, and is limited, too.
    head = R"("nodes": {"n0": {"kind": "sphere"})";
    for (int i = 1; i <= 1000; ++i)
        head += ",\n\"n" + std::to_string(i) + R"(": {"kind": "instance", "of": "n)" + std::to_string(i - 1) + "\"}";
    EXPECT_NE(about(R"({"kind": "instance", "of": "n1000"})", head + "},").find("more than 64 deep"),
              std::string::npos);
}

TEST(SceneReader, AnInstanceIsTheNodeAtAnotherPlace)
{
    const scenes::SceneField field = test::fieldOf(
        R"({"kind": "union", "children": [{"kind": "instance", "of": "ball", "translate": [2, 0, 0], "scale": 2}, {"kind": "instance", "of": "ball"}]})",
        R"("nodes": {"ball": {"kind": "sphere", "radius": 0.25}},)");
    EXPECT_NEAR(field.distance({2, 0, 0}), -0.5, 1e-12);
    EXPECT_NEAR(field.distance({0, 0, 0}), -0.25, 1e-12);
}

double seconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(LongSceneReader, RefusesADepthOf100000AndAMillionNodes)
{
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += R"({"kind": "round", "child": )";
    deep += R"({"kind": "sphere"})" + std::string(100000, '}');
    EXPECT_NE(about(deep).find("nested more than 40000 deep"), std::string::npos) << about(deep).substr(0, 300);
    std::string wide = R"({"kind": "union", "children": [{"kind": "sphere"})";
    for (int i = 0; i < 1000000; ++i) wide += ",{}";
    EXPECT_NE(about(wide + "]}").find("more than 1000000 values"), std::string::npos)
        << about(wide + "]}").substr(0, 300);
    std::string many = R"({"kind": "union", "children": [{"kind": "sphere"})";
    for (int i = 0; i < 100000; ++i) many += R"(,{"kind": "sphere"})";
    EXPECT_NE(about(many + "]}").find("more than 16384 nodes"), std::string::npos);
    EXPECT_LT(seconds([&] { static_cast<void>(test::readText(test::sceneText(many + "]}"))); }), 20);
    std::string nested;
    for (int i = 0; i < 16000; ++i) nested += R"({"kind": "round", "radius": 0, "child": )";
    nested += R"({"kind": "sphere"})" + std::string(16000, '}');
    EXPECT_NEAR(test::fieldOf(nested).distance({2, 0, 0}), 1.5, 1e-12);
}

/// Reads files of one folder from a map.
scenes::ReadScene readFiles(const std::map<std::string, std::string>& files)
{
    const auto open = [&](const std::string& path) {
        const auto found = files.find(path);
        if (found == files.end()) throw Failure(ErrorKind::file, "Cannot read " + path + ": there is no file.");
        return found->second;
    };
    return scenes::readScene(files.at("main.json"), "main.json", open);
}

std::string includeOf(const std::string& path)
{
    return test::sceneText("{\"kind\": \"include\", \"file\": \"" + path + "\", \"translate\": [1, 0, 0]}");
}

TEST(SceneReader, IncludesFilesFromTheirFolderDownward)
{
    const scenes::ReadScene read = readFiles(
        {{"main.json", includeOf("parts/wheel.json")},
         {"parts/wheel.json", includeOf("hub.json")},
         {"parts/hub.json",
          test::sceneText(
              R"({"kind": "sphere", "radius": "r", "material": "red"})",
              R"("parameters": {"r": {"value": 0.2, "unit": "m"}}, "materials": {"red": {"model": "pbr", "color": [1, 0, 0]}},)")}});
    ASSERT_TRUE(read.scene) << test::findingsText(read);
    EXPECT_EQ(read.scene->files.size(), 3U);
    EXPECT_TRUE(read.scene->parameters().empty());
    const scenes::SceneField field(read.scene);
    EXPECT_NEAR(field.distance({2, 0, 0}), -0.2, 1e-12);
    EXPECT_EQ(field.sample({2, 0, 0}).material[1], 0);
}

TEST(SceneReader, RefusesIncludesThatLeaveTheFolderOrComeBack)
{
    for (const char* path : {"../secret.json", "/etc/passwd", "parts/../../a.json", "~/a.json", "C:a.json", ""}) {
        const scenes::ReadScene read = readFiles({{"main.json", includeOf(path)}});
        EXPECT_FALSE(read.scene) << path;
        EXPECT_NE(test::findingsText(read).find("main.json:3:29: root.file: this file is not opened"),
                  std::string::npos)
            << test::findingsText(read);
    }
    const scenes::ReadScene missing = readFiles({{"main.json", includeOf("a.json")}});
    EXPECT_NE(test::findingsText(missing).find("Cannot read a.json: there is no file."), std::string::npos);
    const scenes::ReadScene cycle = readFiles({{"main.json", includeOf("a.json")}, {"a.json", includeOf("main.json")}});
    EXPECT_NE(test::findingsText(cycle).find("contains itself"), std::string::npos) << test::findingsText(cycle);
    const scenes::ReadScene broken = readFiles({{"main.json", includeOf("a.json")}, {"a.json", "{\n  \"format\": }"}});
    EXPECT_NE(test::findingsText(broken).find("a.json:2:13:"), std::string::npos) << test::findingsText(broken);
}

TEST(LongSceneReader, SurvivesAHundredThousandMutatedFiles)
{
    const std::string start = test::sceneText(
        R"({"kind": "union", "blend": "cubic", "blendWidth": "gap", "children": [
            {"kind": "repeat", "spacing": [1, 0, 2], "count": [0, 1, 3], "child": {"kind": "capsule", "start": [0.1, 0, 0], "material": "red"}},
            {"kind": "instance", "of": "part", "rotate": [0, "30 * t", 0]},
            {"kind": "morph", "share": 0.3, "children": [{"kind": "ellipsoid", "scale": [1, 2, 1]}, {"kind": "noise"}]}]})",
        R"("parameters": {"gap": {"value": 0.1, "unit": "m"}}, "nodes": {"part": {"kind": "twist", "child": {"kind": "triangle"}}},
           "materials": {"red": {"model": "phong", "mirror": 0.5}}, "lights": [{"kind": "sun"}], "camera": {"position": [0, 1, 4]},)");
    ASSERT_TRUE(test::readText(start).scene) << test::findingsText(test::readText(start));
    const std::string pieces[] = {"0",        "-1",   "1e9", "1e-9", "\"t\"",      "\"1/gap\"",
                                  "null",     "true", "[]",  "{}",   "\"sphere\"", "\"part\"",
                                  "\"kind\"", ",",    "\"",  "{",    "]"};
    test::Random random(41);
    int accepted = 0;
    for (int i = 0; i < 100000; ++i) {
        std::string text = start;
        for (int change = 1 + random.below(3); change > 0; --change) {
            const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
            const auto length = static_cast<std::size_t>(random.below(12));
            switch (random.below(4)) {
            case 0: text.erase(at, length); break;
            case 1: text[at] = static_cast<char>(random.below(256)); break;
            case 2:
                text.insert(at,
                            text.substr(static_cast<std::size_t>(random.below(static_cast<int>(text.size()))), length));
                break;
            default: text.replace(at, length, pieces[random.below(static_cast<int>(std::size(pieces)))]); break;
            }
        }
        const scenes::ReadScene read = test::readText(text);
        ASSERT_NE(read.scene == nullptr, read.findings.empty()) << text;
        if (!read.scene) continue;
        ++accepted;
        const scenes::SceneField field(read.scene, 0.7);
        ASSERT_TRUE(std::isfinite(field.distance({0.3, 0.2, 0.1}))) << text;
    }
    EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace vitrine

// The fifteen compositions of the reference as scene files, and the reference's own scene objects.

#include "tests/exhibits/sdf_scenes/support.h"

#include "render/files/read_file.h"

#include <filesystem>
#include <set>

namespace vitrine {
namespace {

std::vector<std::filesystem::path> shippedScenes()
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes"))
        if (entry.path().filename() != "scene.schema.json") paths.push_back(entry.path());
    return paths;
}

/// Returns whether the reference does not have this scene.
bool isOurs(const std::filesystem::path& path)
{
    static const std::set<std::string> ours{"dahlia", "mercury", "rotunda", "still_life"};
    return ours.contains(path.stem().string());
}

TEST(SceneFiles, TheFifteenCompositionsAreRead)
{
    int read = 0;
    for (const std::filesystem::path& path : shippedScenes()) {
        const scenes::ReadScene scene = scenes::readSceneFile(path);
        ASSERT_TRUE(scene.scene) << test::findingsText(scene);
        EXPECT_FALSE(scene.scene->name.empty()) << path;
        EXPECT_FALSE(scene.scene->about.empty()) << path;
        // The camera is outside of all shapes, and looks at one.
        const scenes::SceneField field(scene.scene);
        const std::vector<double> n = scene.scene->numbersAt(0);
        const double* c = &n[scene.scene->camera.numbers];
        const glm::dvec3 eye(c[0], c[1], c[2]);
        const glm::dvec3 ahead = glm::normalize(glm::dvec3(c[3], c[4], c[5]) - eye);
        EXPECT_GT(field.distance(eye), 0.1) << path;
        double t = 0;
        double d = 1;
        for (int step = 0; step < 2000 && t < 100 && d > 1e-4; ++step) {
            d = field.distance(eye + t * ahead);
            t += d;
        }
        EXPECT_LT(t, 100) << path;
        read += !isOurs(path);
    }
    EXPECT_EQ(read, 15);
}

TEST(SceneFiles, MoveWhereTheReferenceMoves)
{
    for (const std::filesystem::path& path : shippedScenes()) {
        if (isOurs(path)) continue;
        const std::string name = path.stem().string();
        const bool moves = name == "noise" || name == "fractal_noise" || name == "waves" || name == "clouds";
        EXPECT_EQ(scenes::readSceneFile(path).scene->animated(), moves) << path;
    }
}

TEST(SceneFiles, ThatAreNotThereAreFindings)
{
    const scenes::ReadScene read = scenes::readSceneFile("/nowhere/scene.json");
    ASSERT_EQ(read.findings.size(), 1U);
    EXPECT_EQ(read.findings.front().file, "/nowhere/scene.json");
}

/// Scene object of the reference with all its members.
const char* const sourceObject = R"({
  "name": "All",
  "camera": {"position": [0, 3, 10], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 65},
  "soft_shadows_factor": 20,
  "cubemap": "yokohama",
  "materials": [
    {"name": "white", "color": [0.9, 0.9, 0.9], "ambient": 0.1, "diffuse": 0.9, "specular": 0.1, "shininess": 4, "mirror": 0.25}],
  "lights": [{"position": [0, 4, 0], "color": [1, 0.5, 0.25]}],
  "primitives": {
    "spheres": [{"center": [1, 2, 3], "radius": 0.5, "material": "white"}],
    "planes": [{"center": [0, -1, 0], "normal": [0, -2, 0]}],
    "cylinders": [{"center": [5, 0, 0], "axis": [1, 1, 0], "radius": 0.3, "height": 2, "is_capsule": 0},
                  {"center": [8, 0, 0], "axis": [0, 0, 3], "radius": 0.3, "height": 2, "is_capsule": 1}],
    "boxes": [{"center": [0, 0, -5], "length": 1, "width": 2, "height": 3, "rotation_y": 90, "rounded_edges_radius": 0.1},
              {"center": [0, 0, -9], "length": 1, "width": 1, "height": 1, "is_frame": 1}],
    "toruses": [{"center": [0, 0, -15], "radi": [1, 0.25], "rotation_x": 90}],
    "triangles": [{"vertice1": [20, 0, 0], "vertice2": [21, 0, 0], "vertice3": [20, 1, 0]}],
    "links": [{"center": [25, 0, 0], "length": 1, "radius1": 0.5, "radius2": 0.1}],
    "cones": [{"center": [30, 3, 0], "sin_cos": [1, 2], "height": 3}],
    "hexagonals": [{"center": [35, 0, 0], "heights": [0.5, 1]}],
    "triangulars": [{"center": [40, 0, 0], "heights": [0.5, 1]}],
    "ellipsoids": [{"center": [45, 0, 0], "radius": [1, 0.5, 0.25]}],
    "octahedrons": [{"center": [50, 0, 0], "length": 1}],
    "pyramids": [{"center": [55, 0, 0], "height": 1.5}]},
  "subtractions": [{"material": "white", "smooth_factor": 0,
    "shapes": [{"type": "sphere", "center": [60, 0, 0], "radius": 1}, {"type": "box", "center": [60, 0, 0], "length": 4, "width": 1, "height": 1}]}],
  "unions": [{"smooth_factor": 0.5, "shapes": [{"type": "sphere", "center": [70, 0, 0], "radius": 1}, {"type": "sphere", "center": [71, 0, 0], "radius": 1}]}]
})";

TEST(SceneFiles, SceneObjectsOfTheReferenceAreRead)
{
    const scenes::ReadScene read = test::readText(sourceObject);
    ASSERT_TRUE(read.scene) << test::findingsText(read);
    const scenes::SceneField field(read.scene);
    const std::pair<glm::dvec3, double> known[] = {
        {{1, 2, 3.75}, 0.25},                       // Ball.
        {{-40, 0, 5}, 1},                           // Above the plane, whose normal points away from the eye.
        {{5.9, 0.9, 0}, 0.9 * std::sqrt(2.0) - 1},  // Beyond the end of the leaning cylinder.
        {{8, 0, 1.5}, 0.2},                         // Beyond the end of the capsule.
        {{1.7, 0, -5}, 0.1},  // In front of the long side of the box, which is rotated and enlarged by its rounding.
        {{0, 0, -9}, std::hypot(0.4, 0.4)},  // Inside of the frame.
        {{0, 1.5, -15}, 0.25},               // Above the ring, upright.
        {{20.25, 0.25, 0.5}, 0.5},           // In front of the triangle.
        {{25, 1.8, 0}, 0.2},                 // Above the link.
        {{30, 3.5, 0}, 0.5},                 // Above the tip of the cone.
        {{35, 0.8, 0}, 0.3},
        {{40, 0.2, 1.25}, 0.25},
        {{46.5, 0, 0}, 0.5},
        {{50, 1.5, 0}, 0.5},
        {{55, 2, 0}, 0.5}};
    for (const auto& [p, distance] : known)
        EXPECT_NEAR(field.distance(p), distance, 1e-9) << p.x << ' ' << p.y << ' ' << p.z;
    // The second shape without the first: the box ends at the ball.
    EXPECT_GT(field.distance({60, 0, 0}), 0);
    EXPECT_LT(field.distance({61.5, 0, 0}), 0);
    // k begins where distances differ by it.
    EXPECT_NEAR(field.distance({70.5, 0, 0}), -0.5 - 0.5 / 4, 1e-9);
    EXPECT_EQ(field.sample({1, 2, 3}).material[7], 0.25);
    const std::vector<double> n = read.scene->numbersAt(0);
    EXPECT_NEAR(n[read.scene->camera.numbers + 9], 65 * std::acos(-1.0) / 180, 1e-12);
    EXPECT_EQ(n[read.scene->look.numbers], 1);
    EXPECT_EQ(n[read.scene->look.numbers + 2], 20);
    EXPECT_EQ(read.scene->lights.size(), 1U);
}

TEST(SceneFiles, WhatIsWrongInThemIsSaidWhereItStands)
{
    const std::string camera =
        "{\n\"camera\": {\"position\": [0, 0, 9], \"target\": [0, 0, 0], \"up\": [0, 1, 0], \"fov\": 65},\n";
    const std::pair<const char*, const char*> bad[] = {
        {R"("primitives": {"triangles": [{"vertice1": [4,3,3], "vertice2": [4,3,3], "vertice3": [4,3,3]}]}})",
         "test.json:3:30: primitives.triangles[0]: the corners lie on one line"},
        {R"("primitives": {"cylinders": [{"center": [0,0,0], "axis": [0,0,0], "radius": 1, "height": 1}]}})",
         "test.json:3:30: primitives.cylinders[0]: the axis is 0, 0, 0"},
        {R"("primitives": {"spheres": [{"center": [0,0,0], "radius": -1}]}})",
         "test.json:3:28: primitives.spheres[0]: this is -1 m; give 0.0001 m to 10000 m"},
        {R"("primitives": {"spheres": [{"center": [0,0], "radius": 1}]}})", "this must be an array of 3 numbers"},
        {R"("primitives": {"spheres": [{"center": [0,0,0], "radus": 1}]}})", "a sphere needs a \"radius\""},
        {R"("primitives": {"sphere": []}})", "unknown list of primitives: \"sphere\"; did you mean \"spheres\"?"},
        {R"("primitives": {"spheres": [{"center": [0,0,0], "radius": 1, "material": "red"}]}})",
         "unknown material: \"red\""},
        {R"("unions": [{"shapes": []}]})", "a combination needs two \"shapes\""},
        {R"("unions": [{"shapes": [{"type": "ball"}, 3]}]})", "unknown type of shape: \"ball\""},
        {R"("primitives": {}})", "this scene has no shapes"},
        {R"("primitives": []})", "this must be an object"}};
    for (const auto& [rest, sentence] : bad) {
        const scenes::ReadScene read = test::readText(camera + rest);
        EXPECT_FALSE(read.scene) << rest;
        EXPECT_NE(test::findingsText(read).find(sentence), std::string::npos) << rest << '\n'
                                                                              << test::findingsText(read);
    }
}

/// The reference's "Primitives" has a triangle of area 0. It divides by zero there, and draws the rest.
TEST(SceneFiles, ShapesOfTheReferenceThatAreNoneAreLeftOutOfTheOthers)
{
    const std::string text = R"({"camera": {"position": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 65},
        "primitives": {"spheres": [{"center": [0,0,0], "radius": 1}, {"center": [0,0,0], "radius": 0}],
                       "triangles": [{"vertice1": [4,3,3], "vertice2": [4,3,3], "vertice3": [4,3,3]},
                                     {"vertice1": [4,3,3], "vertice2": [5,3,3], "vertice3": [4,4,3]}]},
        "unions": [{"shapes": [{"type": "sphere", "center": [20,0,0], "radius": 1},
                               {"type": "cylinder", "center": [30,0,0], "axis": [0,0,0], "radius": 1, "height": 1}]}],
        "subtractions": [{"shapes": [{"type": "sphere", "center": [40,0,0], "radius": 1},
                                     {"type": "sphere", "center": [40,0,0], "radius": -2}]}]})";
    const scenes::ReadScene read = test::readText(text);
    ASSERT_TRUE(read.scene) << test::findingsText(read);
    ASSERT_EQ(read.scene->leftOut.size(), 4U);
    std::string all;
    for (const scenes::Finding& finding : read.scene->leftOut) all += finding.text().english() + '\n';
    for (const char* key :
         {"primitives.spheres[1]: this is 0 m", "primitives.triangles[0]: the corners lie on one line",
          "unions[0].shapes[1]: the axis is 0, 0, 0", "subtractions[0].shapes[1]: this is -2 m"})
        EXPECT_NE(all.find(key), std::string::npos) << key << '\n' << all;
    const scenes::SceneField field(read.scene);
    EXPECT_NEAR(field.distance({0, 0, 1.5}), 0.5, 1e-9);
    EXPECT_NEAR(field.distance({4.2, 3.2, 3.5}), 0.5, 1e-9);
    EXPECT_NEAR(field.distance({20, 0, 1.5}), 0.5, 1e-9);
    EXPECT_GT(field.distance({30, 0, 0}), 8);
    // Subtracting its second shape leaves nothing.
    EXPECT_GT(field.distance({40, 0, 0}), 8);
    EXPECT_TRUE(test::readText(test::sceneText(R"({"kind": "sphere"})")).scene->leftOut.empty());
}

TEST(SceneFiles, NoiseScenesOfTheReferenceAreSurfacesOfNoise)
{
    const std::string camera = R"("camera": {"position": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov": 75})";
    for (const char* name : {"3D-Perlin-Noise", "Waves", "Clouds"}) {
        const scenes::ReadScene read =
            test::readText("{\"name\": \"" + std::string(name) + "\", \"is_noise\": 1, " + camera + "}");
        ASSERT_TRUE(read.scene) << test::findingsText(read);
        EXPECT_TRUE(read.scene->animated());
    }
}

}  // namespace
}  // namespace vitrine

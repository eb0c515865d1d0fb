// Meshes of scenes: closed manifolds for all fields, of the correct size, and with sharp edges.

#include "exhibits/sdf_scenes/cell_loops.h"
#include "exhibits/sdf_scenes/scene_mesh.h"
#include "render/failure.h"
#include "render/scene/gltf.h"
#include "tests/exhibits/sdf_scenes/support.h"
#include "tests/support/failures.h"

#include <cmath>
#include <numbers>
#include <set>

namespace vitrine {
namespace {

using std::numbers::pi;

scenes::SceneMesh meshOf(const std::string& root, double cell, scenes::MeshPlan* plan = nullptr)
{
    const scenes::SceneField field = test::fieldOf(root);
    scenes::SceneMesher mesher(field, {.cell = cell});
    scenes::SceneMesh mesh = mesher.mesh().value();
    if (plan) *plan = mesher.plan();
    return mesh;
}

void expectGood(const scenes::MeshCheck& check)
{
    EXPECT_EQ(check.openEdges, 0U);
    EXPECT_EQ(check.brokenVertices, 0U);
    EXPECT_EQ(check.emptyTriangles, 0U);
    EXPECT_EQ(check.foldedTriangles, 0U);
    EXPECT_EQ(check.joinedVertices, 0U);
}

TEST(CellLoops, CrossEveryEdgeThatHasAnEndOnEachSide)
{
    for (unsigned inside = 0; inside < 256; ++inside) {
        const scenes::CellLoops& loops = scenes::cellLoops(inside);
        std::set<int> found;
        for (unsigned e = 0; e < 12; ++e) {
            const unsigned start = scenes::edgeStart(e);
            const bool crossed = (inside >> start & 1U) != (inside >> (start | 1U << (e / 4)) & 1U);
            EXPECT_EQ(loops.loopOf[e] >= 0, crossed) << inside << ' ' << e;
            if (crossed) found.insert(loops.loopOf[e]);
            EXPECT_EQ(scenes::edgeAt(e / 4, start), e);
        }
        EXPECT_EQ(static_cast<int>(found.size()), loops.loops) << inside;
    }
    EXPECT_EQ(scenes::cellLoops(1).loops, 1);
    EXPECT_EQ(scenes::cellLoops(0b10000001).loops, 2);  // Opposite corners.
    EXPECT_EQ(scenes::cellLoops(0b01101001).loops, 4);  // Every other corner.
}

/// Volume and area compared with closed forms; half the cell size gives a quarter of the error.
TEST(SceneMesh, HasTheVolumeAndAreaOfTheBodyTheBetterTheFinerItIs)
{
    struct Body {
        std::string root;
        double volume, area;
    };
    const std::vector<Body> bodies{
        {R"({"kind": "sphere", "radius": 0.5})", 4.0 / 3 * pi * 0.125, pi},
        {R"({"kind": "torus", "majorRadius": 0.5, "minorRadius": 0.2})", 2 * pi * pi * 0.5 * 0.04, 4 * pi * pi * 0.1},
        {R"({"kind": "cylinder", "radius": 0.4, "height": 1, "rotate": [30, 40, 10]})", pi * 0.16, 2 * pi * 0.4 * 1.4}};
    for (const Body& body : bodies) {
        double previous = 1;
        for (const double cell : {0.05, 0.025, 0.0125}) {
            const scenes::MeshCheck check = scenes::checkMesh(meshOf(body.root, cell));
            expectGood(check);
            const double volume = std::abs(check.volume / body.volume - 1), area = std::abs(check.area / body.area - 1);
            EXPECT_LT(volume, 4 * cell * cell) << body.root;
            EXPECT_LT(area, 4 * cell * cell) << body.root;
            EXPECT_LT(volume, 0.45 * previous) << body.root << cell;
            previous = volume;
        }
    }
}

/// Returns the allowed distance of a vertex from the surface: vertices stay a hundredth of a cell away from its sides,
/// and their search ends at a tolerance.
double offSurface(double cell)
{
    return (0.01 * std::sqrt(3.0) + 0.001) * cell;
}

/// A box has flat faces and sharp edges. The mesh keeps them, except where an edge leaves the cell whose vertex it
/// needs.
TEST(SceneMesh, KeepsEdgesAndCornersSharp)
{
    constexpr double edges = 4 * (1 + 0.7 + 0.5);
    for (const std::string place : {"", R"(, "rotate": [20, 30, 50], "translate": [0.1, 0.2, 0.3])"})
        for (const double cell : {0.04, 0.02, 0.01}) {
            const std::string root = R"({"kind": "box", "size": [1, 0.7, 0.5])" + place + "}";
            const scenes::SceneMesh mesh = meshOf(root, cell);
            const scenes::MeshCheck check = scenes::checkMesh(mesh);
            expectGood(check);
            EXPECT_NEAR(check.volume, 0.35, 0.03 * edges * cell * cell) << root;
            EXPECT_NEAR(check.area, 2 * (0.7 + 0.5 + 0.35), 0.03 * edges * cell) << root;
            const scenes::SceneField field = test::fieldOf(root);
            double corner = -1;
            for (const scenes::MeshVertex& v : mesh.vertices) {
                EXPECT_LT(std::abs(field.distance(v.position)), offSurface(cell));
                corner = std::max<double>(corner, glm::distance(glm::dvec3(v.position), field.box().center()));
            }
            EXPECT_NEAR(corner, 0.5 * std::hypot(1, 0.7, 0.5), 0.05 * cell);
        }
}

/// A ball subtracted from a box leaves edges of 34 degrees, which are thinner than a cell at their ends.
TEST(LongSceneMesh, KeepsThinEdgesSharp)
{
    const std::string root = R"({"kind": "subtraction", "rotate": [10, 30, 0], "children": [
        {"kind": "box", "size": 0.6}, {"kind": "sphere", "radius": 0.36}]})";
    constexpr double r = 0.36, cap = r - 0.3;
    const double hole = pi * (r * r - 0.3 * 0.3);
    const double volume = 0.6 * 0.6 * 0.6 - 4.0 / 3 * pi * r * r * r + 6 * pi * cap * cap * (3 * r - cap) / 3;
    const double area = 6 * (0.36 - hole) + 4 * pi * r * r - 6 * 2 * pi * r * cap;
    const double straight = 12 * 0.6, thin = 6 * 2 * std::sqrt(pi * hole);
    const scenes::SceneField field = test::fieldOf(root);
    for (const double cell : {0.02, 0.01, 0.005}) {
        const scenes::SceneMesh mesh = meshOf(root, cell);
        const scenes::MeshCheck check = scenes::checkMesh(mesh);
        expectGood(check);
        EXPECT_NEAR(check.volume, volume, 0.1 * (straight + thin) * cell * cell);
        // Along thin edges, triangles may overlap by a quarter of a cell.
        EXPECT_NEAR(check.area, area, (0.03 * straight + 0.25 * thin) * cell);
        // Wrong teeth would be triangles across the wedge, one in each cell along it.
        std::size_t teeth = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            glm::dvec3 middle(0);
            for (std::size_t k = 0; k < 3; ++k) middle += glm::dvec3(mesh.vertices[mesh.indices[i + k]].position) / 3.0;
            teeth += std::abs(field.distance(middle)) > 0.1 * cell;
        }
        EXPECT_LT(static_cast<double>(teeth), 0.05 * thin / cell) << cell;
    }
}

TEST(SceneMesh, LiesOnTheSurfaceWithItsNormalsAndColors)
{
    const scenes::SceneField field = test::fieldOf(
        R"({"kind": "union", "blend": "cubic", "blendWidth": 0.3, "children": [
            {"kind": "sphere", "radius": 0.5, "material": "red"},
            {"kind": "sphere", "radius": 0.4, "translate": [0.7, 0, 0], "material": "blue"}]})",
        R"("materials": {"red": {"model": "phong", "color": [1, 0, 0]}, "blue": {"model": "phong", "color": [0, 0, 1]}},)");
    const scenes::SceneMesh mesh = scenes::SceneMesher(field, {.cell = 0.02}).mesh().value();
    for (const scenes::MeshVertex& v : mesh.vertices) {
        const glm::dvec3 p(v.position);
        EXPECT_LT(std::abs(field.distance(p)), offSurface(0.02));
        EXPECT_GT(glm::dot(glm::dvec3(v.normal), glm::normalize(test::gradientAt(field, p))), 0.99);
        EXPECT_NEAR(v.color.x + v.color.z, 1, 1e-5);
        EXPECT_TRUE(p.x >= 0 || v.color.x == 1);
        EXPECT_TRUE(p.x <= 0.8 || v.color.z == 1);
    }
}

/// Random fields with large cells contain all ambiguous neighborhoods. Returns the number of triangles.
std::size_t expectClosedManifolds(std::uint64_t seed, int fields)
{
    test::Random random(seed);
    std::size_t triangles = 0;
    for (int sample = 0; sample < fields; ++sample) {
        const std::string root = sample % 3 > 0 ? test::randomTree(random, 3)
                                                : R"({"kind": "noise", "frequency": )" +
                                                      std::to_string(random.number(3, 9)) + R"(, "octaves": 3})";
        const scenes::SceneField field = test::fieldOf(root);
        scenes::SceneMesher mesher(field, {.cell = 0.09, .part = render::Box{glm::dvec3(-1.2), glm::dvec3(1.2)}});
        const scenes::SceneMesh mesh = mesher.mesh().value();
        triangles += mesh.indices.size() / 3;
        const scenes::MeshCheck check = scenes::checkMesh(mesh);
        expectGood(check);
        EXPECT_TRUE(check.good()) << root;
    }
    return triangles;
}

TEST(SceneMesh, IsAClosedManifoldWhateverTheField)
{
    EXPECT_GT(expectClosedManifolds(21, 12), 20'000U);
}

TEST(LongSceneMesh, IsAClosedManifoldWhateverTheField)
{
    EXPECT_GT(expectClosedManifolds(22, 60), 100'000U);
}

TEST(SceneMesh, ThinWallsAreKeptDownToACellAndAreSaidToBeLostBelow)
{
    const auto walls = [](double thickness) {
        return R"({"kind": "box", "size": [1, 1, )" + std::to_string(thickness) + R"(], "rotate": [10, 20, 30]})";
    };
    scenes::MeshPlan plan;
    const scenes::MeshCheck thick = scenes::checkMesh(meshOf(walls(0.05), 0.025, &plan));
    expectGood(thick);
    EXPECT_NEAR(thick.volume, 0.05, 0.002);
    EXPECT_EQ(plan.lost, 0U);
    const scenes::MeshCheck thin = scenes::checkMesh(meshOf(walls(0.01), 0.025, &plan));
    expectGood(thin);
    EXPECT_GT(plan.lost, 20U);
    EXPECT_LT(thin.volume, 0.01);
}

TEST(SceneMesh, SkipsTheCellsThatAreFarFromTheSurface)
{
    scenes::MeshPlan coarse, fine;
    (void)meshOf(R"({"kind": "sphere", "radius": 0.5})", 0.02, &coarse);
    (void)meshOf(R"({"kind": "sphere", "radius": 0.5})", 0.01, &fine);
    EXPECT_NEAR(fine.allCells() / coarse.allCells(), 8, 1);
    EXPECT_NEAR(double(fine.nearSurface) / double(coarse.nearSurface), 4, 0.3);
    EXPECT_LT(double(fine.nearSurface), 0.06 * fine.allCells());
    // A plane with cells of this size crosses at least this many.
    EXPECT_GT(double(fine.nearSurface), pi / (0.01 * 0.01));
}

/// A point in a blend of a thousand shapes evaluates only nearby ones.
TEST(LongSceneMesh, AsksFewShapesOfMany)
{
    test::Random random(22);
    std::string root = R"({"kind": "union", "blend": "quadratic", "blendWidth": 0.05, "children": [)";
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p = random.point(1);
        root +=
            (i > 0 ? ", " : "") + ("{\"kind\": \"sphere\", \"radius\": 0.06, \"translate\": [" + std::to_string(p.x) +
                                   ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + "]}");
    }
    const scenes::SceneField field = test::fieldOf(root + "]}");
    scenes::SceneMesher mesher(field, {.cell = 0.01});
    expectGood(scenes::checkMesh(mesher.mesh().value()));
    EXPECT_LT(static_cast<double>(mesher.primitiveEvaluations()), 10.0 * static_cast<double>(mesher.evaluations()));
    EXPECT_LT(mesher.plan().cells.x, 300);  // The bounds do not include all that a thousand blends could add.
}

TEST(SceneMesh, RefusesWhatHasNoEndOrNoRoom)
{
    const auto sentenceOf = [](const std::string& root, const scenes::MeshRequest& request) -> std::string {
        const scenes::SceneField field = test::fieldOf(root);
        try {
            const scenes::SceneMesher mesher(field, request);
        } catch (const Failure& failure) {
            EXPECT_EQ(failure.kind(), ErrorKind::usage);
            return failure.what();
        }
        return {};
    };
    EXPECT_NE(sentenceOf(R"({"kind": "plane"})", {}).find("--low"), std::string::npos);
    const std::string ball = R"({"kind": "sphere", "radius": 0.5})";
    const std::string large = sentenceOf(ball, {.cell = 1e-4, .mostBytes = 100'000'000});
    EXPECT_NE(large.find("give --cell 0.0"), std::string::npos) << large;
    const double advised = std::stod(large.substr(large.find("--cell ") + 7));
    EXPECT_EQ(sentenceOf(ball, {.cell = advised, .mostBytes = 100'000'000}), "");
    EXPECT_NE(sentenceOf(ball, {.cell = 1e-9}).find("too small"), std::string::npos);
    EXPECT_NE(sentenceOf(ball, {.cell = 0}), "");
}

/// Returns a node of an operation with its initial numbers, a blend of 20 cm, and this child; other children are small
/// balls.
std::string operationOn(const scenes::NodeKind& kind, const std::string& child)
{
    const bool blends = kind.form == scenes::Form::operands;
    const std::string ball = R"({"kind": "sphere", "radius": 0.3, "translate": [0.2, 0.1, 0]})";
    std::string text = R"({"kind": ")" + std::string(kind.name) + '"';
    if (blends) text += R"(, "blendWidth": 0.2)";
    if (blends || kind.form == scenes::Form::pair) return text + R"(, "children": [)" + child + ", " + ball + "]}";
    return text + R"(, "child": )" + child + '}';
}

/// The bounds of a scene contain every point that is inside, also distant ones, and its mesh is closed.
TEST(SceneMesh, EveryOperationHasAnEndInsideEveryOther)
{
    test::Random random(7);
    const std::string shapes[] = {R"({"kind": "box", "size": [0.6, 0.8, 0.4], "rotate": [10, 20, 30]})",
                                  R"({"kind": "ellipsoid", "radii": [0.5, 0.3, 0.2], "translate": [0.4, 0, 0.1]})"};
    int pairs = 0, points = 0;
    for (const scenes::NodeKind& outer : scenes::nodeKinds()) {
        if (outer.form == scenes::Form::shape) continue;
        for (const scenes::NodeKind& inner : scenes::nodeKinds()) {
            if (inner.form == scenes::Form::shape) continue;
            for (const std::string& shape : shapes) {
                SCOPED_TRACE(std::string(inner.name) + " in " + std::string(outer.name));
                const scenes::SceneField field = test::fieldOf(operationOn(outer, operationOn(inner, shape)));
                const render::Box box = field.box();
                ASSERT_LT(glm::length(box.low) + glm::length(box.high), 1e3);
                ++pairs;
                for (int i = 0; i < 300; ++i) {
                    const glm::dvec3 p = random.point(i % 3 == 0 ? 100 : 2);
                    if (field.distance(p) > 0) continue;
                    ++points;
                    EXPECT_TRUE(scenes::grown(box, 1e-9).contains(p)) << p.x << ' ' << p.y << ' ' << p.z;
                }
            }
        }
    }
    EXPECT_GT(pairs, 300);
    EXPECT_GT(points, 300);
    const std::string twist = R"({"kind": "twist", "child": {"kind": "box"}})";
    for (const char* around : {"union", "round", "onion", "displace"})
        expectGood(scenes::checkMesh(meshOf(operationOn(*scenes::findKind(around), twist), 0.08)));
}

TEST(SceneMesh, NamesThePartThatHasNoEnd)
{
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "the plane in line", test::refusalOf([] {
                            return meshOf(R"({"kind": "union", "children": [{"kind": "sphere"}, {"kind": "plane"}]})",
                                          0.1);
                        }));
    EXPECT_PRED_FORMAT2(
        ::testing::IsSubstring, "the repeat in line", test::refusalOf([] {
            return meshOf(R"({"kind": "repeat", "count": [0, 1, 1], "child": {"kind": "sphere", "radius": 0.2}})", 0.1);
        }));
    // Ten turns per meter: far away, its distance is below 2 cm everywhere, so a wall of 10 cm would be everywhere.
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "the twist in line", test::refusalOf([] {
                            return meshOf(R"({"kind": "onion", "thickness": 0.1, "child":
                             {"kind": "twist", "rate": 3600, "child": {"kind": "box"}}})",
                                          0.1);
                        }));
    const scenes::SceneField far = test::fieldOf(R"({"kind": "onion", "thickness": 0.1, "child":
                             {"kind": "twist", "rate": 3600, "child": {"kind": "box"}}})");
    EXPECT_LT(far.distance({500, 0, 500}), 0);
}

TEST(SceneMesh, HasItsColorsInTheFile)
{
    const auto scene = test::sceneOf(
        R"({"kind": "union", "children": [{"kind": "sphere", "radius": 0.3, "material": "red"},
            {"kind": "sphere", "radius": 0.3, "translate": [1, 0, 0], "material": "blue"}]})",
        R"("materials": {"red": {"model": "pbr", "color": [0.8, 0.1, 0.05]},
                         "blue": {"model": "pbr", "color": [0, 0.2, 0.9]}},)");
    const auto modelOf = [](const scenes::SceneMesh& mesh) {
        return render::parseGltf(scenes::meshFile(mesh, scenes::MeshFormat::glb, "a"), "a.glb");
    };
    const scenes::SceneField field(scene);
    const render::Model model = modelOf(scenes::SceneMesher(field, {.cell = 0.05}).mesh().value());
    EXPECT_TRUE(model.warnings.empty());
    ASSERT_EQ(model.parts.size(), 2U);
    for (const render::MeshInstance& part : model.parts) {
        const bool left = part.mesh->bounds.center().x < 0.5;
        const glm::vec3 color(part.material->baseColor);
        EXPECT_LT(glm::distance(color, left ? glm::vec3(0.8, 0.1, 0.05) : glm::vec3(0, 0.2, 0.9)), 1e-5F);
        EXPECT_TRUE(part.mesh->colors.empty());
        EXPECT_NEAR(part.mesh->bounds.halfSize().y, 0.3, 0.01);
    }
    // Vertices have colors if colors blend into each other.
    const scenes::SceneField blended = test::fieldOf(
        R"({"kind": "union", "blendWidth": 0.8, "children": [{"kind": "sphere", "radius": 0.4, "material": "red"},
            {"kind": "sphere", "radius": 0.4, "translate": [0.5, 0, 0], "material": "blue"}]})",
        R"("materials": {"red": {"model": "pbr", "color": [1, 0, 0]}, "blue": {"model": "pbr", "color": [0, 0, 1]}},)");
    const render::Model mixed = modelOf(scenes::SceneMesher(blended, {.cell = 0.05}).mesh().value());
    const render::Mesh& last = *mixed.parts.back().mesh;
    ASSERT_EQ(last.colors.size(), last.vertices.size());
    bool isMixed = false;
    for (const glm::vec4& color : last.colors) isMixed = isMixed || (color.r > 0.3F && color.b > 0.3F);
    EXPECT_TRUE(isMixed);
}

TEST(SceneMesh, IsSimplifiedToANumberOfTrianglesOrADeviationAndStaysClosed)
{
    const scenes::SceneMesh ball = meshOf(R"({"kind": "sphere", "radius": 0.5})", 0.02);
    const double truth = scenes::checkMesh(ball).volume;
    const auto facesOf = [](const scenes::SceneMesh& mesh) { return mesh.indices.size() / 3; };
    double last = 0;
    for (const int triangles : {4000, 1000, 300}) {
        const scenes::SimplifiedMesh result = scenes::simplified(ball, {.triangles = triangles});
        EXPECT_LE(facesOf(result.mesh), static_cast<std::size_t>(triangles));
        EXPECT_GE(facesOf(result.mesh), static_cast<std::size_t>(0.9 * triangles));
        const scenes::MeshCheck check = scenes::checkMesh(result.mesh);
        EXPECT_TRUE(check.good()) << triangles;
        EXPECT_GT(result.deviation, last) << "fewer triangles are farther off";
        last = result.deviation;
        // A sphere with n equal triangles inside it lacks a share of about 10.9 / n of its volume. Twice that.
        EXPECT_NEAR(check.volume, truth, 22.0 / triangles * truth);
    }
    const scenes::SimplifiedMesh near = scenes::simplified(ball, {.deviation = 0.001});
    EXPECT_LE(near.deviation, 0.001);
    EXPECT_LT(facesOf(near.mesh), facesOf(ball) / 4);
    EXPECT_TRUE(scenes::checkMesh(near.mesh).good());
    for (const scenes::MeshVertex& v : near.mesh.vertices) EXPECT_NEAR(glm::length(v.position), 0.5, 0.002);
    // A box is two triangles a side, whatever its cells were.
    const scenes::SceneMesh box = meshOf(R"({"kind": "box", "size": [0.4, 0.4, 0.4]})", 0.05);
    const scenes::SimplifiedMesh plain = scenes::simplified(box, {.deviation = 1e-4});
    EXPECT_LT(facesOf(plain.mesh), facesOf(box) / 4);
    EXPECT_NEAR(scenes::checkMesh(plain.mesh).volume, scenes::checkMesh(box).volume, 1e-4 * 0.96);
}

TEST(SceneMesh, StopsWhenAsked)
{
    const scenes::SceneField field = test::fieldOf(R"({"kind": "sphere", "radius": 0.5})");
    scenes::SceneMesher mesher(field, {.cell = 0.01});
    int asked = 0;
    EXPECT_FALSE(mesher.mesh([&](double part) {
        EXPECT_GE(part, 0);
        EXPECT_LE(part, 1);
        return ++asked < 3;
    }));
    EXPECT_EQ(asked, 3);
}

TEST(MeshCheckControl, HolesAndPinchesAreFound)
{
    const scenes::SceneMesh good = meshOf(R"({"kind": "sphere", "radius": 0.5})", 0.1);
    scenes::SceneMesh hole = good;
    hole.indices.resize(hole.indices.size() - 3);
    EXPECT_EQ(scenes::checkMesh(hole).openEdges, 3U);
    scenes::SceneMesh turned = good;
    std::swap(turned.indices[0], turned.indices[1]);
    EXPECT_GT(scenes::checkMesh(turned).openEdges, 0U);
    // Two balls that share one vertex.
    scenes::SceneMesh pinched = good;
    for (const scenes::MeshVertex& v : good.vertices) {
        pinched.vertices.push_back(v);
        pinched.vertices.back().position.x += 2;
    }
    const auto n = static_cast<std::uint32_t>(good.vertices.size());
    for (const std::uint32_t i : good.indices) pinched.indices.push_back(i == 0 ? 0 : i + n);
    const scenes::MeshCheck check = scenes::checkMesh(pinched);
    EXPECT_EQ(check.openEdges, 0U);
    EXPECT_EQ(check.brokenVertices, 1U);
}

/// A simplification may end with two triangles, back to back: all edges are closed, and nothing is inside.
TEST(MeshCheckControl, TrianglesBackToBackAreNoBody)
{
    scenes::SceneMesh flat;
    flat.vertices.resize(3);
    flat.vertices[1].position = {1, 0, 0};
    flat.vertices[2].position = {0, 1, 0};
    flat.indices = {0, 1, 2, 0, 2, 1};
    const scenes::MeshCheck check = scenes::checkMesh(flat);
    EXPECT_EQ(check.openEdges + check.brokenVertices + check.emptyTriangles + check.joinedVertices, 0U);
    EXPECT_EQ(check.foldedTriangles, 1U);
    EXPECT_FALSE(check.good());
}

}  // namespace
}  // namespace vitrine

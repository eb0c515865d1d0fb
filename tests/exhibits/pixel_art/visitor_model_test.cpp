// A visitor's glTF on the screen: its animation on the exhibit's clock, and what is transparent.

#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "exhibits/pixel_art/visitor_model.h"
#include "exhibits/sprites/sprite_shots.h"
#include "tests/exhibits/pixel_art/moved_model.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace vitrine {
namespace {

using namespace test;

const PixelArtTable& modelRows()
{
    static const PixelArtTable t;
    return t;
}

struct VisitorModel : testing::Test {
    const TemporaryFolder folder;
    render::AssetStore assets;
    ParameterValues values = modelRows().initial();

    VisitorModel()
    {
        values.set(modelRows().model, writeMovedModel(folder));
        values.set(modelRows().animate, true);
        values.set(modelRows().turn, false);
    }
    /// Where the triangle's first corner is.
    glm::dvec3 cornerAt(double now)
    {
        const PosedModel posed = posedModel(modelRows(), values, now, assets);
        EXPECT_TRUE(posed.model) << posed.failure;
        const render::MeshInstance& part = posed.model->parts.front();
        return {part.modelFromPart * glm::dvec4(glm::dvec3(part.mesh->vertices.front().position), 1)};
    }
};

TEST_F(VisitorModel, PlaysTheChosenAnimationAtTheChosenSpeedAgainAndAgain)
{
    EXPECT_NEAR(cornerAt(0).x, 0, 1e-6);
    EXPECT_NEAR(cornerAt(0.6).x, 1, 1e-6);
    EXPECT_NEAR(cornerAt(1.2).x, 2, 1e-6);
    EXPECT_NEAR(cornerAt(2.6).x, 1, 1e-6);  // The second time.
    EXPECT_NEAR(cornerAt(1e6 + 0.6).x, 1, 1e-4);
    values.set(modelRows().animationSpeed, 2.0);
    EXPECT_NEAR(cornerAt(0.3).x, 1, 1e-6);
    values.set(modelRows().animationSpeed, 1.0);
    values.set(modelRows().animation, 2);
    EXPECT_NEAR(cornerAt(0.9).y, 1.5, 1e-6);
    EXPECT_EQ(cornerAt(0.9).x, 0);
    values.set(modelRows().animation, 1000);  // Beyond the last one: the last.
    EXPECT_NEAR(cornerAt(0.9).y, 1.5, 1e-6);
    values.set(modelRows().animation, 0);
    EXPECT_EQ(cornerAt(0.9), cornerAt(0.2));
    // The file was read once, whatever was asked of it.
    EXPECT_EQ(assets.builds("pixel_art.model"), 1);
}

TEST_F(VisitorModel, IsFramedWithAllThatItsAnimationReaches)
{
    values.set(modelRows().animation, 2);
    const render::Box box = posedModel(modelRows(), values, 0, assets).framed;
    EXPECT_GT(box.high.y, 3.5);
    EXPECT_EQ(posedModel(modelRows(), values, 1.1, assets).framed.high, box.high);
    values.set(modelRows().animation, 0);
    EXPECT_NEAR(posedModel(modelRows(), values, 0, assets).framed.high.y, 1, 1e-6);
}

/// Frames of the exhibit alone in a hall of its own.
struct ModelFrames : VisitorModel {
    Museum museum = [] {
        std::vector<std::unique_ptr<Exhibit>> guests;
        guests.push_back(std::make_unique<PixelArt>());
        return Museum(std::move(guests));
    }();
    std::size_t exhibit = *museum.find("pixel_art");

    render::FramePlan planAt(double time)
    {
        SceneState state = museum.initialSceneState();
        state.values[exhibit] = values;
        FrameRequest request;
        request.raster.size = {64, 36};
        request.camera = museum.bestView(exhibit, values);
        request.time = time;
        request.alone = exhibit;
        return planned(museum, state, request);
    }
    /// What is drawn again when it changes.
    static std::map<std::string, std::uint64_t> keysOf(const render::FramePlan& plan)
    {
        std::map<std::string, std::uint64_t> keys;
        for (const render::Pass& pass : plan.passes())
            if (pass.key && pass.name.rfind("pixel_art/", 0) == 0) keys[pass.name] = *pass.key;
        return keys;
    }
    std::string whyStill(double time)
    {
        const render::FramePlan plan = planAt(time);
        for (const render::CulledPass& skipped : plan.skipped())
            if (skipped.name == "pixel_art/pose") return skipped.reason;
        return {};
    }
};

TEST_F(ModelFrames, AreDrawnAgainOnlyWhereSomethingMoves)
{
    const PixelArt art;
    const auto moves = [&] { return keysOf(planAt(0.1)) != keysOf(planAt(0.9)); };
    ASSERT_FALSE(keysOf(planAt(0.1)).empty());
    EXPECT_TRUE(moves());
    EXPECT_EQ(whyStill(0.5), "");
    EXPECT_TRUE(std::isfinite(art.nextChange(values, 0.5)));
    // Between two pictures nothing moves either.
    EXPECT_EQ(keysOf(planAt(0.51)), keysOf(planAt(0.53)));

    values.set(modelRows().animationSpeed, 0.0);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "the speed of the model's animation is 0");
    EXPECT_FALSE(std::isfinite(art.nextChange(values, 0.5)));
    values.set(modelRows().turn, true);
    EXPECT_TRUE(moves());
    EXPECT_TRUE(std::isfinite(art.nextChange(values, 0.5)));
    values.set(modelRows().turn, false);
    values.set(modelRows().animationSpeed, 1.0);
    values.set(modelRows().animation, 0);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "no animation of the model is chosen");
    EXPECT_FALSE(std::isfinite(art.nextChange(values, 0.5)));
    values.set(modelRows().animation, 1);
    values.set(modelRows().animate, false);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "time does not run");
    values.set(modelRows().animate, true);
    const std::string path = (folder / "still.glb").string();
    GltfBuilder b;
    b.node({{"mesh", b.triangle()}});
    writeBytes(path, b.glb());
    values.set(modelRows().model, path);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "the model has no animation");
}

/// A square that stands over the floor of the test scene, with this material.
WorldPart squareOf(const render::Material& material)
{
    auto mesh = std::make_shared<render::Mesh>();
    for (const glm::vec3 p : {glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 2, 0), glm::vec3(-1, 2, 0)}) {
        render::Vertex vertex;
        vertex.position = p;
        vertex.normal = {0, 0, 1};
        mesh->vertices.push_back(vertex);
        mesh->bounds.include(p);
    }
    mesh->indices = {0, 1, 2, 0, 2, 3};
    return {mesh, glm::dmat4(1), 50, std::make_shared<render::Material>(material)};
}

class TransparentModel : public GlTest {
protected:
    static render::Image litWith(std::vector<WorldPart> parts, double sunAzimuth)
    {
        ParameterValues values = modelRows().initial();
        values.set(modelRows().sunAzimuth, sunAzimuth);
        PixelShot shot{modelRows(), values, pixelCamera(modelRows(), values, {0, 0}), 0.5};
        shot.camera.size = {120, 68};
        shot.parts = std::move(parts);
        render::FramePlan plan;
        plan.view.raster.size = shot.camera.size;
        plan.allParts = true;
        planPixelPicture(shot, plan);
        plan.prune({pixelLitImage});
        gallery().renderer.draw(plan);
        return gallery().renderer.read(pixelLitImage);
    }
};

TEST_F(TransparentModel, IsCutOutWhereItsMaskSaysWithItsShadow)
{
    const WorldPart floor = testParts(0.5).front();
    const render::Image bare = litWith({floor}, -1);
    render::Material material;
    material.baseColor = {0.9, 0.1, 0.1, 0.3};
    // Control: whoever has no mask hides the floor and throws a shadow, whatever its opacity.
    material.alphaMode = render::AlphaMode::opaque;
    const render::Image whole = litWith({floor, squareOf(material)}, -1);
    EXPECT_NE(whole.pixels, bare.pixels);
    material.alphaMode = render::AlphaMode::mask;
    material.alphaCutoff = 0.2F;
    EXPECT_EQ(litWith({floor, squareOf(material)}, -1).pixels, whole.pixels);
    material.alphaCutoff = 0.5F;
    EXPECT_EQ(litWith({floor, squareOf(material)}, -1).pixels, bare.pixels);
    // What would be blended is drawn or not.
    material.alphaMode = render::AlphaMode::blend;
    EXPECT_EQ(litWith({floor, squareOf(material)}, -1).pixels, bare.pixels);
    material.baseColor.a = 0.7F;
    EXPECT_NE(litWith({floor, squareOf(material)}, -1).pixels, bare.pixels);
}

TEST_F(TransparentModel, IsHonoredInSpritesWhichNameWhatIsNotBlended)
{
    const TemporaryFolder folder;
    const auto seenOf = [&](const char* mode, double alpha, std::vector<std::string>& warnings) {
        GltfBuilder b;
        const int mesh = b.triangle();
        b.json["materials"] =
            render::Json::array({{{"name", "glass"},
                                  {"alphaMode", mode},
                                  {"doubleSided", true},
                                  {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}}});
        b.json["meshes"][static_cast<std::size_t>(mesh)]["primitives"][0]["material"] = 0U;
        b.node({{"mesh", mesh}});
        const std::string path = (folder / "glass.glb").string();
        writeBytes(path, b.glb());
        const SpriteSubject subject{std::filesystem::path(path)};
        warnings = subject.warnings();
        const auto frames = drawSprite(modelRows().initial(), subject, {1, 1, {24, 24}, {}}, gallery().renderer);
        int seen = 0;
        for (std::size_t i = 3; i < frames.front().color.pixels.size(); i += 4)
            seen += frames.front().color.pixels[i] > 0;
        return seen;
    };
    std::vector<std::string> warnings;
    const int whole = seenOf("OPAQUE", 0.3, warnings);
    EXPECT_GT(whole, 20);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(seenOf("MASK", 0.3, warnings), 0);
    EXPECT_EQ(seenOf("MASK", 0.8, warnings), whole);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(seenOf("BLEND", 0.3, warnings), 0);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings.front().find("\"glass\""), std::string::npos) << warnings.front();
    EXPECT_EQ(seenOf("BLEND", 0.8, warnings), whole);
}

}  // namespace
}  // namespace vitrine

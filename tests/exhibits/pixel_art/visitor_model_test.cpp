// A visitor's glTF model on the screen: its animation by the exhibit's clock, and transparency.

#include "exhibits/jobs/sprite/sprite_shots.h"
#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "exhibits/pixel_art/visitor_model.h"
#include "tests/exhibits/pixel_art/moved_model.h"
#include "tests/support/failures.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::pixel_art {
namespace {

using jobs::drawSprite;
using jobs::isSeen;
using jobs::seenPixels;
using jobs::SpriteFrame;
using jobs::SpriteMotion;
using jobs::SpriteRequest;
using jobs::SpriteSubject;

using namespace test;

const PixelArtTable& modelParameters()
{
    static const PixelArtTable t;
    return t;
}

struct VisitorModel : testing::Test {
    const TemporaryFolder folder;
    render::AssetStore assets;
    ParameterValues values = modelParameters().initial();

    VisitorModel()
    {
        values.set(modelParameters().model, writeMovedModel(folder));
        values.set(modelParameters().animate, true);
        values.set(modelParameters().turn, false);
    }
    /// Returns the position of the triangle's first corner.
    glm::dvec3 cornerAt(double now)
    {
        const PosedModel posed = posedModel(modelParameters(), values, now, assets);
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
    EXPECT_NEAR(cornerAt(2.6).x, 1, 1e-6);  // During the second pass.
    EXPECT_NEAR(cornerAt(1e6 + 0.6).x, 1, 1e-4);
    values.set(modelParameters().animationSpeed, 2.0);
    EXPECT_NEAR(cornerAt(0.3).x, 1, 1e-6);
    values.set(modelParameters().animationSpeed, 1.0);
    values.set(modelParameters().animation, 2);
    EXPECT_NEAR(cornerAt(0.9).y, 1.5, 1e-6);
    EXPECT_EQ(cornerAt(0.9).x, 0);
    values.set(modelParameters().animation, 1000);  // Beyond the last animation: the last one.
    EXPECT_NEAR(cornerAt(0.9).y, 1.5, 1e-6);
    values.set(modelParameters().animation, 0);
    EXPECT_EQ(cornerAt(0.9), cornerAt(0.2));
    // The file was read once for all queries.
    EXPECT_EQ(assets.builds("pixel_art.model"), 1);
}

TEST_F(VisitorModel, IsFramedWithAllThatItsAnimationReaches)
{
    values.set(modelParameters().animation, 2);
    const render::Box box = posedModel(modelParameters(), values, 0, assets).framed;
    EXPECT_GT(box.high.y, 3.5);
    EXPECT_EQ(posedModel(modelParameters(), values, 1.1, assets).framed.high, box.high);
    values.set(modelParameters().animation, 0);
    EXPECT_NEAR(posedModel(modelParameters(), values, 0, assets).framed.high.y, 1, 1e-6);
}

/// Frames of the exhibit alone in its own hall.
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
    /// Returns the keys of passes, which change if they are drawn again.
    static std::map<std::string, std::uint64_t> keysOf(const render::FramePlan& plan)
    {
        std::map<std::string, std::uint64_t> keys;
        for (const render::Pass& pass : plan.passes())
            if (pass.contentHash && pass.name.rfind("pixel_art/", 0) == 0) keys[pass.name] = *pass.contentHash;
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
    // Nothing changes between two frames of the animation.
    EXPECT_EQ(keysOf(planAt(0.51)), keysOf(planAt(0.53)));

    values.set(modelParameters().animationSpeed, 0.0);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "the speed of the model's animation is 0");
    EXPECT_FALSE(std::isfinite(art.nextChange(values, 0.5)));
    values.set(modelParameters().turn, true);
    EXPECT_TRUE(moves());
    EXPECT_TRUE(std::isfinite(art.nextChange(values, 0.5)));
    values.set(modelParameters().turn, false);
    values.set(modelParameters().animationSpeed, 1.0);
    values.set(modelParameters().animation, 0);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "no animation of the model is chosen");
    EXPECT_FALSE(std::isfinite(art.nextChange(values, 0.5)));
    values.set(modelParameters().animation, 1);
    values.set(modelParameters().animate, false);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "time does not run");
    values.set(modelParameters().animate, true);
    const std::string path = (folder / "still.glb").string();
    GltfBuilder b;
    b.node({{"mesh", b.triangle()}});
    writeBytes(path, b.glb());
    values.set(modelParameters().model, path);
    EXPECT_FALSE(moves());
    EXPECT_EQ(whyStill(0.5), "the model has no animation");
}

/// Returns a square over the floor of the test scene, with this material.
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
        ParameterValues values = modelParameters().initial();
        values.set(modelParameters().sunAzimuth, sunAzimuth);
        PixelShot shot{modelParameters(), values, pixelCamera(modelParameters(), values, {0, 0}), 0.5};
        shot.camera.size = {120, 68};
        shot.parts = std::move(parts);
        render::FramePlan plan;
        plan.view.raster.size = shot.camera.size;
        plan.allSlices = true;
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
    // Control: an opaque material hides the floor and casts a shadow, whatever its opacity.
    material.alphaMode = render::AlphaMode::opaque;
    const render::Image whole = litWith({floor, squareOf(material)}, -1);
    EXPECT_NE(whole.pixels, bare.pixels);
    material.alphaMode = render::AlphaMode::mask;
    material.alphaCutoff = 0.2F;
    EXPECT_EQ(litWith({floor, squareOf(material)}, -1).pixels, whole.pixels);
    material.alphaCutoff = 0.5F;
    EXPECT_EQ(litWith({floor, squareOf(material)}, -1).pixels, bare.pixels);
    // A blended material hides in proportion to its opacity. Both opacities are too low for a shadow.
    material.alphaMode = render::AlphaMode::blend;
    material.doubleSided = true;
    const auto changeOf = [&](float opacity) {
        material.baseColor.a = opacity;
        const render::Image blended = litWith({floor, squareOf(material)}, -1);
        double sum = 0;
        for (std::size_t i = 0; i < bare.pixels.size(); ++i)
            sum += std::abs(double{blended.pixels[i]} - double{bare.pixels[i]});
        return sum;
    };
    EXPECT_EQ(changeOf(0), 0);
    const double some = changeOf(0.2F);
    EXPECT_GT(some, 0.1);
    EXPECT_NEAR(changeOf(0.4F) / some, 2, 0.02);
}

TEST_F(TransparentModel, HasItsOpacityInSprites)
{
    const TemporaryFolder folder;
    float opacity = 0;
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
        const auto frames = drawSprite(modelParameters().initial(), subject, {1, 1, {24, 24}, {}}, gallery().renderer);
        opacity = 0;
        for (std::size_t i = 3; i < frames.front().color.pixels.size(); i += 4)
            opacity = std::max(opacity, frames.front().color.pixels[i]);
        return seenPixels(frames.front());
    };
    std::vector<std::string> warnings;
    const int whole = seenOf("OPAQUE", 0.3, warnings);
    EXPECT_GT(whole, 20);
    EXPECT_TRUE(warnings.empty());
    EXPECT_FAILURE(seenOf("MASK", 0.3, warnings), "glass.glb is to be seen: every pixel");
    EXPECT_EQ(seenOf("MASK", 0.8, warnings), whole);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(opacity, 1);
    EXPECT_EQ(seenOf("BLEND", 0.3, warnings), whole);
    EXPECT_NEAR(opacity, 0.3, 0.002);
    EXPECT_TRUE(warnings.empty());
    EXPECT_FAILURE(seenOf("BLEND", 0, warnings), "glass.glb is to be seen");
}

/// Writes a box of 1 m with its center at `place`, which an animation may move by `way`.
std::string writeBox(const TemporaryFolder& folder, const glm::vec3& place, const glm::vec3& way = glm::vec3(0))
{
    GltfBuilder b;
    std::vector<float> corners;
    for (int i = 0; i < 8; ++i)
        for (const int axis : {0, 1, 2}) corners.push_back((i >> axis & 1) != 0 ? 0.5F : -0.5F);
    const render::Json primitive{{"attributes", {{"POSITION", b.floats(corners, "VEC3")}}},
                                 {"indices", b.indices({0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                                        2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3})}};
    b.json["meshes"].push_back(render::Json{{"primitives", render::Json::array({primitive})}});
    const int node = b.node({{"mesh", 0U}, {"translation", {place.x, place.y, place.z}}});
    if (way != glm::vec3(0)) {
        const glm::vec3 end = place + way;
        b.json["animations"] = render::Json::array(
            {{{"samplers",
               render::Json::array({{{"input", b.floats({0, 1}, "SCALAR")},
                                     {"output", b.floats({place.x, place.y, place.z, end.x, end.y, end.z}, "VEC3")}}})},
              {"channels", render::Json::array(
                               {{{"sampler", 0U},
                                 {"target", {{"node", static_cast<unsigned>(node)}, {"path", "translation"}}}}})}}});
    }
    const std::string path = (folder / "box.glb").string();
    writeBytes(path, b.glb());
    return path;
}

class SpriteFraming : public GlTest {
protected:
    const TemporaryFolder folder;

    std::vector<SpriteFrame> framesOf(const std::string& path, const SpriteRequest& request)
    {
        return drawSprite(modelParameters().initial(), SpriteSubject{std::filesystem::path(path)}, request,
                          gallery().renderer);
    }
};

TEST_F(SpriteFraming, HoldsAnObjectAsLargeWhereverItsFileHasIt)
{
    const SpriteRequest request{4, 1, {64, 64}, {}};
    std::vector<int> seen;
    for (const SpriteFrame& frame : framesOf(writeBox(folder, {0, 0, 0}), request)) seen.push_back(seenPixels(frame));
    EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 64 * 64 / 4);
    for (const glm::vec3& place : {glm::vec3(1, 0, 0), glm::vec3(0, 0, 3), glm::vec3(-10, 0, 10), glm::vec3(30, 0, 0),
                                   glm::vec3(0, 0, -100), glm::vec3(0, 50, 0), glm::vec3(1000, 200, 3)}) {
        const auto frames = framesOf(writeBox(folder, place), request);
        for (std::size_t i = 0; i < frames.size(); ++i)
            EXPECT_NEAR(seenPixels(frames[i]), seen[i], 0.03 * seen[i]) << place.x << ' ' << place.y << ' ' << place.z;
    }
    // The pivot is the file's origin, ten times the box's width to the side: on the left, seen from the front.
    ParameterValues front = modelParameters().initial();
    front.set(modelParameters().azimuth, 0.0);
    front.set(modelParameters().elevation, 0.0);
    const auto aside = drawSprite(front, SpriteSubject{std::filesystem::path(writeBox(folder, {10, 0, 0}))},
                                  {1, 1, {64, 64}, {}}, gallery().renderer);
    int columns = 0;
    for (int x = 0; x < 64; ++x) columns += isSeen(aside.front().color, x, 32);
    EXPECT_NEAR(aside.front().pivot.x, 32 - 10 * columns, 10);
}

TEST_F(SpriteFraming, TakesOutHowFarAnAnimationCarriesTheObject)
{
    SpriteRequest request{1, 5, {64, 64}, {}};
    const int still = seenPixels(framesOf(writeBox(folder, {0, 0, 0}), {1, 1, {64, 64}, {}}).front());
    const std::string walks = writeBox(folder, {0, 0, 0}, {0, 0, 20});
    const auto inPlace = framesOf(walks, request);
    for (const SpriteFrame& frame : inPlace) EXPECT_NEAR(seenPixels(frame), still, 0.03 * still);
    EXPECT_GT(glm::distance(inPlace.front().pivot, inPlace.back().pivot), 64);
    request.motion = SpriteMotion::kept;
    EXPECT_LT(seenPixels(framesOf(walks, request).front()), 20);
    // A movement shorter than the object is part of its animation.
    request.motion = SpriteMotion::automatic;
    const auto sways = framesOf(writeBox(folder, {0, 0, 0}, {0.6F, 0, 0}), request);
    EXPECT_NEAR(sways.front().pivot.x, sways.back().pivot.x, 1e-6);
    EXPECT_NE(sways.front().color.pixels, sways.back().color.pixels);
}

TEST_F(SpriteFraming, FailsWhereNothingIsToBeSeen)
{
    GltfBuilder empty;
    empty.node({{"name", "nothing"}});
    GltfBuilder points;
    points.triangle();
    points.json["meshes"][0]["primitives"][0]["mode"] = 0U;
    points.node({{"mesh", 0U}});
    GltfBuilder flat;
    flat.node({{"mesh", flat.triangle()}, {"scale", {0, 0, 0}}});
    const std::pair<const GltfBuilder*, const char*> cases[] = {
        {&empty, "no triangles"}, {&points, "no triangles"}, {&flat, "scaled to a point"}};
    for (const auto& [builder, why] : cases) {
        const std::string path = (folder / "a.glb").string();
        writeBytes(path, builder->glb());
        EXPECT_FAILURE(framesOf(path, {2, 2, {32, 32}, {}}), why);
        // The exhibit shows its own world instead, and the hall nothing. Both report it.
        render::AssetStore assets;
        ParameterValues values = modelParameters().initial();
        values.set(modelParameters().model, path);
        const PosedModel posed = posedModel(modelParameters(), values, 0, assets);
        EXPECT_FALSE(posed.model);
        EXPECT_NE(posed.failure.english().find(why), std::string::npos) << posed.failure;
    }
}

}  // namespace
}  // namespace vitrine::pixel_art

// A glTF object drawn in the hall and as a sprite: both show the colors of its materials.

#include "exhibits/jobs/sprite/sprite_shots.h"
#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/image/image_io.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/support/gallery.h"
#include "tests/support/image_bytes.h"
#include "tests/support/tables.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>

namespace vitrine {
namespace {

using render::Json;
using namespace test;

constexpr float gray = 0.5F;  ///< Gray of the square above each tested one, in the same light.

std::string pngOf(const std::vector<glm::vec4>& pixels, int width)
{
    const test::TemporaryFolder folder;
    render::Image image(width, static_cast<int>(pixels.size()) / width, 4);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) image.pixels[4 * i + k] = pixels[i][static_cast<glm::length_t>(k)];
    writePicture(folder / "a.png", image, render::PictureFormat::png8);
    return "data:image/png;base64," + test::base64(test::bytesOf(folder / "a.png"));
}

/// Row of squares of 1 m that face +z, each with a gray one above it.
class Squares {
public:
    Squares()
    {
        builder_.json["materials"] = Json::array({material({gray, gray, gray, 1})});
        builder_.json["images"] = builder_.json["textures"] = builder_.json["samplers"] = Json::array();
    }

    /// Adds a square; `more` sets its attributes beside the color. Returns its material.
    Json& add(const glm::vec4& color, const std::vector<float>& vertexColor = {})
    {
        square(static_cast<float>(count_), 1, 0, 0, {});
        ++count_;
        return behind(color, vertexColor, 0);
    }
    /// Adds a square behind the last one, at this distance.
    Json& behind(const glm::vec4& color, const std::vector<float>& vertexColor = {}, float far = 0.1F)
    {
        builder_.json["materials"].push_back(material(color));
        square(static_cast<float>(count_ - 1), 0, -far, builder_.json["materials"].size() - 1, vertexColor);
        return builder_.json["materials"].back();
    }
    /// Adds a texture and returns its index.
    unsigned texture(const std::vector<glm::vec4>& pixels, int width, int filter)
    {
        const auto n = static_cast<unsigned>(builder_.json["textures"].size());
        builder_.json["images"].push_back(Json{{"uri", pngOf(pixels, width)}});
        builder_.json["samplers"].push_back(Json{{"magFilter", filter}, {"minFilter", filter}});
        builder_.json["textures"].push_back(Json{{"source", n}, {"sampler", n}});
        return n;
    }

    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] std::string glb() const { return builder_.glb(); }

private:
    static Json material(const glm::vec4& c)
    {
        return Json{{"doubleSided", true},
                    {"pbrMetallicRoughness", Json{{"baseColorFactor", Json::array({c.x, c.y, c.z, c.w})},
                                                  {"metallicFactor", 0.0},
                                                  {"roughnessFactor", 1.0}}}};
    }
    /// The second texture coordinates are the first ones, moved by half of the picture.
    void square(float x, float y, float z, std::size_t material, const std::vector<float>& color)
    {
        Json attributes;
        attributes["POSITION"] = builder_.floats({x, y, z, x + 1, y, z, x + 1, y + 1, z, x, y + 1, z}, "VEC3");
        attributes["TEXCOORD_0"] = builder_.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
        attributes["TEXCOORD_1"] = builder_.floats({0.5F, 1, 1.5F, 1, 1.5F, 0, 0.5F, 0}, "VEC2");
        if (!color.empty()) attributes["COLOR_0"] = builder_.floats(color, "VEC4");
        const Json primitive{
            {"attributes", attributes}, {"indices", builder_.indices({0, 1, 2, 0, 2, 3})}, {"material", material}};
        builder_.json["meshes"].push_back(Json{{"primitives", Json::array({primitive})}});
        builder_.node({{"mesh", builder_.json["meshes"].size() - 1}});
    }

    GltfBuilder builder_;
    int count_ = 0;
};

/// Linear light at a place of the row of squares: x in squares from the left, y from their lower edges, z toward the
/// eye.
using LightAt = std::function<glm::dvec3(const glm::dvec3& place)>;

/// Returns the ratio of a square's light at a point to that of the gray one above it: its color, whatever the light.
glm::dvec3 colorBy(const LightAt& light, int square, glm::dvec2 at = {0.5, 0.5})
{
    const glm::dvec3 above = light({square + at.x, 1.5, 0});
    return static_cast<double>(gray) * light({square + at.x, at.y, 0}) / above;
}

glm::dvec3 pixelAt(const render::Image& image, const glm::dvec2& at)
{
    const int x = std::clamp(static_cast<int>(at.x), 0, image.width - 1);
    const int y = std::clamp(static_cast<int>(at.y), 0, image.height - 1);
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

LightAt inTheHall(const std::string& file, int squares)
{
    test::Shot shot;
    shot.inHall().size(640, 320).see({0, 1.15, 3.2}, {0, 1.1, 2});
    shot.request.frame.subject.reset();
    shot.request.frame.time = 0;
    ParameterValues& hall = shot.hall();
    letTheSunIn(hall);
    hall.set(hallTable().sunTemperature, 4700.0);  // Has less color than the initial one.
    for (const Toggle* off : {&hallTable().sunShadows, &hallTable().reflectionProbe, &hallTable().contactShadows})
        hall.set(*off, false);
    const hall::OwnObjectParameters& rows = hallTable().objects.front();
    hall.set(rows.model, file);
    // High up and small, so that the light on it is uniform.
    hall.set(rows.modelStand, hall::ObjectStand::ownPlinth);
    hall.set(rows.modelPlinthHeight, 1.0);
    hall.set(rows.modelSize, 0.8);
    hall.set(rows.modelAcross, 0.0);
    hall.set(rows.modelAlong, 2.0);
    hall.set(rows.modelRotation, 0.0);
    const auto prepared = gallery().museum.prepare(shot.sceneState, shot.request.frame);
    const render::Box box = gallery().museum.surroundings().ownObjects(prepared).front().box;
    const test::Picture picture = shot.take();
    const double scale = (box.high.x - box.low.x) / squares;
    return [=](const glm::dvec3& place) {
        const glm::dvec3 world(box.low.x + scale * place.x, box.low.y + scale * place.y, box.high.z + scale * place.z);
        const glm::dvec4 clip = picture.view.clipFromWorld * glm::dvec4(world, 1);
        const glm::dvec2 ndc(clip.x / clip.w, clip.y / clip.w);
        return pixelAt(picture.image, glm::dvec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) *
                                          glm::dvec2(picture.width(), picture.height()));
    };
}

LightAt asSprite(const std::string& file, int squares)
{
    const pixel_art::PixelArtTable look;
    ParameterValues values = look.initial();
    values.set(look.shadows, false);
    values.set(look.bands, 1);
    values.set(look.outlineStrength, 0.0);
    values.set(look.highlightStrength, 0.0);
    values.set(look.azimuth, 0.0);
    values.set(look.elevation, 0.0);
    const auto frames = jobs::drawSprite(values, jobs::SpriteSubject{std::filesystem::path(file)},
                                         {1, 1, {480, 240}, {}}, gallery().renderer);
    const render::Image image = frames.front().color;
    glm::dvec2 low(1e9), high(-1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (!jobs::isSeen(image, x, y)) continue;
            low = glm::min(low, glm::dvec2(x, y));
            high = glm::max(high, glm::dvec2(x + 1, y + 1));
        }
    return [=](const glm::dvec3& place) {
        const double scale = (high.x - low.x) / squares;
        return pixelAt(image, {low.x + scale * place.x, high.y - scale * place.y});
    };
}

class OneMaterial : public test::GlTest {
protected:
    /// Compares the colors of both renderers with the true ones.
    static void expectColor(const std::array<LightAt, 2>& light, int square, const glm::dvec3& truth,
                            glm::dvec2 at = {0.5, 0.5})
    {
        // A rough surface reflects 4 % of the hall in addition to its color, and lamps that are brighter than its
        // illumination: at most 0.085 relative to a gray of 0.5. Sprites have colors of 8 bits or better.
        const double tolerances[] = {0.1, 0.01};
        for (std::size_t i = 0; i < 2; ++i) {
            const glm::dvec3 off = glm::abs(colorBy(light.at(i), square, at) - truth);
            EXPECT_LT(std::max({off.x, off.y, off.z}), tolerances[i])
                << (i == 0 ? "in the hall" : "as a sprite") << ", square " << square;
        }
    }
};

using LongOneMaterial = OneMaterial;

TEST_F(LongOneMaterial, ReadsItsPicturesWhereTheFileSays)
{
    constexpr int nearest = 9728;
    const glm::vec4 red(0.6, 0.05, 0.05, 1), blue(0.05, 0.05, 0.6, 1), white(1, 1, 1, 1), black(0, 0, 0, 1);
    Squares squares;
    // Pictures of two columns. The second set of coordinates swaps them, and a transform turns them into rows.
    const unsigned columns = squares.texture({red, blue, red, blue}, 2, nearest);
    const unsigned glow = squares.texture({black, white, black, white}, 2, nearest);
    const Json second{{"index", columns}, {"texCoord", 1}};
    const Json turned{{"index", columns},
                      {"extensions", Json{{"KHR_texture_transform", Json{{"rotation", std::numbers::pi / 2}}}}}};
    squares.add(white)["pbrMetallicRoughness"]["baseColorTexture"] = second;
    squares.add(white)["pbrMetallicRoughness"]["baseColorTexture"] = turned;
    // Two places in one material: its color by the first coordinates, its glow by the second.
    Json& two = squares.add(white);
    two["pbrMetallicRoughness"]["baseColorTexture"] = Json{{"index", columns}};
    two["emissiveFactor"] = Json::array({0.25, 0.25, 0.25});
    two["emissiveTexture"] = Json{{"index", glow}, {"texCoord", 1}};
    // A mask that is read by the second coordinates, with the color behind it in its hole.
    Json& mask = squares.add(white);
    mask["alphaMode"] = "MASK";
    // A flat normal map takes the first coordinates. Its code is 128, 128, 255.
    mask["normalTexture"] = Json{{"index", squares.texture({{0.21586, 0.21586, 1, 1}}, 1, nearest)}};
    mask["pbrMetallicRoughness"]["baseColorTexture"] =
        Json{{"index", squares.texture({red, {0, 0, 0, 0}, red, {0, 0, 0, 0}}, 2, nearest)}, {"texCoord", 1}};
    squares.behind(blue);

    const test::TemporaryFolder folder;
    const std::string file = folder / "squares.glb";
    test::writeBytes(file, squares.glb());
    const std::array<LightAt, 2> light{inTheHall(file, squares.count()), asSprite(file, squares.count())};
    expectColor(light, 0, blue, {0.25, 0.5});
    expectColor(light, 0, red, {0.75, 0.5});
    // The column of the picture is chosen by v, which is 0 at the upper edge of a square.
    expectColor(light, 1, red, {0.5, 0.75});
    expectColor(light, 1, blue, {0.5, 0.25});
    for (const LightAt& at : light) {
        const glm::dvec3 glowing = at({2.25, 0.5, 0}), plain = at({2.25, 1.5, 0});
        EXPECT_GT(glowing.z, 1.5 * static_cast<double>(red.z) / static_cast<double>(gray) * plain.z);
    }
    expectColor(light, 2, blue, {0.75, 0.5});
    expectColor(light, 3, blue, {0.25, 0.5});
    expectColor(light, 3, red, {0.75, 0.5});
}

TEST_F(OneMaterial, IsAsBrightAsItsColorWithoutLightIfItIsUnlit)
{
    const std::vector<float> half(16, 0.5F);
    Squares squares;
    squares.add({0.6, 0.2, 0.1, 1})["extensions"]["KHR_materials_unlit"] = Json::object();
    Json& dark = squares.add({0.3, 0.1, 0.05, 1});
    dark["extensions"]["KHR_materials_unlit"] = Json::object();
    dark["emissiveFactor"] = Json::array({1, 1, 1});  // Ignored, as the extension says.
    squares.add({0.6, 0.2, 0.1, 1}, half)["extensions"]["KHR_materials_unlit"] = Json::object();
    const test::TemporaryFolder folder;
    const std::string file = folder / "squares.glb";
    test::writeBytes(file, squares.glb());
    const LightAt hall = inTheHall(file, squares.count()), sprite = asSprite(file, squares.count());
    for (int c = 0; c < 3; ++c) {
        const double color = glm::dvec3(0.6, 0.2, 0.1)[c];
        // The shot averages radiance, without a tone curve.
        EXPECT_NEAR(hall({0.5, 0.5, 0})[c], color, 0.002);
        EXPECT_NEAR(hall({1.5, 0.5, 0})[c], 0.5 * color, 0.002);
        EXPECT_NEAR(hall({2.5, 0.5, 0})[c], 0.5 * color, 0.002);
        EXPECT_NEAR(sprite({0.5, 0.5, 0})[c], color, 0.01);
        EXPECT_NEAR(sprite({1.5, 0.5, 0})[c], 0.5 * color, 0.01);
        EXPECT_NEAR(sprite({2.5, 0.5, 0})[c], 0.5 * color, 0.01);
    }
}

TEST_F(OneMaterial, HasItsColorsInTheHallAndAsASprite)
{
    Squares squares;
    squares.add({0.7, 0.2, 0.1, 1});
    squares.add({1, 1, 1, 1}, {0.1F, 0.6F, 0.3F, 1, 0.1F, 0.6F, 0.3F, 1, 0.1F, 0.6F, 0.3F, 1, 0.1F, 0.6F, 0.3F, 1});
    const glm::vec4 red(0.6, 0.05, 0.05, 1), blue(0.05, 0.05, 0.6, 1);
    constexpr int nearest = 9728;
    squares.add({1, 1, 1, 1})["pbrMetallicRoughness"]["baseColorTexture"] =
        Json{{"index", squares.texture({red, blue, blue, red}, 2, nearest)}};
    Json& dark = squares.add({0.3, 0.3, 0.3, 1});
    dark["emissiveFactor"] = Json::array({1.0, 1.0, 1.0});
    dark["emissiveTexture"] = Json{{"index", squares.texture({{0, 0, 0, 1}}, 1, nearest)}};
    // 60 % blue over red, red only behind a fully transparent part, and a hole in the part in front.
    squares.add({0.05, 0.05, 0.6, 0.6})["alphaMode"] = "BLEND";
    squares.behind(red);
    squares.add({0.05, 0.05, 0.6, 0})["alphaMode"] = "BLEND";
    squares.behind(red);
    Json& mask = squares.add({0.05, 0.05, 0.6, 0.4});
    mask["alphaMode"] = "MASK";
    mask["alphaCutoff"] = 0.5;
    squares.behind(red);
    // Opacity of the vertices is applied like that of the material.
    squares.add({0.05, 0.05, 0.6, 1}, {1, 1, 1, 0.25F, 1, 1, 1, 0.25F, 1, 1, 1, 0.25F, 1, 1, 1, 0.25F})["alphaMode"] =
        "BLEND";
    squares.behind(red);

    const test::TemporaryFolder folder;
    const std::string file = folder / "squares.glb";
    test::writeBytes(file, squares.glb());
    const std::array<LightAt, 2> light{inTheHall(file, squares.count()), asSprite(file, squares.count())};
    expectColor(light, 0, {0.7, 0.2, 0.1});
    expectColor(light, 1, {0.1, 0.6, 0.3});
    // Beside the center, a filtered texture would be between its two colors.
    expectColor(light, 2, red, {0.4, 0.6});
    expectColor(light, 2, blue, {0.6, 0.6});
    expectColor(light, 3, {0.3, 0.3, 0.3});
    expectColor(light, 4, 0.6 * glm::dvec3(blue) + 0.4 * glm::dvec3(red));
    expectColor(light, 5, red);
    expectColor(light, 6, red);
    expectColor(light, 7, 0.25 * glm::dvec3(blue) + 0.75 * glm::dvec3(red));
}

}  // namespace
}  // namespace vitrine

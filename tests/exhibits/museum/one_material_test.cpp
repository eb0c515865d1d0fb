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
    void square(float x, float y, float z, std::size_t material, const std::vector<float>& color)
    {
        Json attributes;
        attributes["POSITION"] = builder_.floats({x, y, z, x + 1, y, z, x + 1, y + 1, z, x, y + 1, z}, "VEC3");
        attributes["TEXCOORD_0"] = builder_.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
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
    for (const Toggle* off : {&hallTable().sunShadows, &hallTable().reflectionProbe, &hallTable().contactShadows})
        hall.set(*off, false);
    const OwnObjectRows& rows = hallTable().objects.front();
    hall.set(rows.model, file);
    // High up and small, so that the light on it is uniform.
    hall.set(rows.modelStand, ObjectStand::ownPlinth);
    hall.set(rows.modelPlinthHeight, 1.0);
    hall.set(rows.modelSize, 0.8);
    hall.set(rows.modelAcross, 0.0);
    hall.set(rows.modelAlong, 2.0);
    hall.set(rows.modelRotation, 0.0);
    const auto prepared = gallery().museum.prepare(shot.sceneState, shot.request.frame);
    const render::Box box = gallery().museum.ownObjects(prepared).front().box;
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
    const PixelArtTable look;
    ParameterValues values = look.initial();
    values.set(look.shadows, false);
    values.set(look.bands, 1);
    values.set(look.outlineStrength, 0.0);
    values.set(look.highlightStrength, 0.0);
    values.set(look.azimuth, 0.0);
    values.set(look.elevation, 0.0);
    const auto frames =
        drawSprite(values, SpriteSubject{std::filesystem::path(file)}, {1, 1, {480, 240}, {}}, gallery().renderer);
    const render::Image image = frames.front().color;
    glm::dvec2 low(1e9), high(-1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (!isSeen(image, x, y)) continue;
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

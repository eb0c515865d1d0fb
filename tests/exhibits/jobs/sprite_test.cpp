// Palettes, and sprite sheets as other readers of their description find them.

#include "exhibits/jobs/sprite/palette_file.h"
#include "exhibits/jobs/sprite/sprite_animation.h"
#include "exhibits/jobs/sprite/sprite_description.h"
#include "exhibits/jobs/sprite/sprite_files.h"
#include "exhibits/jobs/sprite/sprite_sheet.h"
#include "exhibits/pixel_art/palette.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <tuple>

namespace vitrine::jobs {
namespace {

using pixel_art::linearOf;
using pixel_art::mainColors;
using pixel_art::nearestColor;
using pixel_art::PaletteName;
using pixel_art::paletteTextures;
using pixel_art::PaletteTextures;
using pixel_art::Rgb8;
using pixel_art::shippedPalette;
using render::Image;
using test::TemporaryFolder;

constexpr PaletteName shipped[] = {PaletteName::isle, PaletteName::gameBoy, PaletteName::nes,
                                   PaletteName::c64,  PaletteName::ega,     PaletteName::spectrum,
                                   PaletteName::msx,  PaletteName::pico8,   PaletteName::oneBit};

auto keyOf(const Rgb8& c)
{
    return std::tuple(c.r, c.g, c.b);
}

TEST(Palettes, AreAtLeastEightWithoutRepetition)
{
    std::set<std::vector<std::tuple<int, int, int>>> all;
    for (const PaletteName name : shipped) {
        const auto colors = shippedPalette(name);
        std::set<std::tuple<int, int, int>> seen;
        for (const Rgb8& c : colors) seen.insert(keyOf(c));
        EXPECT_GE(colors.size(), 2U);
        EXPECT_EQ(seen.size(), colors.size()) << static_cast<int>(name);
        all.insert({seen.begin(), seen.end()});
    }
    EXPECT_GE(all.size(), 8U);
    EXPECT_TRUE(shippedPalette(PaletteName::none).empty());
}

TEST(Palettes, TexturesHoldTheColorsByLuminanceAndTheNearestOfEach)
{
    for (const PaletteName name : shipped) {
        const auto given = shippedPalette(name);
        const PaletteTextures made = paletteTextures({given.begin(), given.end()});
        ASSERT_EQ(made.colors.size(), given.size());
        double last = -1;
        for (const Rgb8& c : made.colors) {
            const glm::vec3 l = linearOf(c);
            const double y = 0.2126 * l.r + 0.7152 * l.g + 0.0722 * l.b;
            EXPECT_GE(y, last - 1e-6);
            last = y;
        }
        std::mt19937 random(3);
        for (int i = 0; i < 500; ++i) {
            const glm::ivec3 cell(random() % 32, random() % 32, random() % 32);
            const auto light = [](int step) { return static_cast<float>(render::linearFromSrgb(step / 31.0)); };
            const glm::vec3 linear(light(cell.x), light(cell.y), light(cell.z));
            const int found = made.nearest->bytes[static_cast<std::size_t>(cell.x + 32 * cell.y + 1024 * cell.z)];
            EXPECT_EQ(found, nearestColor(made.colors, linear));
        }
    }
}

TEST(Palettes, OfAPictureOfFewColorsAreTheseColors)
{
    const auto wanted = shippedPalette(PaletteName::pico8);
    Image image(64, 32, 3);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec3 c = linearOf(wanted[static_cast<std::size_t>((x / 4 + 5 * (y / 8)) % 16)]);
            for (int k = 0; k < 3; ++k) image.at(x, y, k) = c[k];
        }
    std::vector<Rgb8> found = mainColors(image, 16);
    ASSERT_EQ(found.size(), 16U);
    for (const Rgb8& c : wanted) EXPECT_NE(std::find(found.begin(), found.end(), c), found.end());
    EXPECT_EQ(mainColors(image, 64).size(), 16U);
    EXPECT_LE(mainColors(image, 5).size(), 5U);
    EXPECT_EQ(found, mainColors(image, 16));
}

/// Returns frames with moving disks, in colors that no palette contains.
std::vector<SpriteFrame> disks(int directions, int each, glm::ivec2 size)
{
    std::vector<SpriteFrame> frames;
    for (int i = 0; i < directions * each; ++i) {
        SpriteFrame frame;
        frame.direction = i / each;
        frame.color = frame.normal = Image(size.x, size.y, 4);
        frame.depth = Image(size.x, size.y, 1);
        frame.pivot = {0.5 * size.x, size.y - 3.0};
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                if (std::hypot(x - 6 - i % 5, y - 8 - i % 3) > 5) continue;
                for (int k = 0; k < 3; ++k) {
                    frame.color.at(x, y, k) = 0.01F * static_cast<float>((x * 7 + y * 3 + i + 31 * k) % 97);
                    frame.normal.at(x, y, k) = k == 2 ? 0.8F : 0.1F * static_cast<float>(x % 6);
                }
                frame.color.at(x, y, 3) = frame.normal.at(x, y, 3) = 1;
                frame.depth.at(x, y) = 0.5F;
            }
        frames.push_back(std::move(frame));
    }
    return frames;
}

TEST(SpriteSheet, AnotherReaderFindsEveryFrameWhereItsDescriptionSays)
{
    for (const bool trimmed : {false, true})
        for (const glm::ivec2 size : {glm::ivec2(24, 20), glm::ivec2(17, 31)}) {
            const std::vector<SpriteFrame> frames = disks(3, 4, size);
            SpriteSheetOptions options;
            options.trimmed = trimmed;
            options.colors = 8;
            options.imageName = "disks.png";
            const SpriteSheet sheet = spriteSheet(frames, options);
            const auto json = nlohmann::json::parse(sheet.description);
            ASSERT_EQ(json["frames"].size(), 12U);
            EXPECT_EQ(json["meta"]["image"], "disks.png");
            EXPECT_EQ(json["meta"]["size"]["w"], sheet.color.width);
            EXPECT_EQ(json["meta"]["size"]["h"], sheet.color.height);
            EXPECT_EQ(json["meta"]["frameTags"].size(), 3U);
            EXPECT_EQ(json["meta"]["frameTags"][1]["from"], 4);
            EXPECT_EQ(json["meta"]["frameTags"][1]["to"], 7);
            EXPECT_EQ(json["meta"]["slices"][0]["keys"][5]["pivot"]["y"], size.y - 3);
            std::vector<int> covered(sheet.color.pixels.size() / 4, 0);
            for (std::size_t i = 0; i < frames.size(); ++i) {
                const auto& entry = json["frames"][i];
                EXPECT_EQ(entry["sourceSize"]["w"], size.x);
                EXPECT_EQ(entry["trimmed"], trimmed);
                Image whole(size.x, size.y, 4);
                for (int y = 0; y < entry["frame"]["h"].get<int>(); ++y)
                    for (int x = 0; x < entry["frame"]["w"].get<int>(); ++x) {
                        const int fromX = x + entry["frame"]["x"].get<int>(),
                                  fromY = y + entry["frame"]["y"].get<int>();
                        ASSERT_LT(fromX, sheet.color.width);
                        ASSERT_LT(fromY, sheet.color.height);
                        ++covered[static_cast<std::size_t>(fromY * sheet.color.width + fromX)];
                        for (int k = 0; k < 4; ++k)
                            whole.at(x + entry["spriteSourceSize"]["x"].get<int>(),
                                     y + entry["spriteSourceSize"]["y"].get<int>(), k) =
                                sheet.color.at(fromX, fromY, k);
                        EXPECT_EQ(sheet.normal.at(fromX, fromY, 3), sheet.color.at(fromX, fromY, 3));
                        EXPECT_EQ(sheet.depth.at(fromX, fromY) > 0, sheet.color.at(fromX, fromY, 3) > 0);
                    }
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) EXPECT_EQ(whole.at(x, y, 3), frames[i].color.at(x, y, 3)) << i;
            }
            // No two frames share a texel.
            EXPECT_LE(*std::max_element(covered.begin(), covered.end()), 1);
        }
}

/// Phaser 3.60 to 4.2, AnimationManager.createFromAseprite, asks the sheet's texture for frames named by their numbers
/// and the JSON for `frames[number].duration`, for each tag from `from` to `to`; names of tags are keys of one list for
/// the whole game. Its parser of arrays (textures/parsers/JSONArray.js) names frames by `filename`.
TEST(SpriteSheet, HasTheFramesAndTagsThatPhaserAsksFor)
{
    std::set<std::string> keys;
    for (const char* name : {"hero.png", "my tree.png"}) {
        SpriteSheetOptions options;
        options.imageName = name;
        const SpriteSheet sheet = spriteSheet(disks(3, 4, {24, 20}), options);
        const auto json = nlohmann::json::parse(sheet.description);
        std::set<std::string> texture;
        for (const auto& frame : json["frames"]) {
            EXPECT_TRUE(texture.insert(frame["filename"].get<std::string>()).second);
            for (const char* key : {"x", "y", "w", "h"}) EXPECT_TRUE(frame["frame"][key].is_number_integer());
        }
        for (const auto& tag : json["meta"]["frameTags"]) {
            EXPECT_TRUE(keys.insert(tag["name"].get<std::string>()).second) << tag["name"];
            EXPECT_EQ(tag["direction"], "forward");
            for (int i = tag["from"].get<int>(); i <= tag["to"].get<int>(); ++i) {
                EXPECT_TRUE(texture.contains(std::to_string(i))) << i;
                EXPECT_GT(json["frames"][static_cast<std::size_t>(i)]["duration"].get<int>(), 0);
            }
        }
    }
    EXPECT_EQ(keys.size(), 6U);
    EXPECT_TRUE(keys.contains("hero direction 0"));
}

/// Pixi 8.6.6, spritesheet/Spritesheet.js: textures are named by the keys of `frames`, animations are lists of these
/// names, and `anchor` is the pivot over the size of the frame before trimming.
TEST(SpriteSheet, HasTheFramesAnimationsAndAnchorsThatPixiAsksFor)
{
    SpriteSheetOptions options;
    options.json = SpriteJson::hash;
    options.imageName = "hero.png";
    const std::vector<SpriteFrame> frames = disks(3, 4, {24, 20});
    for (const bool trimmed : {false, true}) {
        options.trimmed = trimmed;
        const SpriteSheet sheet = spriteSheet(frames, options);
        const auto json = nlohmann::json::parse(sheet.description);
        ASSERT_TRUE(json["frames"].is_object());
        EXPECT_EQ(json["frames"].size(), frames.size());
        ASSERT_EQ(json["animations"].size(), 3U);
        std::size_t i = 0;
        for (const char* animation : {"hero direction 0", "hero direction 1", "hero direction 2"}) {
            ASSERT_EQ(json["animations"][animation].size(), 4U);
            for (const auto& name : json["animations"][animation]) {
                const auto& entry = json["frames"][name.get<std::string>()];
                EXPECT_EQ(entry["frame"]["x"], sheet.cells[i].place.x);
                EXPECT_EQ(entry["frame"]["y"], sheet.cells[i].place.y);
                EXPECT_DOUBLE_EQ(entry["anchor"]["x"].get<double>() * 24, 12);
                EXPECT_DOUBLE_EQ(entry["anchor"]["y"].get<double>() * 20, 17);
                ++i;
            }
        }
        EXPECT_EQ(i, frames.size());
    }
}

/// The object faces +Z. A camera at azimuth a stands at (sin a, cos a) in x and z, and its right is (cos a, -sin a).
TEST(SpriteSheet, NamesDirectionsByTheCompassPointThatTheFrontFacesOnThePicture)
{
    const double degree = std::numbers::pi / 180;
    const std::vector<std::pair<double, std::string>> known{{0, "S"}, {90, "W"}, {180, "N"}, {270, "E"}, {225, "NE"}};
    for (const auto& [azimuth, name] : known) EXPECT_EQ(compassPoint(azimuth * degree, 8), name);
    for (double azimuth = -360; azimuth < 720; azimuth += 45) {
        const std::string_view name = compassPoint(azimuth * degree, 8);
        const double right = -std::sin(azimuth * degree), down = std::cos(azimuth * degree);
        EXPECT_EQ(name.find('E') != std::string_view::npos, right > 0.1) << azimuth;
        EXPECT_EQ(name.find('W') != std::string_view::npos, right < -0.1) << azimuth;
        EXPECT_EQ(name.find('S') != std::string_view::npos, down > 0.1) << azimuth;
        EXPECT_EQ(name.find('N') != std::string_view::npos, down < -0.1) << azimuth;
    }
    for (int count = 1; count <= mostCompassDirections; ++count)
        for (double first = -360; first <= 360; first += 11.25) {
            std::set<std::string_view> names;
            for (int d = 0; d < count; ++d) names.insert(compassPoint((first + 360.0 * d / count) * degree, count));
            EXPECT_EQ(names.size(), static_cast<std::size_t>(count)) << count << " from " << first;
        }
}

TEST(SpriteSheet, TagsHaveCompassNamesAndTheDescriptionNamesTheMaps)
{
    std::vector<SpriteFrame> frames = disks(4, 2, {24, 20});
    for (SpriteFrame& frame : frames) frame.azimuth = frame.direction * std::numbers::pi / 2;
    SpriteSheetOptions options;
    options.imageName = "hero.png";
    options.directionNames = SpriteDirectionNames::compass;
    auto meta = nlohmann::json::parse(spriteSheet(frames, options).description)["meta"];
    EXPECT_EQ(meta["frameTags"][0]["name"], "hero S");
    EXPECT_EQ(meta["frameTags"][3]["name"], "hero E");
    EXPECT_FALSE(meta.contains("normalMap"));
    EXPECT_FALSE(meta.contains("depthMap"));
    ParameterValues values = spriteTable().initial();
    options = sheetOptions(values, SpriteSubject(), {}, "hero.png");
    meta = nlohmann::json::parse(spriteSheet(frames, options).description)["meta"];
    EXPECT_EQ(meta["normalMap"], "hero_normal.png");
    EXPECT_EQ(meta["normalY"], "up");
    EXPECT_EQ(meta["depthMap"], "hero_depth.png");
    values.set(spriteTable().normalY, SpriteNormalY::down);
    options = sheetOptions(values, SpriteSubject(), {}, "hero.png");
    EXPECT_EQ(nlohmann::json::parse(spriteSheet(frames, options).description)["meta"]["normalY"], "down");
}

TEST(SpriteSheet, TurnsOnlyTheYOfNormalsThatPointDown)
{
    std::vector<SpriteFrame> frames = disks(1, 1, {24, 20});
    frames.front().normal.at(6, 8, 1) = 0.75F;
    SpriteSheetOptions options;
    const SpriteSheet up = spriteSheet(frames, options);
    options.normalY = SpriteNormalY::down;
    const SpriteSheet down = spriteSheet(frames, options);
    EXPECT_EQ(up.normal.at(6, 8, 1), 0.875F);
    EXPECT_EQ(down.normal.at(6, 8, 1), 0.125F);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 24; ++x)
            for (int k = 0; k < 4; ++k)
                EXPECT_FLOAT_EQ(down.normal.at(x, y, k),
                                k == 1 && up.color.at(x, y, 3) > 0 ? 1 - up.normal.at(x, y, k) : up.normal.at(x, y, k));
}

/// Number of times that a text occurs in another one.
int times(const std::string& text, const std::string& part)
{
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// Godot 4.3, scene/resources: the properties of SpriteFrames, CanvasTexture and AtlasTexture. An AtlasTexture is as
/// large as its region and its margin's size together, and draws the region at the margin's position.
TEST(SpriteSheet, HasTheResourcesThatGodotAsksFor)
{
    SpriteSheetOptions options;
    options.imageName = "a \"hero\".png";
    options.normalName = "hero_normal.png";
    options.frameSeconds = 0.125;
    options.trimmed = true;
    const std::vector<SpriteFrame> frames = disks(2, 3, {24, 20});
    const SpriteSheet sheet = spriteSheet(frames, options);
    EXPECT_EQ(sheet.godot.rfind("[gd_resource type=\"SpriteFrames\" format=3]\n", 0), 0U);
    EXPECT_EQ(times(sheet.godot, "path=\"a \\\"hero\\\".png\""), 1);
    EXPECT_EQ(times(sheet.godot, "normal_texture = ExtResource(\"2\")"), 1);
    EXPECT_EQ(times(sheet.godot, "[sub_resource type=\"AtlasTexture\""), 6);
    EXPECT_EQ(times(sheet.godot, "\"name\": &\"direction "), 2);
    EXPECT_EQ(times(sheet.godot, "\"speed\": 8"), 2);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const SpriteCell& cell = sheet.cells[i];
        const auto rect = [](const char* name, glm::ivec2 at, glm::ivec2 size) {
            return std::string(name) + " = Rect2(" + std::to_string(at.x) + ", " + std::to_string(at.y) + ", " +
                   std::to_string(size.x) + ", " + std::to_string(size.y) + ")\n";
        };
        const std::string id = "id=\"frame_" + std::to_string(i) + "\"]\natlas = SubResource(\"sheet\")\n";
        EXPECT_EQ(times(sheet.godot, id + rect("region", cell.place, cell.size) +
                                         rect("margin", cell.cutOff, glm::ivec2(24, 20) - cell.size)),
                  1)
            << i;
        EXPECT_EQ(times(sheet.godot, "\"texture\": SubResource(\"frame_" + std::to_string(i) + "\")"), 1);
    }
    options.normalName.clear();
    EXPECT_EQ(times(spriteSheet(frames, options).godot, "normal_texture"), 0);
}

TEST(SpriteSheet, ShowsEachWholeFrameInTheAnimatedPicture)
{
    ParameterValues values = spriteTable().initial();
    values.set(spriteTable().width, 24);
    values.set(spriteTable().height, 20);
    const std::vector<SpriteFrame> frames = disks(2, 3, {24, 20});
    for (const SpriteAnimation kind : {SpriteAnimation::gif, SpriteAnimation::apng}) {
        values.set(spriteTable().animated, kind);
        const render::VideoSpec spec = animationSpec(values, 3, 1.0 / 12);
        EXPECT_EQ(spec.width, 24 * 11);
        EXPECT_EQ(spec.height, 20 * 11);
        EXPECT_NEAR(spec.framesPerSecond, 12, 1e-9);
        EXPECT_EQ(render::whyNoVideo(spec), "");
        SpriteSheetOptions options;
        const SpriteSheet whole = spriteSheet(frames, options);
        options.trimmed = true;
        const SpriteSheet cut = spriteSheet(frames, options);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const Image picture = animationFrame(cut, i, {24, 20}, spec);
            EXPECT_EQ(picture.pixels, animationFrame(whole, i, {24, 20}, spec).pixels);
            const float corner = kind == SpriteAnimation::gif ? 1 : 0;
            EXPECT_EQ(picture.at(0, 0, 3), corner);
            const glm::ivec2 at = whole.cells[i].place + glm::ivec2(8, 8);
            for (int k = 0; k < 4; ++k) EXPECT_EQ(picture.at(8 * 11 + 5, 8 * 11 + 5, k), whole.color.at(at.x, at.y, k));
        }
    }
    EXPECT_EQ(animationSpec(values, 1, 1.0 / 12).framesPerSecond, 4) << "directions of one frame turn slowly";
}

TEST(PaletteFiles, AreReadAsTheirProgramsWriteThem)
{
    const TemporaryFolder folder;
    const std::vector<Rgb8> wanted{{255, 128, 0}, {0, 1, 2}, {16, 32, 255}};
    // GIMP 2.10; Aseprite 1.3 adds "Channels: RGBA" and a fourth number.
    test::writeBytes(folder / "a.gpl", "GIMP Palette\nName: A\nColumns: 3\n#\n255 128   0\tOrange\n  0   1   2\n"
                                       " 16  32 255\tUntitled\n");
    test::writeBytes(folder / "b.gpl", "GIMP Palette\r\nChannels: RGBA\r\n#\r\n255 128 0 255 a\r\n0 1 2 255 b\r\n"
                                       "16 32 255 255 c\r\n");
    test::writeBytes(folder / "c.hex", "ff8000\r\n000102\n#1020FF");
    test::writeBytes(folder / "d.pal", "JASC-PAL\r\n0100\r\n3\r\n255 128 0\r\n0 1 2\r\n16 32 255\r\n");
    Image picture(5, 1, 4);
    for (int x = 0; x < 5; ++x) {
        const glm::vec3 c = linearOf(wanted[static_cast<std::size_t>(std::max(x - 1, 0) % 3)]);
        for (int k = 0; k < 3; ++k) picture.at(x, 0, k) = c[k];
        picture.at(x, 0, 3) = 1;
    }
    for (int k = 0; k < 4; ++k) picture.at(0, 0, k) = k == 3 ? 0 : 0.3F;
    render::writePicture(folder / "e.png", picture, render::PictureFormat::png8);
    for (const char* name : {"a.gpl", "b.gpl", "c.hex", "d.pal", "e.png"})
        EXPECT_EQ(readPalette(folder / name), wanted) << name;
}

TEST(PaletteFiles, ReadBackWhatWasWritten)
{
    const TemporaryFolder folder;
    const std::pair<PaletteFormat, const char*> formats[] = {
        {PaletteFormat::gpl, "a.gpl"}, {PaletteFormat::hex, "a.hex"}, {PaletteFormat::pal, "a.pal"}};
    for (const auto& [format, name] : formats) {
        for (const PaletteName shippedName : shipped) {
            const auto colors = shippedPalette(shippedName);
            test::writeBytes(folder / name, paletteText(format, {colors.begin(), colors.end()}, "A"));
            EXPECT_EQ(readPalette(folder / name), std::vector(colors.begin(), colors.end())) << name;
        }
    }
}

TEST(PaletteFiles, SayWhichLineIsWrong)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& name, const std::string& text, const std::string& part) {
        test::writeBytes(folder / name, text);
        EXPECT_FAILURE(static_cast<void>(readPalette(folder / name)), part);
    };
    refused("a.gpl", "Palette\n1 2 3\n", "line 1 is not \"GIMP Palette\"");
    refused("a.gpl", "GIMP Palette\n1 2 3\n1 2 256\n", "line 3 is not three numbers from 0 to 255");
    refused("a.gpl", "GIMP Palette\n", "has 0 colors");
    refused("a.hex", "ff8000\nff80\n", "line 2 is not a color of six hexadecimal digits");
    refused("a.hex", "ff8000ff\n", "line 1");
    refused("a.hex", "gg8000\n", "line 1");
    refused("a.pal", "RIFF", "line 1 is not \"JASC-PAL\"");
    refused("a.pal", "JASC-PAL\n0100\nmany\n", "line 3 is not the number of colors");
    refused("a.pal", "JASC-PAL\n0100\n3\n1 2 3\n", "fewer colors follow");
    std::string many;
    for (int i = 0; i < 257; ++i) many += "00000" + std::to_string(i % 10) + '\n';
    refused("a.hex", many, "has 257 colors");
    EXPECT_FAILURE(static_cast<void>(readPalette(folder / "none.hex")), "none.hex");
}

TEST(SpriteSheet, KeepsOpacitiesAndSaysWhereHardlyAnythingIsSeen)
{
    std::vector<SpriteFrame> frames = disks(1, 1, {24, 20});
    for (std::size_t i = 3; i < frames.front().color.pixels.size(); i += 4) frames.front().color.pixels[i] *= 0.25F;
    const SpriteSheet sheet = spriteSheet(frames, {});
    EXPECT_EQ(sheet.color.at(8, 8, 3), 0.25F);
    EXPECT_EQ(sheet.normal.at(8, 8, 3), 1);
    EXPECT_TRUE(sheet.warnings.empty());
    for (std::size_t i = 3; i < frames.front().color.pixels.size(); i += 4) frames.front().color.pixels[i] = 0;
    frames.front().color.at(3, 3, 3) = 1;
    ASSERT_EQ(spriteSheet(frames, {}).warnings.size(), 1U);
    EXPECT_NE(spriteSheet(frames, {}).warnings.front().find("at most 1 pixel"), std::string::npos);
}

TEST(SpriteSheet, WarnsIfAllFramesOfEachDirectionAreEqual)
{
    std::vector<SpriteFrame> frames = disks(2, 1, {24, 20});
    const auto said = [&] {
        const SpriteSheet sheet = spriteSheet(frames, {});
        return std::any_of(sheet.warnings.begin(), sheet.warnings.end(),
                           [](const std::string& w) { return w.find("are equal") != std::string::npos; });
    };
    EXPECT_FALSE(said()) << "one frame for each direction";
    for (const SpriteFrame& frame : std::vector(frames)) frames.push_back(frame);
    EXPECT_TRUE(said());
    frames.back().color.at(12, 10, 0) += 0.25F;
    EXPECT_FALSE(said()) << "one of them differs";
}

TEST(SpriteSheet, HoldsColorsOfOnePaletteOverAllFrames)
{
    SpriteSheetOptions options;
    options.colors = 7;
    for (const bool given : {false, true}) {
        if (given) {
            const auto colors = shippedPalette(PaletteName::gameBoy);
            options.palette = {colors.begin(), colors.end()};
        }
        const SpriteSheet sheet = spriteSheet(disks(2, 5, {24, 20}), options);
        EXPECT_LE(sheet.palette.size(), 7U);
        std::set<std::tuple<int, int, int>> palette, used;
        for (const Rgb8& c : sheet.palette) palette.insert(keyOf(c));
        for (std::size_t i = 0; i < sheet.color.pixels.size(); i += 4) {
            if (sheet.color.pixels[i + 3] < 0.5F) continue;
            const auto code = [&](std::size_t k) { return render::srgb8FromLinear(sheet.color.pixels[i + k]); };
            used.insert({code(0), code(1), code(2)});
        }
        EXPECT_GE(used.size(), 2U);
        for (const auto& c : used) EXPECT_TRUE(palette.contains(c));
    }
}

TEST(SpriteSheet, TakesAnEmptyFrameAndAFrameOfOneTexel)
{
    std::vector<SpriteFrame> frames = disks(1, 2, {1, 1});
    const SpriteSheet one = spriteSheet(frames, {});
    EXPECT_EQ(one.color.width, 2);
    SpriteSheetOptions trimmed;
    trimmed.trimmed = true;
    EXPECT_EQ(spriteSheet(frames, trimmed).cells.size(), 2U);
    EXPECT_THROW(static_cast<void>(spriteSheet({}, {})), std::exception);
}

/// File operations in which the rename with this number (from 0) fails.
class NoSuchRename : public render::FileOps {
public:
    explicit NoSuchRename(int number) : left_(number) {}
    int rename(const char* from, const char* to) override
    {
        if (left_-- != 0) return FileOps::rename(from, to);
        errno = EIO;
        return -1;
    }

private:
    int left_;
};

/// Publishes the files of a sheet, as the job does.
void writeSheet(const SpriteSheet& sheet, const std::filesystem::path& out,
                render::FileOps& ops = render::systemFileOps())
{
    std::vector<std::unique_ptr<render::PartFile>> staged;
    for (const render::NamedBytes& file : sheetBytes(sheet, spriteTable().initial(), out))
        staged.push_back(render::stagedFile(file.path, file.bytes, ops));
    render::publishAll(staged, ops);
}

TEST(SpriteSheet, LeavesAllOldFilesWhereALaterOneCannotBeWritten)
{
    const SpriteSheet sheet = spriteSheet(disks(2, 2, {24, 20}), {});
    {
        const TemporaryFolder folder;
        test::writeBytes(folder / "hero.png", "an older sheet");
        std::filesystem::create_directory(folder / "hero_depth.png");
        EXPECT_FAILURE(writeSheet(sheet, folder / "hero.png"), "it is a folder");
        EXPECT_EQ(test::bytesOf(folder / "hero.png"), "an older sheet");
        EXPECT_EQ(folder.files(), std::vector<std::string>{"hero.png"});
    }
    const std::vector<std::string> all{"hero.json", "hero.png", "hero_depth.png", "hero_normal.png"};
    for (int failing = 0; failing < 5; ++failing) {
        const TemporaryFolder folder;
        test::writeBytes(folder / "hero.png", "an older sheet");
        test::writeBytes(folder / "hero.json", "its description");
        NoSuchRename ops(failing);
        if (failing < 4) {
            EXPECT_FAILURE(writeSheet(sheet, folder / "hero.png", ops), "renaming");
            EXPECT_EQ(test::bytesOf(folder / "hero.png"), "an older sheet");
            EXPECT_EQ(test::bytesOf(folder / "hero.json"), "its description");
            EXPECT_EQ(folder.files(), (std::vector<std::string>{"hero.json", "hero.png"})) << failing;
        } else {  // The control: none failed.
            writeSheet(sheet, folder / "hero.png", ops);
            EXPECT_EQ(folder.files(), all);
            EXPECT_EQ(render::readImage(folder / "hero_normal.png").width, sheet.color.width);
            EXPECT_EQ(test::bytesOf(folder / "hero.json"), sheet.description);
        }
    }
}

/// Returns a frame of one color with a hole in it.
SpriteFrame plainFrame(glm::ivec2 size, const glm::vec3& color)
{
    SpriteFrame frame;
    frame.color = frame.normal = Image(size.x, size.y, 4);
    frame.depth = Image(size.x, size.y, 1);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            if (x == 3 && y == 2) continue;
            for (int k = 0; k < 3; ++k) frame.color.at(x, y, k) = color[k];
            frame.color.at(x, y, 3) = 1;
        }
    return frame;
}

TEST(SpriteDithering, KeepsTheMeanWithinThePalette)
{
    SpriteSheetOptions options;
    options.palette = {{0, 0, 0}, {255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}};
    const glm::vec3 wanted(0.31F, 0.52F, 0.44F);
    for (const SpriteDither dither :
         {SpriteDither::none, SpriteDither::ordered, SpriteDither::errorDiffusion, SpriteDither::blueNoise}) {
        options.dither = dither;
        const SpriteSheet sheet = spriteSheet({plainFrame({64, 64}, wanted)}, options);
        glm::dvec3 sum(0);
        int seen = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                if (sheet.color.at(x, y, 3) < 0.5F) continue;
                ++seen;
                const glm::vec3 c(sheet.color.at(x, y, 0), sheet.color.at(x, y, 1), sheet.color.at(x, y, 2));
                sum += glm::dvec3(c);
                EXPECT_TRUE(std::any_of(options.palette.begin(), options.palette.end(),
                                        [&](const Rgb8& p) { return linearOf(p) == c; }));
            }
        EXPECT_EQ(seen, 64 * 64 - 1);
        // The mean of sixteen colors is exact to one part in sixteen in each channel.
        const double tolerance = dither == SpriteDither::errorDiffusion ? 0.01 : 1.0 / 16;
        const glm::dvec3 off = glm::abs(sum / static_cast<double>(seen) - glm::dvec3(wanted));
        if (dither == SpriteDither::none)
            EXPECT_GT(std::max({off.r, off.g, off.b}), 0.1);  // The control.
        else
            EXPECT_LT(std::max({off.r, off.g, off.b}), tolerance) << static_cast<int>(dither);
    }
}

TEST(SpriteDithering, BlueNoiseHasNoGrid)
{
    SpriteSheetOptions options;
    options.palette = {{0, 0, 0}, {255, 255, 255}};
    // Returns how much more often a pixel equals the one four to its right than it would by chance.
    const auto repeats = [&](SpriteDither dither) {
        options.dither = dither;
        const SpriteSheet sheet = spriteSheet({plainFrame({64, 64}, glm::vec3(0.3F))}, options);
        int same = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 60; ++x) same += sheet.color.at(x, y, 0) == sheet.color.at(x + 4, y, 0);
        return same / (60.0 * 64);
    };
    EXPECT_GT(repeats(SpriteDither::ordered), 0.99);
    EXPECT_LT(repeats(SpriteDither::blueNoise), 0.7);
}

TEST(SpriteDithering, OrderedStaysWhereItIsWhenTheSheetIsTrimmed)
{
    std::vector<SpriteFrame> frames = disks(1, 3, {24, 20});
    SpriteSheetOptions options;
    options.colors = 4;
    options.dither = SpriteDither::ordered;
    const SpriteSheet whole = spriteSheet(frames, options);
    options.trimmed = true;
    const SpriteSheet cut = spriteSheet(frames, options);
    ASSERT_LT(cut.color.width, whole.color.width);
    for (std::size_t i = 0; i < frames.size(); ++i)
        for (int y = 0; y < cut.cells[i].size.y; ++y)
            for (int x = 0; x < cut.cells[i].size.x; ++x)
                for (int k = 0; k < 4; ++k)
                    EXPECT_EQ(cut.color.at(cut.cells[i].place.x + x, cut.cells[i].place.y + y, k),
                              whole.color.at(whole.cells[i].place.x + cut.cells[i].cutOff.x + x,
                                             whole.cells[i].place.y + cut.cells[i].cutOff.y + y, k));
}

TEST(SpriteSheet, HasThePivotThatIsAskedFor)
{
    SpriteSheetOptions options;
    const std::vector<SpriteFrame> frames = disks(1, 1, {24, 20});
    const auto pivot = [&](SpritePivot wanted) {
        options.pivot = wanted;
        const SpriteSheet sheet = spriteSheet(frames, options);
        const auto at = nlohmann::json::parse(sheet.description)["meta"]["slices"][0]["keys"][0]["pivot"];
        EXPECT_EQ(sheet.pivots.front(), glm::ivec2(at["x"].get<int>(), at["y"].get<int>()));
        return sheet.pivots.front();
    };
    EXPECT_EQ(pivot(SpritePivot::origin), glm::ivec2(12, 17));
    EXPECT_EQ(pivot(SpritePivot::center), glm::ivec2(12, 10));
    EXPECT_EQ(pivot(SpritePivot::bottom), glm::ivec2(12, 20));
}

}  // namespace
}  // namespace vitrine::jobs

#include "exhibits/jobs/sprite/sprite_description.h"

#include "render/files/number_text.h"
#include "render/files/strict_json.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace vitrine::jobs {
namespace {

using render::Json;

constexpr std::array<std::string_view, 16> winds{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                 "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};

/// Frames of one direction, which follow one another.
struct FrameRun {
    std::string name;  ///< "SE" or "direction 3".
    std::size_t from = 0, to = 0;
};

std::vector<FrameRun> directionsOf(const std::vector<SpriteFrame>& frames, SpriteDirectionNames names)
{
    int count = 0;
    for (const SpriteFrame& frame : frames) count = std::max(count, frame.direction + 1);
    std::vector<FrameRun> directions;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const SpriteFrame& frame = frames[i];
        if (i == 0 || frame.direction != frames[i - 1].direction)
            directions.push_back({names == SpriteDirectionNames::compass
                                      ? std::string(compassPoint(frame.azimuth, count))
                                      : "direction " + std::to_string(frame.direction),
                                  i});
        directions.back().to = i;
    }
    return directions;
}

Json box(glm::ivec2 at, glm::ivec2 size)
{
    return {{"x", at.x}, {"y", at.y}, {"w", size.x}, {"h", size.y}};
}

glm::ivec2 sizeOf(const std::vector<SpriteFrame>& frames)
{
    return {frames.front().color.width, frames.front().color.height};
}

/// The frames of a description by name, and what else a form has beside them.
struct Listed {
    Json frames, animations = Json::object();
};

Json frameJson(const SpriteCell& cell, glm::ivec2 whole, double seconds)
{
    return {{"frame", box(cell.place, cell.size)},
            {"rotated", false},
            {"trimmed", cell.size != whole},
            {"spriteSourceSize", box(cell.cutOff, cell.size)},
            {"sourceSize", {{"w", whole.x}, {"h", whole.y}}},
            {"duration", std::max(1, static_cast<int>(std::floor(1000 * seconds + 0.5)))}};
}

Listed listedAsArray(const SpriteSheet& sheet, glm::ivec2 whole)
{
    Listed listed{Json::array()};
    for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
        Json entry = {{"filename", std::to_string(i)}};
        entry.update(frameJson(sheet.cells[i], whole, sheet.frameSeconds));
        listed.frames.push_back(std::move(entry));
    }
    return listed;
}

Listed listedAsHash(const SpriteSheet& sheet, glm::ivec2 whole, const std::vector<FrameRun>& directions,
                    const std::string& stem)
{
    Listed listed{Json::object()};
    for (const FrameRun& direction : directions) {
        Json names = Json::array();
        for (std::size_t i = direction.from; i <= direction.to; ++i) {
            const std::string name = stem + direction.name + ' ' + std::to_string(i - direction.from);
            Json entry = frameJson(sheet.cells[i], whole, sheet.frameSeconds);
            const glm::dvec2 anchor = glm::dvec2(sheet.pivots[i]) / glm::dvec2(whole);
            entry["anchor"] = {{"x", anchor.x}, {"y", anchor.y}};
            listed.frames[name] = std::move(entry);
            names.push_back(name);
        }
        listed.animations[stem + direction.name] = std::move(names);
    }
    return listed;
}

/// Names of the maps, and how their codes are to be read.
void addMaps(Json& meta, const SpriteSheetOptions& options)
{
    if (!options.normalName.empty()) {
        meta["normalMap"] = options.normalName;
        meta["normalY"] = options.normalY == SpriteNormalY::up ? "up" : "down";
    }
    if (!options.depthName.empty()) {
        meta["depthMap"] = options.depthName;
        meta["depthNear"] = "white";
    }
}

/// A string of Godot's text resources.
std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) (result += c == '"' || c == '\\' ? "\\" : "") += c;
    return result + '"';
}

std::string rect(glm::ivec2 at, glm::ivec2 size)
{
    return "Rect2(" + std::to_string(at.x) + ", " + std::to_string(at.y) + ", " + std::to_string(size.x) + ", " +
           std::to_string(size.y) + ")";
}

std::string godotTextures(const SpriteSheet& sheet, const SpriteSheetOptions& options, glm::ivec2 whole)
{
    const bool lit = !options.normalName.empty();
    std::string text = "[ext_resource type=\"Texture2D\" path=" + quoted(options.imageName) + " id=\"1\"]\n";
    if (lit) text += "[ext_resource type=\"Texture2D\" path=" + quoted(options.normalName) + " id=\"2\"]\n";
    text += "\n[sub_resource type=\"CanvasTexture\" id=\"sheet\"]\ndiffuse_texture = ExtResource(\"1\")\n";
    if (lit) text += "normal_texture = ExtResource(\"2\")\n";
    text += "texture_filter = 1\n";  // CanvasItem::TEXTURE_FILTER_NEAREST.
    for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
        const SpriteCell& cell = sheet.cells[i];
        text += "\n[sub_resource type=\"AtlasTexture\" id=\"frame_" + std::to_string(i) +
                "\"]\natlas = SubResource(\"sheet\")\nregion = " + rect(cell.place, cell.size) + '\n';
        // The margin's position is what was cut off to the left and above, its size all that was cut off.
        if (cell.size != whole) text += "margin = " + rect(cell.cutOff, whole - cell.size) + '\n';
    }
    return text;
}

}  // namespace

std::string_view compassPoint(double azimuth, int directions)
{
    const double step = directions > 8 ? 1 : 2;
    const double turned = (azimuth + std::numbers::pi) / (2 * std::numbers::pi) * 16 / step;
    // Azimuths are sums of rounded angles: one that is half way between two points goes the same way as all others.
    const double nearest = step * std::floor(turned + 0.5 + 1e-9);
    return winds[static_cast<std::size_t>(nearest - 16 * std::floor(nearest / 16))];
}

std::string describe(const std::vector<SpriteFrame>& frames, const SpriteSheet& sheet,
                     const SpriteSheetOptions& options)
{
    const glm::ivec2 whole = sizeOf(frames);
    // Names begin with that of the file, so that sheets with different names have different tags.
    const std::string file = std::filesystem::path(options.imageName).stem().string();
    const std::string stem = file.empty() ? std::string() : file + ' ';
    const std::vector<FrameRun> directions = directionsOf(frames, options.directionNames);
    const bool asHash = options.json == SpriteJson::hash;
    Listed listed = asHash ? listedAsHash(sheet, whole, directions, stem) : listedAsArray(sheet, whole);
    Json tags = Json::array(), keys = Json::array();
    for (const FrameRun& direction : directions)
        tags.push_back({{"name", stem + direction.name},
                        {"from", direction.from},
                        {"to", direction.to},
                        {"direction", "forward"},
                        {"color", "#000000ff"}});
    for (std::size_t i = 0; i < frames.size(); ++i)
        keys.push_back({{"frame", i},
                        {"bounds", box({0, 0}, whole)},
                        {"pivot", {{"x", sheet.pivots[i].x}, {"y", sheet.pivots[i].y}}}});
    Json meta = {{"app", "https://www.aseprite.org/docs/cli/#data (written by Vitrine)"},
                 {"version", render::programVersion()},
                 {"image", options.imageName},
                 {"format", "RGBA8888"},
                 {"size", {{"w", sheet.color.width}, {"h", sheet.color.height}}},
                 {"scale", "1"},
                 {"frameTags", std::move(tags)},
                 {"layers", Json::array()},
                 {"slices", Json::array({{{"name", "pivot"}, {"color", "#0000ffff"}, {"keys", std::move(keys)}}})}};
    addMaps(meta, options);
    Json json = {{"frames", std::move(listed.frames)}};
    if (asHash) json["animations"] = std::move(listed.animations);
    json["meta"] = std::move(meta);
    return render::writeJson(json);
}

std::string godotResource(const std::vector<SpriteFrame>& frames, const SpriteSheet& sheet,
                          const SpriteSheetOptions& options)
{
    std::string text = "[gd_resource type=\"SpriteFrames\" format=3]\n\n";
    text += godotTextures(sheet, options, sizeOf(frames));
    text += "\n[resource]\nanimations = [";
    const std::string speed = render::shortestNumber(1 / std::max(sheet.frameSeconds, 1e-3));
    const char* between = "";
    for (const FrameRun& direction : directionsOf(frames, options.directionNames)) {
        text += between + std::string("{\n\"frames\": [");
        for (std::size_t i = direction.from; i <= direction.to; ++i)
            text += std::string(i == direction.from ? "" : ", ") +
                    "{\n\"duration\": 1.0,\n\"texture\": SubResource(\"frame_" + std::to_string(i) + "\")\n}";
        text += "],\n\"loop\": true,\n\"name\": &" + quoted(direction.name) + ",\n\"speed\": " + speed + "\n}";
        between = ", ";
    }
    return text + "]\n";
}

}  // namespace vitrine::jobs

#include "exhibits/hall/hall_surfaces.h"

#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"

#include <cmath>
#include <utility>

namespace vitrine::hall {
namespace {

using render::Json;

Json readTable(const char* relative)
{
    return render::readJson(render::asset(relative)).root();
}

using TextureInTheMaking = std::future<std::shared_ptr<const render::Texture>>;

/// Reads a texture on another thread.
TextureInTheMaking map(const Json& row, const char* key, bool sRgb)
{
    const auto file = row.find(key);
    if (file == row.end() || !file->is_string()) return {};
    return std::async(std::launch::async, [path = render::asset("models/" + file->get<std::string>()), sRgb] {
        return render::loadTexture(path, sRgb, true);
    });
}

/// Value of a channel between the texels of a texture that repeats. `x` and `y` are in texels.
double between(const render::Texture& texture, double x, double y, int channel)
{
    const double left = std::floor(x), low = std::floor(y);
    const auto at = [&](int dx, int dy) {
        const int column = (static_cast<int>(left) + dx + texture.width) % texture.width;
        const int row = (static_cast<int>(low) + dy + texture.height) % texture.height;
        return static_cast<double>(
            texture.bytes[static_cast<std::size_t>((row * texture.width + column) * texture.channels + channel)]);
    };
    const double u = x - left, v = y - low;
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
}

/// Returns Material::surfaceMap from a normal map, if there is one, and a map of occlusion, roughness and metalness.
std::shared_ptr<const render::Texture> surfaceMap(const render::Texture* normal, const render::Texture& orm)
{
    auto map = std::make_shared<render::Texture>();
    map->name = orm.name;
    const render::Texture& size = normal ? *normal : orm;
    map->width = size.width;
    map->height = size.height;
    map->bytes.reserve(std::size_t{4} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    const double across = double(orm.width) / size.width, up = double(orm.height) / size.height;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto texel = static_cast<std::size_t>((y * size.width + x) * size.channels);
            for (std::size_t c = 0; c < 2; ++c) map->bytes.push_back(normal ? normal->bytes[texel + c] : 128);
            for (const int c : {1, 0})
                map->bytes.push_back(
                    static_cast<std::uint8_t>(0.5 + between(orm, (x + 0.5) * across - 0.5, (y + 0.5) * up - 0.5, c)));
        }
    }
    return map;
}

std::shared_ptr<const render::Texture> made(TextureInTheMaking& texture)
{
    return texture.valid() ? texture.get() : nullptr;
}

/// Makes the surface map of a material on another thread, from the two maps that the table names.
TextureInTheMaking surface(const Json& row)
{
    TextureInTheMaking normal = map(row, "normal", false), orm = map(row, "orm", false);
    if (!orm.valid()) return {};
    return std::async(std::launch::async, [normal = std::move(normal), orm = std::move(orm)]() mutable {
        const std::shared_ptr<const render::Texture> slopes = made(normal);
        return surfaceMap(slopes.get(), *orm.get());
    });
}

/// Returns the materials with the textures that the table names.
std::map<std::string, HallMaterial> textured(std::map<std::string, HallMaterial> materials, const Json& table)
{
    struct Maps {
        TextureInTheMaking baseColor, surface;
    };
    std::map<std::string, Maps> maps;
    for (const auto& [name, row] : table.items()) maps[name] = {map(row, "color", true), surface(row)};
    for (auto& [name, making] : maps) {
        render::Material& material = materials.at(name).material;
        material.baseColorMap = made(making.baseColor);
        material.surfaceMap = made(making.surface);
    }
    return materials;
}

HallLightmaps readLightmaps(const std::string& skyFile)
{
    try {
        auto sky =
            std::make_shared<render::Texture>(*render::loadTexture(render::asset("models/" + skyFile), false, false));
        sky->mipmaps = false;
        return {std::move(sky), SunTransfer(readTable("models/hall_bounce.json")),
                LampLight(readTable("models/hall_lamps.json"))};
    } catch (const Json::exception& error) {
        throw Failure(ErrorKind::file,
                      "assets/models/hall_bounce.json or hall_lamps.json: " + std::string(error.what()) +
                          "; reinstall the program, or write them anew with the scripts beside them.");
    }
}

}  // namespace

HallSurfaces::HallSurfaces()
{
    const Json materials = readTable("models/materials.json");
    for (const auto& [name, row] : materials.items()) {
        HallMaterial entry;
        entry.tile = row.value("tile", 1.0);
        entry.hasNormalMap = row.contains("normal") && row["normal"].is_string();
        entry.material.name = name;
        entry.material.roughness = row.value("roughness", 0.7F);
        if (const auto color = row.find("baseColor"); color != row.end())
            entry.material.baseColor = {(*color)[0].get<float>(), (*color)[1].get<float>(), (*color)[2].get<float>(),
                                        1.0F};
        const Json& mean = row.at("mean");
        entry.material.metalness = mean.at("metalness").get<float>();  // It is the same everywhere on a surface.
        const Json& color = mean.at("baseColor");
        entry.meanColor = {color[0].get<double>(), color[1].get<double>(), color[2].get<double>()};
        untextured_.emplace(name, std::move(entry));
    }
    textured_ = std::async(std::launch::deferred, textured, untextured_, materials).share();
    const Json light = readTable("models/hall_light.json");
    skyScale_ = light.at("sky").at("scale").get<double>();
    lightmaps_ =
        std::async(std::launch::deferred, readLightmaps, light.at("sky").at("file").get<std::string>()).share();
}

void HallSurfaces::startReading() const
{
    std::call_once(started_, [this] {
        readingTextures_ = std::async(std::launch::async, [textures = textured_] { textures.wait(); });
        readingLightmaps_ = std::async(std::launch::async, [lightmaps = lightmaps_] { lightmaps.wait(); });
    });
}

void HallSurfaces::read() const
{
    startReading();
    (void)textured_.get();
    (void)lightmaps_.get();
}

const HallMaterial& HallSurfaces::untextured(const std::string& name) const
{
    const auto found = untextured_.find(name);
    static const HallMaterial plain;
    return found == untextured_.end() ? plain : found->second;
}

const HallMaterial& HallSurfaces::material(const std::string& name) const
{
    const auto found = textured_.get().find(name);
    return found == textured_.get().end() ? untextured(name) : found->second;
}

}  // namespace vitrine::hall

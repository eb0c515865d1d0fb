#include "exhibits/hall/hall_surfaces.h"

#include "exhibits/hall/baked_picture.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"

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

std::shared_ptr<const render::Texture> made(TextureInTheMaking& texture)
{
    return texture.valid() ? texture.get() : nullptr;
}

/// Returns the materials with the textures that the table names.
std::map<std::string, HallMaterial> textured(std::map<std::string, HallMaterial> materials, const Json& table)
{
    struct Maps {
        TextureInTheMaking baseColor, surface;
    };
    std::map<std::string, Maps> maps;
    for (const auto& [name, row] : table.items()) maps[name] = {map(row, "color", true), map(row, "surface", false)};
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
        std::future<BakedPicture> sky = startReadingBaked(skyFile);
        SunTransfer sun(readTable("models/hall_bounce.json"));
        LampLight lamps(readTable("models/hall_lamps.json"));
        return {sky.get(), std::move(sun), std::move(lamps)};
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
        entry.hasNormalMap = row.value("hasNormals", false);
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

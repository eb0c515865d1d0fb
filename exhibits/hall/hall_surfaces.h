#pragma once

#include "exhibits/hall/sun_transfer.h"
#include "exhibits/hall/vault_lamps.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace vitrine::hall {

/// Material of the hall, from assets/models/materials.json.
struct HallMaterial {
    render::Material material;
    double tile = 1;            ///< Meters covered by one repeat of its textures.
    glm::dvec3 meanColor{0.5};  ///< Mean of its base color, linear.
    bool hasNormalMap = false;  ///< Its meshes need tangents.
};

/// Baked light of the hall.
struct HallLightmaps {
    std::shared_ptr<const render::Texture> sky;  ///< Light of the sky; its alpha is that of the lamps in the vault.
    SunTransfer sun;
    LampLight lamps;
};

/// Materials and lightmaps of the hall. Their pictures are most of its loading time and are decoded when they are first
/// needed, because many commands draw no hall. Thread-safe.
class HallSurfaces {
public:
    /// Reads the tables of materials and light. Throws Failure (ErrorKind::file) or Json::exception if one is missing
    /// or broken.
    HallSurfaces();

    /// Decodes the pictures on other threads, if that has not begun.
    void startReading() const;

    /// Returns the material of that name without its textures; a plain one if there is none.
    [[nodiscard]] const HallMaterial& untextured(const std::string& name) const;

    // The following functions wait for the pictures. They throw Failure (ErrorKind::file) if one cannot be read.

    /// Only waits, so that what follows opens no file.
    void read() const;
    /// Returns the material of that name; a plain one if there is none.
    [[nodiscard]] const HallMaterial& material(const std::string& name) const;
    [[nodiscard]] const HallLightmaps& lightmaps() const { return lightmaps_.get(); }

    /// Returns the irradiance over pi where the lightmap of the sky is 1, for a sky of radiance 1.
    [[nodiscard]] double skyScale() const { return skyScale_; }

private:
    using Materials = std::map<std::string, HallMaterial>;

    Materials untextured_;
    double skyScale_ = 1;
    std::shared_future<Materials> textured_;
    std::shared_future<HallLightmaps> lightmaps_;
    mutable std::once_flag started_;
    mutable std::future<void> readingTextures_, readingLightmaps_;
};

}  // namespace vitrine::hall

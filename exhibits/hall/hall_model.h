#pragma once

#include "exhibits/hall/hall_furniture.h"
#include "exhibits/hall/sun_transfer.h"
#include "exhibits/hall/vault_lamps.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// Number of the free plinth for the visitor's own object, behind those of all places for exhibits.
inline constexpr int freePlinthPlace = 1000;

/// A spot that can hold an exhibit. Transforms are world from local, meters.
struct Place {
    int number = 0;  ///< From 1; `freePlinthPlace` is the visitor's own plinth.
    glm::dmat4 worldFromPlace{1};
    std::optional<glm::dmat4> worldFromPlaque;            ///< +z out of the plate, +y up its text.
    std::optional<glm::dmat4> worldFromButton;            ///< +y the way out of the button.
    std::vector<render::MeshInstance> cloth;              ///< Drawn while the place is empty.
    std::vector<render::MeshInstance> stand;              ///< Drawn while it is not.
    std::vector<render::MeshInstance> hanging;            ///< The same, turned about the y axis of its node.
    std::vector<StandingShape> clothShapes, standShapes;  ///< Of both, world space.
};

/// An upright obstacle: a box (oriented by its transform) or a cylinder around its y axis.
struct Collider {
    glm::dmat4 localFromWorld{1};
    glm::dvec3 halfSize{0};  ///< Box; for a cylinder x is the radius and y half the height.
    bool cylinder = false;
};

/// A flat rectangle inside a wall: what it hides cannot be seen.
struct Occluder {
    glm::dvec3 center{0}, halfU{0}, halfV{0};
};

/// How a material of the hall is drawn: assets/models/materials.json.
struct HallMaterial {
    render::Material material;
    double tile = 1;            ///< Meters that one repeat of its pictures covers.
    glm::dvec3 meanColor{0.5};  ///< Mean of its base color, linear.
};

/// The building as read from assets/models: what is drawn, where things stand and light comes in, what stops a visitor.
/// The named nodes of hall.glb give places and sizes: assets/models/hall.py writes them. Frames on the walls for
/// further places come from assets/models/frames.json, so that they need no new model and no new bake.
class HallModel {
public:
    /// Throws Failure (Blame::file) when an asset is missing or broken.
    HallModel();

    [[nodiscard]] const std::vector<render::MeshInstance>& walls() const { return walls_; }
    [[nodiscard]] const HallMaterial& material(const std::string& name) const;
    [[nodiscard]] const Place* place(int number) const;
    [[nodiscard]] const std::map<int, Place>& places() const { return places_; }
    [[nodiscard]] const std::vector<Collider>& colliders() const { return colliders_; }
    [[nodiscard]] const std::vector<Occluder>& occluders() const { return occluders_; }
    [[nodiscard]] const render::Box& bounds() const { return bounds_; }
    /// Through these the sun shines into the hall and the sky is seen: each flat along one axis.
    [[nodiscard]] const std::vector<render::Box>& openings() const { return openings_; }
    /// The air between walls, floor and vault.
    [[nodiscard]] const render::Box& room() const { return room_; }
    /// Where the reflection probe is captured, and the box that stands for the walls in it.
    [[nodiscard]] const glm::dvec3& probe() const { return *probe_; }
    [[nodiscard]] const render::Box& probeRoom() const { return probeRoom_; }

    /// What stands on the floor and never moves, and the bars of the window.
    [[nodiscard]] const Furniture& furniture() const { return furniture_; }

    /// In its alpha that of the lamps in the vault.
    [[nodiscard]] std::shared_ptr<const render::Texture> skyLightmap() const { return skyLightmap_; }
    [[nodiscard]] double skyLightmapScale() const { return skyLightmapScale_; }
    [[nodiscard]] const SunTransfer& sunTransfer() const { return sunTransfer_; }
    [[nodiscard]] const LampLight& lampLight() const { return lampLight_; }

private:
    void readMaterials();
    void readLightmaps();
    void sortParts(const render::Model&);
    void sortMarkers(const render::Model&);
    void addFrames();

    std::vector<render::MeshInstance> walls_;
    std::map<std::string, HallMaterial> materials_;
    std::map<int, Place> places_;
    std::vector<Collider> colliders_;
    std::vector<Occluder> occluders_;
    render::Box bounds_, room_, probeRoom_;
    std::vector<render::Box> openings_;
    std::optional<glm::dvec3> probe_;  // The file has one, or is refused.
    std::shared_ptr<const render::Texture> skyLightmap_;
    double skyLightmapScale_ = 1;
    Furniture furniture_;
    SunTransfer sunTransfer_;
    LampLight lampLight_;
};

}  // namespace vitrine

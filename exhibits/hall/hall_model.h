#pragma once

#include "exhibits/hall/hall_furniture.h"
#include "exhibits/hall/hall_surfaces.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::hall {

/// Number of the free plinth for the user's own object, after those of all places for exhibits.
inline constexpr int freePlinthPlace = 1000;

/// Place for an exhibit. Transforms are world from local, in meters.
struct Place {
    int number = 0;  ///< From 1; `freePlinthPlace` is the free plinth for the user's object.
    glm::dmat4 worldFromPlace{1};
    std::optional<glm::dmat4> worldFromPlaque;            ///< +z points out of the plate, +y up along its text.
    std::optional<glm::dmat4> worldFromButton;            ///< +y points out of the button.
    std::vector<render::MeshInstance> cloth;              ///< Drawn while the place is empty.
    std::vector<render::MeshInstance> stand;              ///< Drawn while the place is occupied.
    std::vector<render::MeshInstance> hanging;            ///< As `stand`, rotated about the y axis of its node.
    std::vector<StandingShape> clothShapes, standShapes;  ///< Shapes of cloth and stand, world space.
};

/// An upright obstacle: a box (oriented by its transform) or a cylinder around its y axis.
struct Collider {
    glm::dmat4 localFromWorld{1};
    glm::dvec3 halfSize{0};  ///< Box; for a cylinder x is the radius and y half the height.
    bool cylinder = false;
};

/// Flat rectangle inside a wall, which hides what is behind it.
struct Occluder {
    glm::dvec3 center{0}, halfU{0}, halfV{0};
};

/// Returns whether this part of the walls is the floor, which has a pass of its own.
[[nodiscard]] bool isFloor(const render::MeshInstance&);

/// The building as read from assets/models: geometry, places, openings for light, and obstacles. Named nodes of
/// hall.glb give places and sizes; assets/models/hall.py writes them. Wall frames for further places come from
/// assets/models/frames.json, so they need neither a new model nor a new bake.
class HallModel {
public:
    /// Reads the assets except for pictures. Throws Failure (ErrorKind::file) if one is missing or broken.
    HallModel();

    /// Materials and baked light; their pictures are decoded when they are first needed.
    [[nodiscard]] const HallSurfaces& surfaces() const { return *surfaces_; }

    [[nodiscard]] const std::vector<render::MeshInstance>& walls() const { return walls_; }
    /// Returns a corner of every `render::Pass::trianglesPerSample`-th triangle of the walls, world space.
    [[nodiscard]] const std::shared_ptr<const std::vector<glm::vec3>>& triangleSamples() const { return samples_; }
    [[nodiscard]] const Place* place(int number) const;
    [[nodiscard]] const std::map<int, Place>& places() const { return places_; }
    [[nodiscard]] const std::vector<Collider>& colliders() const { return colliders_; }
    [[nodiscard]] const std::vector<Occluder>& occluders() const { return occluders_; }
    [[nodiscard]] const render::Box& bounds() const { return bounds_; }
    /// Returns the openings, through which the sun shines into the hall and the sky is visible; each is flat along one
    /// axis.
    [[nodiscard]] const std::vector<render::Box>& openings() const { return openings_; }
    /// Returns the air between walls, floor and vault.
    [[nodiscard]] const render::Box& room() const { return room_; }
    /// Position of the reflection probe, and the box that approximates the walls in it.
    [[nodiscard]] const glm::dvec3& probe() const { return *probe_; }
    [[nodiscard]] const render::Box& probeRoom() const { return probeRoom_; }

    /// Returns what stands on the floor and never moves, and the bars of the window.
    [[nodiscard]] const Furniture& furniture() const { return furniture_; }

private:
    void sortParts(const render::Model&);
    void sortMarkers(const render::Model&);
    void addFrames();

    std::unique_ptr<const HallSurfaces> surfaces_;  // Always set after construction.
    std::vector<render::MeshInstance> walls_;
    std::shared_ptr<const std::vector<glm::vec3>> samples_;
    std::map<int, Place> places_;
    std::vector<Collider> colliders_;
    std::vector<Occluder> occluders_;
    render::Box bounds_, room_, probeRoom_;
    std::vector<render::Box> openings_;
    std::optional<glm::dvec3> probe_;  // Always set after construction: a file without a probe is refused.
    Furniture furniture_;
};

}  // namespace vitrine::hall

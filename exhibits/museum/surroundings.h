#pragma once

#include "exhibits/framework/scene/frame_request.h"
#include "exhibits/museum/museum_exhibit.h"
#include "exhibits/museum/obstacles.h"
#include "exhibits/museum/prepared.h"
#include "exhibits/museum/scene_state.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::hall {
class Hall;
class HallModel;
struct HallScene;
}  // namespace vitrine::hall

namespace vitrine {

/// Button at the center of the view.
struct LookedAt {
    std::size_t exhibit = 0;
    std::string text;          ///< Text of the button: "E – melt it".
    Message whyDisabled = {};  ///< Full sentence if it cannot be pressed (`HasButton`); else empty.
};

/// Object under the pointer, and the camera for visiting it.
struct Pointed {
    std::size_t exhibit = 0;  ///< `hallIndex`: none; then it is the user's own object.
    std::string name;         ///< "Torus to Mug", "Your object: teddy.glb", "E – melt it", or why it is disabled.
    double distance = 0;      ///< Meters from the eye.
    bool button = false;      ///< The object is the button of `exhibit` ...
    bool inReach = false;     ///< ... and is close enough to be pressed.
    render::Camera view;      ///< Its best view, in world space.
};

/// A user's own object in the hall.
struct OwnObjectShown {
    std::size_t which = 0;  ///< Index in the hall's `objects`.
    std::string name;       ///< "Your object: teddy.glb"
    render::Box box;        ///< Bounds in world space.
    render::Camera view;    ///< Its best view, in world space.
};

/// Everything in the hall that a visitor can see, point at and walk to. Thread-safe and deterministic.
class MuseumSurroundings {
public:
    /// `sceneOf` returns the hall's scene of a prepared state. All must outlive this object.
    MuseumSurroundings(const hall::HallModel&, const hall::Hall&, std::span<const MuseumExhibit>, render::AssetStore&,
                       std::function<hall::HallScene(const Prepared&)> sceneOf);

    /// Returns where a visitor ends up who walks from `from` towards `to` (eye positions). Walls and furniture stop the
    /// visitor, who slides along them.
    [[nodiscard]] glm::dvec3 walk(const glm::dvec3& from, const glm::dvec3& to) const;
    /// The same with the user's own objects and their plinths as further obstacles.
    [[nodiscard]] glm::dvec3 walk(const Prepared&, const glm::dvec3& from, const glm::dvec3& to) const;
    /// Obstacles of the building: walls and furniture.
    [[nodiscard]] const Obstacles& obstacles() const { return building_; }
    /// The same with the user's own objects and their plinths; objects whose file cannot be read are no obstacles.
    [[nodiscard]] Obstacles obstacles(const Prepared&) const;
    /// The same without a prepared scene: reads the files in the hall's parameters.
    [[nodiscard]] Obstacles obstacles(const SceneState&) const;
    /// Returns the button within 2 m at the center of the view, unless something is in front of it.
    [[nodiscard]] std::optional<LookedAt> lookedAt(const Prepared&) const;
    /// Returns the exhibit, button or user's object at `ndc` (each -1 to 1, y up) of that picture. Returns nothing if
    /// the nearest surface there is a wall or furniture.
    [[nodiscard]] std::optional<Pointed> pick(const Prepared&, const FrameRequest&, glm::dvec2 ndc) const;
    /// Returns the user's own objects whose files could be read.
    [[nodiscard]] std::vector<OwnObjectShown> ownObjects(const Prepared&) const;
    /// Returns the distance from the eye to the surface at `ndc`, meters; infinity: the sky.
    [[nodiscard]] double distanceTo(const Prepared&, const FrameRequest&, glm::dvec2 ndc) const;

private:
    struct Seen;
    [[nodiscard]] Seen firstSeen(const Prepared&, const hall::HallScene&, const render::Ray&) const;
    [[nodiscard]] glm::dmat4 worldFrom(const Exhibit&) const;
    [[nodiscard]] Obstacles obstaclesWith(const ParameterValues& hall, const hall::PreparedHall*) const;

    const hall::HallModel& model_;
    const hall::Hall& hall_;
    std::span<const MuseumExhibit> exhibits_;
    render::AssetStore& assets_;
    std::function<hall::HallScene(const Prepared&)> sceneOf_;
    Obstacles building_;
};

}  // namespace vitrine

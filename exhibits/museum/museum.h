#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/frame_request.h"
#include "exhibits/museum/museum_exhibit.h"
#include "exhibits/museum/prepared.h"
#include "exhibits/museum/read_tables.h"
#include "exhibits/museum/scene_state.h"
#include "exhibits/museum/surroundings.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine::hall {
class Hall;
class HallModel;
struct HallScene;
}  // namespace vitrine::hall

namespace vitrine {
namespace render {
struct FrameReport;
}

/// Rectangle of a picture, in pixels from the lower left corner.
struct PictureRegion {
    glm::ivec2 offset{0};
    glm::ivec2 size{0};

    bool operator==(const PictureRegion&) const = default;
};

/// The museum: the building and all exhibits in it.
class Museum {
public:
    /// Makes a museum with these exhibits; with none for measurements and tests of the hall itself. Reads the hall's
    /// model and its markers. Throws Failure if an asset cannot be read.
    explicit Museum(std::vector<std::unique_ptr<Exhibit>> exhibits);
    ~Museum();

    /// The building.
    [[nodiscard]] const SceneObject& hall() const;
    /// The exhibits, in the order in which a visitor meets them.
    [[nodiscard]] std::span<const MuseumExhibit> exhibits() const { return exhibits_; }
    /// The hall and the exhibits: everything that has parameters. Functions that take an index refer to this list.
    [[nodiscard]] Subjects subjects() const { return subjects_; }
    [[nodiscard]] const SceneObject& subject(std::size_t i) const { return *subjects_[i]; }
    /// Returns subject `i` as an exhibit; it must not be the hall.
    [[nodiscard]] const Exhibit& exhibit(std::size_t i) const;
    /// Cache of the assets that prepared pictures use, with the number of builds.
    [[nodiscard]] const render::AssetStore& assets() const { return *assets_; }
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] SceneState initialSceneState() const;

    /// Returns the transform of subject `i` to world space; that of the hall is the identity.
    [[nodiscard]] glm::dmat4 worldFromExhibit(std::size_t i) const;
    /// Returns the subject's best view, in world space.
    [[nodiscard]] render::Camera bestView(std::size_t i, const ParameterValues&) const;

    /// Calls the function of that name with the museum's asset store.
    [[nodiscard]] TabledSceneState readTables(const SceneState& sceneState) const
    {
        return vitrine::readTables(subjects_, *assets_, sceneState);
    }

    /// Returns the inputs of subject `i`'s animations at the time of the request: the clock, and the distance of its
    /// camera from the center of the subject's bounds (or the hall's bounds, for the hall).
    [[nodiscard]] AnimationTime animationTime(const SceneState&, std::size_t i, const FrameRequest&) const;
    /// Returns the scene state at the time of the request, with animated parameters evaluated. Deterministic.
    [[nodiscard]] SceneState atMoment(const SceneState&, const FrameRequest&) const;

    /// Begins to read, on other threads, the pictures and tables that most frames of the hall need; otherwise the first
    /// frame does. Thread-safe.
    void startReading() const;

    /// Resolves everything needed to plan a frame of this scene state, for the time and camera of the request. This is
    /// the only place where files are read and simulations run. Exhibits out of view are skipped. Thread-safe; results
    /// are cached and shared by all calls. A file that cannot be read is left out, and the plan reports it; if the
    /// request requires files, throws Failure.
    [[nodiscard]] Prepared prepare(const SceneState&, const FrameRequest&) const;

    // The following functions read no files and keep no state. They are thread-safe and deterministic.

    /// Plans and prunes one frame of the prepared scene, for the same time, camera and exhibits; raster, samples and
    /// channels may differ. Outputs are the images "frame" (rgba16f, display-referred linear light, alpha not
    /// premultiplied) and, if requested, "radiance", "depth", "normal", "evaluations".
    [[nodiscard]] render::FramePlan plan(const Prepared&, const FrameRequest&,
                                         const render::PersistentState& = {}) const;

    /// Everything in the hall that a visitor can see, point at and walk to.
    [[nodiscard]] const MuseumSurroundings& surroundings() const { return *surroundings_; }
    /// True if the exhibit stands in the hall; false for the hall and for exhibits in the depot, which are shown alone.
    [[nodiscard]] bool isInHall(std::size_t) const;
    /// Numbers of the places that still wait for an exhibit, ascending.
    [[nodiscard]] std::vector<int> emptyPlaces() const;

    /// Returns the seconds until the picture next changes by itself; infinity: never.
    [[nodiscard]] double nextChange(const Prepared&, const FrameRequest&) const;
    /// Returns the part of the picture outside of which nothing changes by itself, now or later. Its bounds are even
    /// numbers or the picture's border, so that texture filtering in a tile of it equals that of the whole. Returns
    /// nothing if there is no such part: light in the air or parts of the hall change, or a moving object surrounds the
    /// eye. Empty (0 x 0) if nothing changes at all.
    [[nodiscard]] std::optional<PictureRegion> movingRegion(const Prepared&, const FrameRequest&) const;

private:
    struct Present;
    struct Frame;
    [[nodiscard]] render::Box boundsOf(const Prepared&, const Exhibit&, std::size_t i) const;
    [[nodiscard]] std::string whyHidden(const render::Box& worldBox, const render::View&, bool alone) const;
    /// Hides all visible exhibits except the nearest ones, up to the number that the request allows. Exhibits that are
    /// drawn over the frame stay.
    static void leaveToLater(std::vector<Present>&, const FrameRequest&);
    [[nodiscard]] std::vector<Present> presentIn(const Prepared&, const FrameRequest&, const hall::HallScene&,
                                                 const render::View&) const;
    [[nodiscard]] hall::HallScene sceneOf(const Prepared&, bool alone) const;
    /// Returns why mirrors need not show the works behind openings in the walls; empty if they do.
    [[nodiscard]] static std::string whyNoWorks(const Prepared&, const FrameRequest&, const hall::HallScene&,
                                                const render::View&, const std::vector<Present>&);
    [[nodiscard]] std::vector<render::LocalLight> lampsOf(const Prepared&, const std::vector<Present>&,
                                                          bool alone) const;

    std::shared_ptr<const hall::HallModel> model_;
    std::vector<std::unique_ptr<Exhibit>> owned_;
    std::unique_ptr<const hall::Hall> hall_;
    std::vector<const SceneObject*> subjects_;
    std::vector<MuseumExhibit> exhibits_;
    std::unique_ptr<render::AssetStore> assets_;
    std::unique_ptr<const MuseumSurroundings> surroundings_;
};

/// Tells the exhibits that continue from the state of the frame before that a frame was drawn.
void noteDrawn(const Museum&, const render::FrameReport&);

}  // namespace vitrine

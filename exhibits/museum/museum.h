#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/framework/frame_request.h"
#include "exhibits/museum/obstacles.h"
#include "exhibits/museum/prepared.h"
#include "exhibits/museum/read_tables.h"
#include "exhibits/museum/scene_state.h"

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine {

/// An exhibit of a museum.
struct MuseumExhibit {
    std::size_t index;  ///< In Museum::subjects() and SceneState::values.
    const Exhibit& exhibit;
};

/// What the visitor's look rests on.
struct LookedAt {
    std::size_t exhibit = 0;
    std::string text;  ///< "E – melt it".
};

/// What the visitor points at, and where going there leads.
struct Pointed {
    std::size_t exhibit = 0;  ///< `hallIndex`: none; then it is the visitor's own object.
    std::string name;         ///< "Torus to Mug", "Your object: teddy.glb", "E – melt it".
    double distance = 0;      ///< Meters from the eye.
    bool button = false;      ///< It is the button of `exhibit` ...
    bool inReach = false;     ///< ... and can be pressed from here.
    render::Camera view;      ///< Its best view, in the world.
};

/// An object of the visitor's own that stands in the hall.
struct OwnObjectShown {
    std::size_t which = 0;  ///< Of the hall's `objects`.
    std::string name;       ///< "Your object: teddy.glb"
    render::Box box;        ///< In the world.
    render::Camera view;    ///< Its best view, in the world.
};

/// A rectangle of a picture, pixels from its lower left corner.
struct PictureRegion {
    glm::ivec2 offset{0};
    glm::ivec2 size{0};

    bool operator==(const PictureRegion&) const = default;
};

class Hall;
class HallModel;
struct HallScene;

/// The building and everything in it.
class Museum {
public:
    /// With these exhibits; none for measurements and tests of the hall itself. Reads the hall and its markers; throws
    /// Failure when an asset cannot be read.
    explicit Museum(std::vector<std::unique_ptr<Exhibit>> exhibits);
    ~Museum();

    /// The building.
    [[nodiscard]] const Subject& hall() const;
    /// What stands in it, in the order visitors meet it.
    [[nodiscard]] std::span<const MuseumExhibit> exhibits() const { return exhibits_; }
    /// The hall and the exhibits: whose tables can be set. Everything that is not the hall's alone goes by its index
    /// here.
    [[nodiscard]] Subjects subjects() const { return subjects_; }
    [[nodiscard]] const Subject& subject(std::size_t i) const { return *subjects_[i]; }
    /// That subject, which must not be the hall.
    [[nodiscard]] const Exhibit& exhibit(std::size_t i) const;
    /// What prepared pictures are made of, and how often it was made.
    [[nodiscard]] const render::AssetStore& assets() const { return *assets_; }
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] SceneState initialSceneState() const;

    /// Where subject `i` stands; the hall is the world itself.
    [[nodiscard]] glm::dmat4 worldFromExhibit(std::size_t i) const;
    /// The subject's best view, in the world.
    [[nodiscard]] render::Camera bestView(std::size_t i, const ParameterValues&) const;

    /// As the function of that name, through the museum's asset store.
    [[nodiscard]] TabledSceneState readTables(const SceneState& sceneState) const
    {
        return vitrine::readTables(subjects_, *assets_, sceneState);
    }

    /// What moves subject `i` at the request's moment: the clock, and how far its camera is from the middle of the
    /// subject's bounds (of the hall's, for the hall).
    [[nodiscard]] MotionMoment motionMoment(const SceneState&, std::size_t i, const FrameRequest&) const;
    /// The look at the request's moment: rows that move have the values that they then have. The same moment gives the
    /// same values.
    [[nodiscard]] SceneState atMoment(const SceneState&, const FrameRequest&) const;

    /// Resolves what pictures of this look at the request's moment, from its camera, take to plan: the only place where
    /// files are read and simulations run. What is out of view is left alone. Any thread may call it, several at once;
    /// what one has made serves all. A file that cannot be read is left out, and the pictures complain of it; where the
    /// request needs files, throws Failure.
    [[nodiscard]] Prepared prepare(const SceneState&, const FrameRequest&) const;

    // What follows only reads, opens no file and keeps nothing: any thread may call it, and the same is answered the
    // same.

    /// Plans and prunes one picture of what was prepared, at its moment, for the same camera and exhibits; raster,
    /// samples and channels may be others. Its outputs are the images "frame" (rgba16f, display-referred linear light,
    /// alpha not premultiplied) and, as asked, "radiance", "depth", "normal", "evaluations".
    [[nodiscard]] render::FramePlan plan(const Prepared&, const FrameRequest&,
                                         const render::PersistentState& = {}) const;

    /// Where a visitor who wants to go from `from` to `to` (eye positions) ends up: walls and furniture stop
    /// him, and he slides along them.
    [[nodiscard]] glm::dvec3 walk(const glm::dvec3& from, const glm::dvec3& to) const;
    /// The same where objects of the visitor's own stand as well: they and their plinths stop him, too.
    [[nodiscard]] glm::dvec3 walk(const Prepared&, const glm::dvec3& from, const glm::dvec3& to) const;
    /// Walls and furniture.
    [[nodiscard]] const Obstacles& obstacles() const { return building_; }
    /// The same with the visitor's own objects and their plinths; those whose file cannot be read stop nobody.
    [[nodiscard]] Obstacles obstacles(const Prepared&) const;
    /// The same where nothing is prepared: reads the files of the hall's table.
    [[nodiscard]] Obstacles obstacles(const SceneState&) const;
    /// The button within 2 m that the middle of the view rests on, when nothing stands before it.
    [[nodiscard]] std::optional<LookedAt> lookedAt(const Prepared&) const;
    /// The exhibit, button or visitor's object seen at `ndc` (each -1 to 1, y up) of that picture; nothing where the
    /// nearest thing there is a wall or furniture.
    [[nodiscard]] std::optional<Pointed> pick(const Prepared&, const FrameRequest&, glm::dvec2 ndc) const;
    /// The visitor's own objects, as far as they could be read.
    [[nodiscard]] std::vector<OwnObjectShown> ownObjects(const Prepared&) const;
    /// Meters from the eye to whatever is seen there; infinity: the sky.
    [[nodiscard]] double distanceTo(const Prepared&, const FrameRequest&, glm::dvec2 ndc) const;
    /// Which of the places 1 to 9 still wait for an exhibit.
    [[nodiscard]] std::vector<int> emptyPlaces() const;

    /// Seconds until the picture next changes by itself; infinity: nothing to draw.
    [[nodiscard]] double nextChange(const Prepared&, const FrameRequest&) const;
    /// Outside of this part of the picture nothing changes by itself, now or later. It begins at even numbers and ends
    /// there or with the picture, so that a tile of it is filtered like the whole. Nothing when no such part is known:
    /// light in the air or parts of the hall move, or what moves stands around the eye. Empty (0 x 0) when nothing
    /// moves at all.
    [[nodiscard]] std::optional<PictureRegion> movingRegion(const Prepared&, const FrameRequest&) const;

private:
    struct Seen;
    struct Present;
    struct Frame;
    [[nodiscard]] Seen firstSeen(const Prepared&, const HallScene&, const render::Ray&) const;
    [[nodiscard]] render::Box boundsOf(const Prepared&, const Exhibit&, std::size_t i) const;
    [[nodiscard]] std::string whyHidden(const render::Box& worldBox, const render::View&, bool alone) const;
    /// Hides all but the nearest of those in view, where no more are asked for. What lies over the frame stays.
    static void leaveToLater(std::vector<Present>&, const FrameRequest&);
    [[nodiscard]] std::vector<Present> presentIn(const Prepared&, const FrameRequest&, const HallScene&,
                                                 const render::View&) const;
    [[nodiscard]] HallScene sceneOf(const Prepared&, bool alone) const;
    [[nodiscard]] Obstacles obstaclesWith(const ParameterValues& hall, const PreparedHall*) const;
    [[nodiscard]] std::vector<render::LocalLight> lampsOf(const Prepared&, const std::vector<Present>&,
                                                          bool alone) const;

    std::future<void> blueNoise_;  ///< Made while the hall is read; most frames ask for it.
    std::shared_ptr<const HallModel> model_;
    Obstacles building_;
    std::vector<std::unique_ptr<Exhibit>> owned_;
    std::unique_ptr<const Hall> hall_;
    std::vector<const Subject*> subjects_;
    std::vector<MuseumExhibit> exhibits_;
    std::unique_ptr<render::AssetStore> assets_;
};

}  // namespace vitrine

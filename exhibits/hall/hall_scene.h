#pragma once

#include "exhibits/framework/frame_request.h"
#include "exhibits/framework/prepare.h"
#include "exhibits/framework/scene_lighting.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/hall/hall_table.h"
#include "render/hash.h"
#include "render/plan/frame_plan.h"

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

class PlaqueText;

/// An exhibit as the hall knows it: where it stands and what its plaque says.
struct ExhibitSlot {
    int place = 0;
    std::string title, summary, tryThis;
    bool hasButton = false;
};

/// What moves at an exhibit's place, at one moment.
struct ExhibitPose {
    double rotation = 0;  ///< How far what hangs there has turned about its upright axis, radians.
    double sincePress = std::numeric_limits<double>::infinity();  ///< Of the button, seconds; infinity: never.
};

/// An object of a visitor's own, as far as it could be read, and the plinth that it stands on.
struct PreparedObject {
    std::shared_ptr<const render::Model> model;  ///< Null: there is none.
    std::shared_ptr<const render::Mesh> plinth;  ///< Of its own, its foot at the origin; null: it has none.
};

/// The user's panorama and objects, as far as they can be read.
struct PreparedHall final : PreparedPart {
    std::shared_ptr<const render::Texture> environment;
    double environmentBrightest = 0;              ///< The panorama's largest value.
    std::vector<std::string> environmentNotes{};  ///< What its file says and is not shown: full sentences.
    std::array<PreparedObject, mostOwnObjects> objects;
};

/// An object of a visitor's own where it stands.
struct OwnObject {
    std::size_t which = 0;  ///< Of the table's `objects`.
    std::shared_ptr<const render::Model> model;
    glm::dmat4 worldFromModel{1};
    render::Box box;                                  ///< Of the object, world space.
    std::optional<render::MeshInstance> plinth = {};  ///< Of its own; world space.
    std::vector<Collider> colliders = {};             ///< Keep visitors off it and its plinth.
};

/// Everything that the hall's passes are planned from.
struct HallScene {
    const HallModel& model;
    const HallTable& table;
    const ParameterValues& values;
    bool alone = false;                                       ///< No walls: an exhibit in the environment's light.
    std::shared_ptr<const render::Texture> environment = {};  ///< Null: the sky, or the studio when alone.
    double environmentBrightest = 0;                          ///< The panorama's largest value.
    std::vector<std::string> environmentNotes{};              ///< What its file says and is not shown: full sentences.
    std::vector<OwnObject> objects = {};
    std::shared_ptr<const PlaqueText> text = {};
    std::span<const ExhibitSlot> exhibits;
    std::uint64_t filesId = 0;                    ///< As PreparedPart's.
    std::vector<ExhibitPose> poses = {};          ///< One for each slot; may be shorter.
    std::vector<StandingShape> bodies = {};       ///< Of the exhibits, as they stand on the floor; world space.
    std::vector<StandingShape> besideFloor = {};  ///< Of the exhibits, where it is not the hall's floor they stand on.
    /// Lamps that time does not change, wherever one looks: the probe sees what they light. World space.
    std::vector<render::LocalLight> steadyLamps = {};
};

/// What is drawn at a place beside its exhibit: a cloth over an empty one, else its stand and what hangs there, as far
/// as it has turned.
[[nodiscard]] std::vector<render::MeshInstance> partsAt(const HallScene&, const Place&);

// hall_light.cpp

/// Unit vector towards the sun, world space.
[[nodiscard]] glm::dvec3 towardsSun(const HallScene&);
/// The light for everything in the hall, or for an exhibit alone. `runEverything`: as FramePlan's.
[[nodiscard]] SceneLighting sceneLighting(const HallScene&, bool runEverything = false);
/// Whether an eye there sees through the walls, because it lies within them, or so near their outer faces that the near
/// plane may cut these away.
[[nodiscard]] bool isInWalls(const HallModel&, const glm::dvec3& eye);
/// Empty when the box may be seen from there: it is in view, and no wall hides it.
[[nodiscard]] std::string whyHidden(const HallModel&, const render::Box& worldBox, const render::View&);
/// Empty when the sun may reach a point of the box through window or oculus.
[[nodiscard]] std::string whyUnlit(const HallScene&, const render::Box& worldBox);
/// Changes whenever something that falls on the static hall, or is seen in its probe, changes.
[[nodiscard]] std::uint64_t lightKey(const HallScene&);

// bounced_light.cpp

/// What the sun lights from where it stands.
[[nodiscard]] std::vector<SunTransfer::Source> bounceOf(const HallScene&);
/// What its bounced light, `most` of it in the air, adds to a surface.
[[nodiscard]] render::ContributionBound boundOfBounce(const HallScene&, double most);
/// The sun's bounced light on walls and floor, kept while the sun stands still.
void planBouncedLight(const HallScene&, const SceneLighting&, render::FramePlan&);
/// The light of sky and sun in the air, for what has no lightmap: kept while neither changes.
void planAirLight(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Lets everything that is lit read it.
void lookUpAirLight(const HallScene&, SceneLighting&);
/// Lets a pass that draws walls read the sky's light on them and, where there is any, the sun's bounced light.
void bindLightmaps(const HallScene&, const SceneLighting&, render::Pass&);

// hall_passes.cpp

/// Of buttons, and of models that name no material.
[[nodiscard]] const render::Material& redPaint();

/// Cloths over empty places, stands of occupied ones, the visitor's own plinths: what is in the hall beside its walls
/// and never moves by itself.
[[nodiscard]] std::vector<render::MeshInstance> standingParts(const HallScene&);

/// Whether an exhibit stands there: its stand is drawn, and no cloth.
[[nodiscard]] bool isOccupied(const HallScene&, int place);
/// A part of the building or of what stands in it, of its material.
[[nodiscard]] render::Draw partDraw(const HallScene&, const render::MeshInstance&);

/// The sun's depth map of walls and furniture, kept while neither moves.
void planHallShadow(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Walls, furniture, cloths over empty places, the visitor's objects, buttons and plaques.
void planWalls(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);
/// What is behind everything: sky, panorama, or the studio of an exhibit alone.
void planSky(const HallScene&, const SceneLighting&, render::FramePlan&);

// own_objects.cpp

/// Reads the visitor's objects and makes their plinths. `unreadable` is told which of them cannot be read, and why.
using ToldUnreadable = std::function<void(std::size_t which, const std::string& why)>;
[[nodiscard]] std::array<PreparedObject, mostOwnObjects> preparedObjects(const HallTable&, const ParameterValues&,
                                                                         render::AssetStore&, render::Hash& files,
                                                                         const ToldUnreadable&);
/// Those that could be read, each where it stands: on the floor, walls and furniture keep it off.
[[nodiscard]] std::vector<OwnObject> objectsAt(const HallModel&, const HallTable&, const ParameterValues&,
                                               const std::array<PreparedObject, mostOwnObjects>&);
/// "hall/visitor", "hall/visitor/2", ...: the name of its pass.
[[nodiscard]] std::string ownPassName(std::size_t which);
/// What each draws, or why not.
void planOwnObjects(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);
/// Boxes of what their materials are on average, and their plinths: for the floor.
[[nodiscard]] std::vector<StandingShape> ownShapes(const HallScene&);

// hall_plaques.cpp

/// Plates of dark enamel at the places, and the letters on them.
void planPlaques(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);

// hall_floor.cpp

/// The map of contact shadows on the floor, kept until something else stands on it.
void planContactShadows(const HallScene&, render::FramePlan&);
/// The floor of polished stone, which mirrors what stands on it, after the other walls.
void planFloor(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);
/// Whether the floor's own pass draws this part of the walls.
[[nodiscard]] bool isFloor(const render::MeshInstance&);

// hall_probe.cpp

/// The reflection probe: captured from inside the hall (or the environment alone), blurred by roughness, and
/// summed up as nine spherical-harmonic coefficients; kept while nothing in it changes.
void planProbe(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Mip levels of a probe with this many texels along a face, one for each roughness.
[[nodiscard]] int probeLevels(int size);
/// The point from which the probe is captured, world space.
[[nodiscard]] glm::dvec3 probePosition(const HallScene&);
/// Of the steady lamps, what the probe reckons with, without their shadows; none where none shines.
[[nodiscard]] std::optional<render::LocalLighting> probeLamps(const HallScene&);

// hall_antialiasing.cpp

/// Over how many frames a picture in motion is averaged, and a hash of all that it shows but for what moves.
struct FrameHistory {
    int frames = 1;
    std::uint64_t look = 0;
};
/// The tone-mapped image of a picture in motion, before it is averaged over its frames.
inline constexpr const char* displayImage = "display";
/// What the frames before left for it.
inline constexpr const char* frameHistoryImage = "frame history";
/// Whether the picture is averaged over its frames. Its samples lie at `antialiasingSample` of their pixels.
[[nodiscard]] bool isAveragedOverFrames(const FrameRequest&, const FrameHistory&);
/// Which sample of its pixels a frame in motion draws, from 0.
[[nodiscard]] int antialiasingSample(const FrameRequest&);
/// The mean of a picture over its frames, from `displayImage` into the image "frame"; of a picture at rest, what the
/// next motion begins with.
void planAntialiasing(const FrameRequest&, const FrameHistory&, render::FramePlan&);

// hall_tone_mapping.cpp

/// What every picture ends with: tone mapping and the mean over supersamples, or over the frames of a picture in
/// motion, into the image "frame".
void planToneMapping(const SceneLighting&, const FrameRequest&, const FrameHistory&, render::FramePlan&);

/// Seconds for which a pressed button moves.
inline constexpr double buttonTime = 0.2;
/// Vertical scale of a button, `seconds` after it was pressed: 1 to 0.1 in half of `buttonTime`, and back in the other.
[[nodiscard]] double buttonScale(double seconds);

}  // namespace vitrine

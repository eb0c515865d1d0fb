#pragma once

#include "exhibits/framework/scene/frame_request.h"
#include "exhibits/framework/scene/prepare.h"
#include "exhibits/framework/scene/scene_lighting.h"
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

namespace vitrine::hall {

class PlaqueText;

/// Place of an exhibit, and the texts of its plaque.
struct ExhibitSlot {
    int place = 0;
    std::string title, summary, tryThis;
    bool hasButton = false;
    bool shines = false;  ///< Whether the work lights the hall itself.
};

/// Moving parts at the place of an exhibit, at one time.
struct ExhibitPose {
    double rotation = 0;  ///< Rotation of the hanging parts about their vertical axis, radians.
    double sincePress = std::numeric_limits<double>::infinity();  ///< Seconds since the press; infinity: never.
};

/// An object of the user, as far as it could be read, and its plinth.
struct PreparedObject {
    std::shared_ptr<const render::Model> model;  ///< Null if there is no object.
    std::shared_ptr<const render::Mesh> plinth;  ///< Its own plinth, with its foot at the origin; null if it has none.
};

/// The user's panorama and objects, as far as they can be read.
struct PreparedHall final : PreparedPart {
    std::shared_ptr<const render::Texture> environment;
    double environmentBrightest = 0;              ///< The panorama's largest value.
    std::vector<std::string> environmentNotes{};  ///< Features of the file that are not shown: full sentences.
    std::array<PreparedObject, mostOwnObjects> objects;
};

/// An object of the user at its place.
struct OwnObject {
    std::size_t which = 0;  ///< Index into the `objects` of HallTable.
    std::shared_ptr<const render::Model> model;
    glm::dmat4 worldFromModel{1};
    render::Box box;                                  ///< Bounds of the object, world space.
    std::optional<render::MeshInstance> plinth = {};  ///< Its own plinth, world space.
    std::vector<Collider> colliders = {};             ///< Keep the walking user off the object and its plinth.
};

/// Picture of a work behind an opening in the wall, for the reflection probe.
struct ReflectedWork {
    glm::dmat4 worldFromOpening{1};  ///< The opening is the square from -1 to 1 on z = 0, and faces +z.
    glm::dmat4 clipFromWorld{1};     ///< View of the picture, from the place of the probe.
    std::string image;               ///< Radiance of the work.
    std::uint64_t key = 0;           ///< Hash of everything that the picture depends on.
};

/// State from which the passes of the hall are planned.
struct HallScene {
    const HallModel& model;
    const HallTable& table;
    const ParameterValues& values;
    bool alone = false;                                       ///< No walls: an exhibit in the environment's light.
    std::shared_ptr<const render::Texture> environment = {};  ///< Null: the sky, or the studio when alone.
    double environmentBrightest = 0;                          ///< The panorama's largest value.
    std::vector<std::string> environmentNotes{};  ///< Features of its file that are not shown: full sentences.
    std::vector<OwnObject> objects = {};
    std::shared_ptr<const PlaqueText> text = {};
    std::span<const ExhibitSlot> exhibits;
    std::uint64_t filesId = 0;                    ///< As in PreparedPart.
    std::vector<ExhibitPose> poses = {};          ///< One for each slot; may have fewer elements.
    std::vector<StandingShape> bodies = {};       ///< Exhibits on the floor, world space.
    std::vector<StandingShape> besideFloor = {};  ///< Exhibits that do not stand on the hall's floor, world space.
    /// Lamps that are independent of time and view, so the probe captures what they light. World space.
    std::vector<render::LocalLight> steadyLamps = {};
};

/// Returns the parts at a place beside its exhibit: a cloth if it is empty, else its stand and the hangings at their
/// current angle.
[[nodiscard]] std::vector<render::MeshInstance> partsAt(const HallScene&, const Place&);

// The following functions are defined in hall_light.cpp.

/// Returns the unit vector towards the sun, world space.
[[nodiscard]] glm::dvec3 towardsSun(const HallScene&);
/// Returns the light for everything in the hall, or for an exhibit alone. `runEverything` is FramePlan's.
[[nodiscard]] SceneLighting sceneLighting(const HallScene&, bool runEverything = false);
/// Returns whether the eye sees through the walls, because it is inside them, or so close outside that the near plane
/// may cut them away.
[[nodiscard]] bool isInWalls(const HallModel&, const glm::dvec3& eye);
/// Returns why the box is invisible; empty if it may be visible: in view, and not behind a wall.
[[nodiscard]] std::string whyHidden(const HallModel&, const render::Box& worldBox, const render::View&);
/// Returns why the box cannot cast a shadow of the sun; empty if it may. Reasons are: no sun, sun shadows switched off,
/// or no sunlight through window and oculus on any point of the box.
[[nodiscard]] std::string whyUnlit(const HallScene&, const render::Box& worldBox);
/// Returns a hash that changes with all light on the static hall and with everything that its probe shows.
[[nodiscard]] std::uint64_t lightKey(const HallScene&);

// The following functions are defined in bounced_light.cpp.

/// Returns the parts of floor and walls that the sun lights from its current direction.
[[nodiscard]] std::vector<SunTransfer::Source> bounceOf(const HallScene&);
/// Returns a bound on the sun's bounced light on surfaces; `most` is the largest in the air.
[[nodiscard]] render::ContributionBound boundOfBounce(const HallScene&, double most);
/// Plans the sun's bounced light on walls and floor, which is kept until the sun moves.
void planBouncedLight(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Plans the light of sky, sun and lamps in the air, for surfaces without a lightmap. It is kept until one changes.
void planAirLight(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Makes all lit passes read the light in the air.
void lookUpAirLight(const HallScene&, SceneLighting&);
/// Makes a pass that draws walls read the sky's lightmap and, if there is any, the sun's bounced light.
void bindLightmaps(const HallScene&, const SceneLighting&, render::Pass&);

// The following functions are defined in hall_passes.cpp.

/// Returns the paint of buttons, and of models without a material.
[[nodiscard]] const render::Material& redPaint();

/// Returns cloths over empty places, stands of occupied ones, and the plinths of the user's objects: everything static
/// in the hall beside its walls.
[[nodiscard]] std::vector<render::MeshInstance> standingParts(const HallScene&);

/// Returns whether an exhibit is at the place: its stand is drawn, and no cloth.
[[nodiscard]] bool isOccupied(const HallScene&, int place);
/// Returns the draw of a part of the building or of what stands in it, with its material.
[[nodiscard]] render::Draw partDraw(const HallScene&, const render::MeshInstance&);

/// Plans the sun's depth map of walls and furniture, which is kept until something moves.
void planHallShadow(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Plans walls, furniture, cloths over empty places, the user's objects, buttons and plaques.
void planWalls(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);
/// Plans the background: sky, panorama, or the studio of an exhibit alone.
void planSky(const HallScene&, const SceneLighting&, render::FramePlan&);

/// Plans the heat map of the hall's parameter `heatMap`, or the reason for skipping it. Call after all surfaces are
/// planned.
void planHeatMap(const HallScene&, const SceneLighting&, const FrameRequest&, render::FramePlan&);

// The following functions are defined in own_objects.cpp.

/// Callback for an object that cannot be read: its index, and the reason.
using ToldUnreadable = std::function<void(std::size_t which, const Message& why)>;
/// Reads the user's objects and makes their plinths. Adds the state of the files to `files`.
[[nodiscard]] std::array<PreparedObject, mostOwnObjects> preparedObjects(const HallTable&, const ParameterValues&,
                                                                         render::AssetStore&, render::Hash& files,
                                                                         const ToldUnreadable&);
/// Returns the objects that could be read, each at its place. On the floor, they are moved out of walls and furniture.
[[nodiscard]] std::vector<OwnObject> objectsAt(const HallModel&, const HallTable&, const ParameterValues&,
                                               const std::array<PreparedObject, mostOwnObjects>&);
/// Returns whether a part of the object may be a mirror.
[[nodiscard]] bool isMirror(const OwnObject&);
/// Returns the name of an object's pass: "hall/visitor", "hall/visitor/2", ...
[[nodiscard]] std::string ownPassName(std::size_t which);
/// Plans the passes of each object, or the reasons for skipping them.
void planOwnObjects(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);
/// Returns for the floor's reflections the plinths, and the objects as boxes of their mean color.
[[nodiscard]] std::vector<StandingShape> ownShapes(const HallScene&);

// The following function is defined in hall_plaques.cpp.

/// Plans plates of dark enamel at the places, and the letters on them.
void planPlaques(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);

// The following functions are defined in hall_floor.cpp.

/// Plans the map of contact shadows on the floor, which is kept until something on it changes.
void planContactShadows(const HallScene&, render::FramePlan&);
/// Plans the floor of polished stone, which reflects what stands on it, after the other walls.
void planFloor(const HallScene&, const SceneLighting&, const Channels&, render::FramePlan&);

// The following functions are defined in hall_probe.cpp.

/// Plans the reflection probe: captured from inside the hall (or the environment alone), blurred by roughness, and
/// summed up as nine spherical-harmonic coefficients. It is kept until something in it changes.
void planProbe(const HallScene&, const SceneLighting&, render::FramePlan&);
/// Plans a second probe for mirrors, in which the works are visible, and makes `SceneLighting::mirrorWorks` read it.
/// Call after `planProbe`, which it extends; it is kept until something in it changes, and left out if nothing reads
/// it.
void planMirroredWorks(const HallScene&, SceneLighting&, std::span<const ReflectedWork>, render::FramePlan&);
/// Returns the view from the probe that shows exactly what is visible through an opening (`ReflectedWork`), with two
/// pixels for each texel of the probe. Returns nothing if the probe is behind the opening, or too near.
[[nodiscard]] std::optional<render::View> viewThrough(const HallScene&, const glm::dmat4& worldFromOpening);
/// Returns the number of mip levels of a probe with `size` texels along a face; each is for one roughness.
[[nodiscard]] int probeLevels(int size);
/// Returns the point from which the probe is captured, world space.
[[nodiscard]] glm::dvec3 probePosition(const HallScene&);
/// Returns the light of the steady lamps in the probe, without shadows; none if no lamp shines.
[[nodiscard]] std::optional<render::LocalLighting> probeLamps(const HallScene&);

// The following functions are defined in hall_antialiasing.cpp.

/// Number of frames over which a picture in motion is averaged, and a hash of everything in it except motion.
struct FrameHistory {
    int frames = 1;
    std::uint64_t look = 0;
};
/// Tone-mapped image of a picture in motion, before it is averaged over its frames.
inline constexpr const char* displayImage = "display";
/// Average of the previous frames.
inline constexpr const char* frameHistoryImage = "frame history";
/// Returns whether the picture is averaged over its frames. Its samples are at `antialiasingSample` of their pixels.
[[nodiscard]] bool isAveragedOverFrames(const FrameRequest&, const FrameHistory&);
/// Returns the index of the sample within its pixels that a frame in motion draws, from 0.
[[nodiscard]] int antialiasingSample(const FrameRequest&);
/// Plans the average of a picture over its frames, from `displayImage` into the image "frame". For a converged picture,
/// plans the history with which the next motion begins.
void planAntialiasing(const FrameRequest&, const FrameHistory&, render::FramePlan&);

// The following functions are defined in hall_tone_mapping.cpp, except `buttonScale`.

/// Plans the end of every frame: glare, tone mapping and the mean over supersamples, or over the frames of a picture in
/// motion, into the image "frame". `brightest` is a bound on the radiance of the picture, before exposure.
void planToneMapping(const HallScene&, const SceneLighting&, double brightest, const FrameRequest&, const FrameHistory&,
                     render::FramePlan&);

/// Duration in seconds of the movement of a pressed button.
inline constexpr double buttonTime = 0.2;
/// Returns the vertical scale of a button `seconds` after it was pressed: 1 to 0.1 in half of `buttonTime`, then back.
[[nodiscard]] double buttonScale(double seconds);

}  // namespace vitrine::hall

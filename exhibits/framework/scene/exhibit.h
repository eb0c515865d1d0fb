#pragma once

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/prepare.h"
#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/framework/table/parameters.h"
#include "render/plan/frame_plan.h"
#include "render/scene/camera.h"
#include "render/scene/ray.h"

#include <glm/glm.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Additional images to compute besides the color.
struct Channels {
    bool normal = false;       ///< Normals in world space, of unit length, in the image "normal".
    bool evaluations = false;  ///< Number of field evaluations per pixel, in the image "evaluations".
    /// Base color of surfaces before any light, in the image "albedo": linear Rec. 709, 0 where there is none.
    bool albedo = false;

    /// Returns the channels without `evaluations`, which some exhibits count in a pass of their own.
    [[nodiscard]] Channels withoutCounts() const { return {.normal = normal, .albedo = albedo}; }
    bool operator==(const Channels&) const = default;
};

/// Names of the images that all exhibits of a frame draw into. The radiance is scene-linear, with premultiplied alpha
/// as coverage. The depth is reversed (1 near, 0 far). "shadow.exhibits" is the sun's shadow map of the exhibits.
inline constexpr const char* radianceImage = "radiance";
inline constexpr const char* depthImage = "depth";
inline constexpr const char* normalImage = "normal";
inline constexpr const char* evaluationsImage = "evaluations";
inline constexpr const char* albedoImage = "albedo";
inline constexpr const char* exhibitShadowImage = "shadow.exhibits";
inline constexpr const char* glassShadowImage = "shadow.glass";

/// Everything that an exhibit may read when it plans its part of a frame.
struct PlanContext {
    const ParameterValues& values;
    const SceneLighting& lighting;  ///< Light at the exhibit.
    glm::dmat4 worldFromExhibit{
        1};           ///< Placement in the hall (identity if alone), times the caller's scale and rotation.
    double time = 0;  ///< Seconds since the exhibit's clock started.
    Channels channels;
    bool alone = false;      ///< True: shown without the hall; the environment is the only light.
    bool onNothing = false;  ///< True: empty background; pixels where the exhibit draws nothing stay transparent.
    double sinceOwnPress =
        std::numeric_limits<double>::infinity();  ///< Seconds since its button was pressed; infinity: never.
    const PreparedPart* prepared = nullptr;       ///< Result of `prepare`.
    /// Plans the hall and all exhibits for another view of the same frame: without shadows, without passes over the
    /// whole frame, and unpruned. Only for OverFrame::planOverFrame.
    std::function<render::FramePlan(const render::View&)> planOfView = {};
    std::optional<render::Box> worldBox = {};  ///< Contains all that the exhibit draws.

    /// As `lighting.bindLighting`, for a pass that shades only places in `worldBox`.
    void bindLighting(render::Pass& pass) const
    {
        lighting.bindLighting(pass);
        pass.shaded.within = worldBox;
    }
};

/// A rendering technique in the museum: a parameter table and the passes that draw it. Optional features are the
/// interfaces in exhibits/framework/scene/capabilities.h.
class Exhibit : public SceneObject {
public:
    [[nodiscard]] virtual std::string_view tryThis() const { return {}; }  ///< On the plaque: what to try.
    /// Number of its place in the hall, from 1. 0, or a number that the hall does not have: it is in the depot, shown
    /// alone.
    [[nodiscard]] virtual int place() const { return 0; }

    /// True if the exhibit has everything that visitors are given: a lesson, a page and German texts, which tests then
    /// ask for. A new exhibit may be shown, tuned, studied and exported without them.
    [[nodiscard]] virtual bool isComplete() const { return false; }

    /// Gets everything that takes time or can fail from the asset store: files, meshes, simulations. Returns null if
    /// nothing is needed. Thread-safe; several threads may call it at once. Never throws for an unreadable file.
    [[nodiscard]] virtual std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const { return nullptr; }

    // The following functions are pure: they open no file, store nothing and always return the same result for the same
    // arguments.

    /// Returns the bounding box for a state (time and button press included). Also called before anything is prepared.
    [[nodiscard]] virtual render::Box boundsOf(const ExhibitState& state) const { return bounds(state.values); }
    /// Returns the distance along a ray (exhibit space) to its first hit of the visible exhibit, measured like
    /// `render::firstHit`; infinity if it misses. Used to pick exhibits with the pointer. The default tests the
    /// bounding box.
    [[nodiscard]] virtual double firstHit(const ExhibitState& state, const render::Ray& ray) const
    {
        return render::firstHit(ray, boundsOf(state));
    }
    /// Returns the seconds until the picture next changes by itself: 0 while animated, infinity if it is static.
    [[nodiscard]] virtual double nextChange(const ParameterValues&, double time) const = 0;
    /// The same for a prepared state, button press included.
    [[nodiscard]] virtual double nextChangeOf(const ExhibitState& state) const
    {
        return nextChange(state.values, state.time);
    }

    /// Returns false if the exhibit never casts a shadow (content behind a wall, or made of light). It then takes no
    /// space in the shadow map.
    [[nodiscard]] virtual bool castsShadow() const { return true; }

    // Planning. If one of the first two functions is skipped, the frame's report has one line with the reason:
    // "fur/shadow" or "fur".

    /// Adds the passes that draw the exhibit into the shadow map of all exhibits (see `castShadow` in the kit). Called
    /// before `plan`, and only if the sun may reach its bounds and the shadow may be visible.
    virtual void planShadow(const PlanContext&, render::FramePlan&) const {}
    /// Adds the passes that draw the exhibit. Called only if its bounds may be visible.
    virtual void plan(const PlanContext&, render::FramePlan&) const {}
};

}  // namespace vitrine

#pragma once

#include "exhibits/framework/capabilities.h"
#include "exhibits/framework/parameters.h"
#include "exhibits/framework/prepare.h"
#include "exhibits/framework/scene_lighting.h"
#include "exhibits/framework/subject.h"
#include "render/plan/frame_plan.h"
#include "render/scene/camera.h"
#include "render/scene/ray.h"

#include <glm/glm.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// What else a picture should carry, besides color.
struct Channels {
    bool normal = false;       ///< World space, unit length, in the image "normal".
    bool evaluations = false;  ///< Field evaluations per pixel, in the image "evaluations".

    bool operator==(const Channels&) const = default;
};

/// Images that every exhibit of a frame draws into: scene-linear radiance (alpha is coverage, premultiplied)
/// and reversed depth; the sun's depth map of the exhibits.
inline constexpr const char* radianceImage = "radiance";
inline constexpr const char* depthImage = "depth";
inline constexpr const char* normalImage = "normal";
inline constexpr const char* evaluationsImage = "evaluations";
inline constexpr const char* exhibitShadowImage = "shadow.exhibits";
inline constexpr const char* glassShadowImage = "shadow.glass";

/// What an exhibit may know when it plans its part of a frame.
struct PlanContext {
    const ParameterValues& values;
    const SceneLighting& lighting;  ///< The light around it.
    glm::dmat4 worldFromExhibit{
        1};           ///< Its place in the hall, or identity when alone, times the caller's scale and rotation.
    double time = 0;  ///< Seconds since the exhibit's clock started.
    Channels channels;
    bool alone = false;      ///< No hall: the environment is the only light.
    bool onNothing = false;  ///< Where it draws nothing, the picture stays empty.
    double sinceOwnPress =
        std::numeric_limits<double>::infinity();  ///< Seconds since its button was pressed; infinity: never.
    const PreparedPart* prepared = nullptr;       ///< What `prepare` made.
    /// What the hall and all exhibits plan for another view of the same frame, without shadows and what lies over the
    /// frame. Only for OverFrame::planOverFrame; unpruned.
    std::function<render::FramePlan(const render::View&)> seenFrom = {};
};

/// One technique on show: its parameter table, and the passes that draw it. What only some exhibits do is in
/// exhibits/framework/capabilities.h.
class Exhibit : public Subject {
public:
    [[nodiscard]] virtual std::string_view tryThis() const { return {}; }  ///< On the plaque: what to try.
    [[nodiscard]] virtual int place() const = 0;                           ///< In the hall, 1 to 9.

    /// Resolves what takes time or can fail, through the asset store: files, meshes, simulations. Null where it needs
    /// nothing. Any thread may call it, several at once; never throws for a file that cannot be read.
    [[nodiscard]] virtual std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const { return nullptr; }

    // What follows only reads: it opens no file, keeps nothing and answers the same whenever it is asked the same.

    /// As `bounds`, at this moment, its button included. Asked before anything is prepared, too.
    [[nodiscard]] virtual render::Box boundsOf(const ExhibitState& state) const { return bounds(state.values); }
    /// Where a ray (own space) first meets what is seen of it, as `render::firstHit` counts; infinity: nowhere. What a
    /// visitor points at. By default its bounds.
    [[nodiscard]] virtual double firstHit(const ExhibitState& state, const render::Ray& ray) const
    {
        return render::firstHit(ray, boundsOf(state));
    }
    /// Seconds until its picture next changes by itself: 0 while animated, infinity when still.
    [[nodiscard]] virtual double nextChange(const ParameterValues&, double time) const = 0;
    /// The same of what is prepared, its button included.
    [[nodiscard]] virtual double nextChangeOf(const ExhibitState& state) const
    {
        return nextChange(state.values, state.time);
    }

    /// Whether it may throw a shadow at all: what lies behind a wall and what is made of light does not, and takes no
    /// room in the shadow map.
    [[nodiscard]] virtual bool castsShadow() const { return true; }

    // Planning. Where one of the first two is not called, the ledger has one line that says why: "fur/shadow", "fur".

    /// Its part of the exhibits' shadow map (`castShadow` of the kit), before `plan`. Called only while the sun may
    /// reach its bounds and the shadow may be seen.
    virtual void planShadow(const PlanContext&, render::FramePlan&) const {}
    /// Its part of the picture. Called only while its bounds may be seen.
    virtual void plan(const PlanContext&, render::FramePlan&) const {}
};

}  // namespace vitrine

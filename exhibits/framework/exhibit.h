#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/prepare.h"
#include "exhibits/framework/surroundings.h"
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

/// What an exhibit may know when it plans its part of a frame.
struct PlanContext {
    const ParameterValues& values;
    const Surroundings& surroundings;  ///< The light around it.
    glm::dmat4 worldFromExhibit{
        1};           ///< Its place in the hall, or identity when alone, times the caller's scale and rotation.
    double time = 0;  ///< Seconds since the exhibit's clock started.
    Channels channels;
    bool alone = false;  ///< No hall: the environment is the only light.
    double sinceOwnPress =
        std::numeric_limits<double>::infinity();  ///< Seconds since its button was pressed; infinity: never.
    const PreparedPart* prepared = nullptr;       ///< What `prepare` made.
    /// What the hall and all exhibits plan for another view of the same frame, without shadows and what lies over the
    /// frame. Only while `planOverFrame` is called; unpruned.
    std::function<render::FramePlan(const render::View&)> seenFrom = {};
};

/// A fixed situation in which an accuracy study measures: seen from `camera` (in the exhibit's space) at
/// `time`, with `values` in place of what the study started from: "spin of 120 degrees".
struct StudyView {
    std::string name;
    render::Camera camera;
    double time = 0;  ///< Seconds.
    ParameterValues values;
};

/// One technique on show: its parameter table, and the passes that draw it.
class Exhibit {
public:
    virtual ~Exhibit() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;                  ///< Of its folder, presets and flags.
    [[nodiscard]] virtual std::string_view title() const = 0;                 ///< Shown to visitors.
    [[nodiscard]] virtual std::string_view summary() const = 0;               ///< One sentence.
    [[nodiscard]] virtual std::string_view tryThis() const { return {}; }     ///< On the plaque: what to try.
    [[nodiscard]] virtual std::string_view buttonText() const { return {}; }  ///< After "E – "; empty: no button.
    [[nodiscard]] virtual int place() const = 0;  ///< 1 to 9; 0 for the hall, 10 for the visitor's plinth.
    [[nodiscard]] virtual const Parameters& parameters() const = 0;

    /// The space it may fill, in its own space: what is culled, framed and collided with.
    [[nodiscard]] virtual render::Box bounds(const ParameterValues&) const = 0;
    /// The same, `sinceOwnPress` seconds after its button was pressed (infinity: never).
    [[nodiscard]] virtual render::Box boundsAfterPress(const ParameterValues& values, double /*sinceOwnPress*/) const
    {
        return bounds(values);
    }
    /// Resolves what takes time or can fail, through the asset store: files, meshes, simulations. Null where it needs
    /// nothing. Any thread may call it, several at once; never throws for a file that cannot be read.
    [[nodiscard]] virtual std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const { return nullptr; }

    // What follows only reads: it opens no file, keeps nothing and answers the same whenever it is asked the same.

    /// Where a ray (own space) first meets what is seen of it, as `render::firstHit` counts; infinity: nowhere. What a
    /// visitor points at. By default its bounds.
    [[nodiscard]] virtual double firstHit(const ExhibitState& state, const render::Ray& ray) const
    {
        return render::firstHit(ray, boundsAfterPress(state.values, state.sinceOwnPress));
    }
    /// Its best view, in its own space.
    [[nodiscard]] virtual render::Camera bestView(const ParameterValues&) const = 0;
    /// Seconds until its picture next changes by itself: 0 while animated, infinity when still.
    [[nodiscard]] virtual double nextChange(const ParameterValues&, double time) const = 0;
    /// The same of what is prepared, its button included.
    [[nodiscard]] virtual double nextChangeOf(const ExhibitState& state) const
    {
        return nextChange(state.values, state.time);
    }
    /// What pressing its button does to the values; returns whether anything changed.
    virtual bool press(ParameterValues&) const { return false; }

    /// The views of its accuracy studies, easy and hard ones, starting from these values; at least one.
    [[nodiscard]] virtual std::vector<StudyView> studyViews(const ParameterValues& values) const
    {
        return {{"best view", bestView(values), 0, values}};
    }

    // Planning. Where one of the first two is not called, the ledger has one line that says why: "fur/shadow", "fur".

    /// Its part of the exhibits' shadow map (`castShadow` of the kit), before `plan`. Called only while the sun may
    /// reach its bounds and the shadow may be seen.
    virtual void planShadow(const PlanContext&, render::FramePlan&) const {}
    /// Its part of the picture. Called only while its bounds may be seen.
    virtual void plan(const PlanContext&, render::FramePlan&) const {}
    /// What it lays over the frame: called when every exhibit has planned its part, before the sky.
    virtual void planOverFrame(const PlanContext&, render::FramePlan&) const {}
    /// Whether it draws into the exhibits' shadow map; false for what is made of light alone.
    [[nodiscard]] virtual bool castsShadow() const { return true; }
    /// How far the hanging parts of its place have turned about their own upright axis, radians.
    [[nodiscard]] virtual double turnOfHangings(const ParameterValues&, double time) const
    {
        (void)time;
        return 0;
    }
};

}  // namespace vitrine

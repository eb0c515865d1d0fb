#include "exhibits/crepuscular_rays/crepuscular_rays.h"

#include "exhibits/crepuscular_rays/rays_scene.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/kit/backdrop.h"
#include "shaders/lib/bindings.glsl"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vitrine::crepuscular_rays {
namespace {

/// Images that are made before the beams are drawn over the picture.
struct RayImages {
    std::optional<render::ResourceId> mask, gathered, scattered;
    bool haze = false;
};

/// Returns whether the passes of a technique are planned. If not, they are listed as skipped, with the reason: a factor
/// in `asked` is 0, `bound` is 0, or `drawable` is 0. An ineffective technique may be planned to prove that it has no
/// effect, but never one that is not `drawable`.
bool isDrawn(std::initializer_list<render::Factor> asked, const render::ContributionBound& bound,
             const render::Factor& drawable, std::initializer_list<const char*> passes, render::FramePlan& plan)
{
    std::string why = render::whyZero(asked);
    if (why.empty() && drawable.value > 0) return plan.includeIfEffective(bound, passes);
    if (why.empty()) why = bound.isZero() ? bound.whyNone : drawable.whenZero;
    for (const char* pass : passes) plan.skip(pass, why);
    return false;
}

/// Draws the images over the frame.
void planComposite(const RaysScene& s, const RayImages& made, render::ContributionBound bound, render::FramePlan& plan)
{
    const RayView view = s.values[s.table.view];
    render::Pass pass = s.pass(
        "composite", view == RayView::picture ? "the beams are added to the picture" : "only the beams are shown",
        "crepuscular_rays/composite.frag");
    pass.phase = render::PassPhase::volume;
    pass.bound = std::move(bound);
    pass.colors = {render::Attachment::whole(radianceImage)};
    pass.state.blend = view == RayView::picture ? render::Blend::premultiplied : render::Blend::none;
    pass.inputs = {{UNIT_SOURCE, depthBehindGlass(plan)}};
    if (view == RayView::mask) {
        pass.shader.defines.emplace_back("SHOW_MASK");
        pass.inputs.push_back({UNIT_EXHIBIT_A, *made.mask});
    } else if (made.gathered) {
        const bool polar = methodOf(s) == RayMethod::polar;
        pass.shader.defines.emplace_back(polar ? "POLAR" : "SCREEN");
        pass.inputs.push_back({UNIT_EXHIBIT_A, *made.gathered});
        pass.counts["fetches"] = static_cast<std::int64_t>(plan.view.raster.drawn().x) * plan.view.raster.drawn().y *
                                 (polar                  ? 2
                                  : s.block.cellSize > 1 ? 9
                                                         : 1);
    }
    if (made.scattered) {
        pass.shader.defines.emplace_back("BEAMS");
        pass.inputs.push_back({UNIT_EXHIBIT_B, *made.scattered});
    }
    if (made.haze) {
        pass.shader.defines.emplace_back("HAZE");
        for (const render::SampledTexture& input : s.context.lighting.inputs)
            if (input.unit == UNIT_PROBE_IRRADIANCE) pass.inputs.push_back(input);
    }
    if (view != RayView::picture) pass.shader.defines.emplace_back("REPLACE");
    pass.blocks[BLOCK_LIGHT] = render::std140Bytes(s.context.lighting.light);
    plan.add(std::move(pass));
}

}  // namespace

render::Box CrepuscularRays::bounds(const ParameterValues&) const
{
    return {{-1.3, -1.15, -3.6}, {1.3, 3.95, -3.0}};
}

double CrepuscularRays::firstHit(const ExhibitState& state, const render::Ray& ray) const
{
    // The panes are flat and inside the wall, so the wall beside the window hides them.
    constexpr double wallsMiddle = -3.9;
    render::Box panes = bounds(state.values);
    panes.low.z = panes.high.z = wallsMiddle;
    return render::firstHit(ray, panes);
}

render::Camera CrepuscularRays::bestView(const ParameterValues&) const
{
    // The visitor stands where the banner hides the sun, and its shadow parts the beam.
    return {{-3.5, -0.85, 10.3}, {-0.2, 0.35, -0.5}, 0.907571};
}

double CrepuscularRays::nextChange(const ParameterValues& values, double) const
{
    const bool drifts = values[table_.driftSpeed] > 0 && acts(values, table_.driftSpeed.row);
    const bool moves = values[table_.animate] && (values[table_.turnSpeed] > 0 || drifts);
    return moves ? 0 : std::numeric_limits<double>::infinity();
}

double CrepuscularRays::turnOfHangings(const ParameterValues& values, double time) const
{
    const double start = values[table_.mobileRotation];
    if (!values[table_.animate] || !std::isfinite(time)) return start;
    return start + 2 * std::numbers::pi * std::fmod(values[table_.turnSpeed] * time, 1.0);
}

bool CrepuscularRays::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

std::vector<StudyView> CrepuscularRays::studyViews(const ParameterValues& values) const
{
    return {{"best view", bestView(values), 0, values},
            {"window ahead", {{0, -0.85, 4.5}, {0, 2.2, -3.5}, 0.959931}, 0, values},
            {"sun beyond the edge", {{-2.2, -0.85, 6.5}, {-3.6, -1.85, -3.0}, 0.7}, 0, values},
            {"banner in the beam", {{-3.3, -0.2, 8.5}, {-0.6, 1.4, 0.5}, 0.8}, 0, values}};
}

std::vector<OfferedComparison> CrepuscularRays::comparisons() const
{
    const auto technique = [](RayTechnique t) { return std::pair<std::string_view, Value>("technique", double(t)); };
    return {
        {"without",
         "No beams",
         "The hall in clear air, without beams and dust: compare what they add.",
         {technique(RayTechnique::none)}},
        {"screen",
         "Gathered in screen space",
         "Walk until the sun leaves the picture: these beams fade, because the method only knows what is in the "
         "picture.",
         {technique(RayTechnique::screen)}},
        {"air",
         "Marched through the air",
         "Sunlight scattered by the dusty air, in every direction of view, with the shadows of the hanging objects.",
         {technique(RayTechnique::volume)}}};
}

void CrepuscularRays::planOverFrame(const PlanContext& context, render::FramePlan& plan) const
{
    RaysScene s = raysScene(table_, context, plan);
    const RayView view = context.values[table_.view];
    const bool maskShown = view == RayView::mask;
    // The views "mask" and "light alone" are drawn even if they are black. Only in the picture are rays an effect that
    // may be left out.
    const bool effect = view == RayView::picture;
    const render::ContributionBound rays = effect ? screenRaysBound(s) : render::ContributionBound{};
    const render::ContributionBound haze = effect ? hazeBound(s, plan.view) : render::ContributionBound{};
    const render::ContributionBound air = effect ? beamBound(s, plan.view) : render::ContributionBound{};
    const auto uses = [&s](RayTechnique technique) {
        return render::required(s.uses(technique), "the selected technique does not make them");
    };
    const render::Factor noMask{maskShown ? 0.0 : 1.0, "the mask is shown"};
    const bool raysShown = maskShown ? isDrawn({}, rays, {}, {"crepuscular_rays/mask", "crepuscular_rays/rays"}, plan)
                                     : isDrawn({uses(RayTechnique::screen)}, rays, s.sunAhead(),
                                               {"crepuscular_rays/mask", "crepuscular_rays/rays"}, plan);
    const bool hazeShown =
        isDrawn({uses(RayTechnique::volume), noMask}, haze, s.endOfAir(), {"crepuscular_rays/haze"}, plan);
    const bool airShown =
        isDrawn({uses(RayTechnique::volume), noMask}, air, s.anyBeam(), {"crepuscular_rays/march"}, plan);

    RayImages made;
    if (raysShown) {
        made.mask = planMask(s, plan);
        if (!maskShown) made.gathered = planGathering(s, *made.mask, plan);
    }
    if (airShown) made.scattered = planMarch(s, plan);
    made.haze = hazeShown;
    render::ContributionBound both;
    if (effect)
        both = {hazeShown ? haze.relative : 0,
                (hazeShown ? haze.absolute : 0) + (airShown ? air.absolute : 0) + (raysShown ? rays.absolute : 0),
                {}};
    const bool asked = s.uses(RayTechnique::screen) || s.uses(RayTechnique::volume);
    if (raysShown || hazeShown || airShown || (!effect && asked))
        planComposite(s, made, std::move(both), plan);
    else
        plan.skip("crepuscular_rays/composite",
                  render::whyZero({render::required(asked, "the selected technique does not make them"),
                                   {0, "there are no beams to add to the picture"}}));
}

}  // namespace vitrine::crepuscular_rays

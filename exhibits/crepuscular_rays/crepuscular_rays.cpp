#include "exhibits/crepuscular_rays/crepuscular_rays.h"

#include "exhibits/crepuscular_rays/rays_scene.h"
#include "shaders/lib/bindings.glsl"

#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine {
namespace {

constexpr const char* screenPasses[] = {"crepuscular_rays/mask", "crepuscular_rays/rays"};
constexpr const char* beamPass = "crepuscular_rays/march";
constexpr const char* lastPass = "crepuscular_rays/composite";

/// Lays what was made over the frame. `shown` says what there is, by the bits of the techniques.
void planComposite(const RaysScene& s, int shown, render::FramePlan& plan)
{
    const RayView view = s.values[s.table.view];
    render::Pass pass = s.pass("composite", view == RayView::picture ? "the beams lie over the picture" : "the view of the beams alone is on", "crepuscular_rays/composite.frag");
    pass.stage = render::Stage::volume;
    pass.colors = {{radianceImage, render::Load::keep, {}, -1, 0}};
    pass.state.blend = view == RayView::picture ? render::Blend::premultiplied : render::Blend::none;
    pass.inputs = {{UNIT_SOURCE, std::string(depthImage)}};
    if (view == RayView::mask) {
        pass.shader.defines.emplace_back("SHOW_MASK");
        pass.inputs.push_back({UNIT_EXHIBIT_A, std::string("crepuscular_rays.mask")});
    } else if ((shown & static_cast<int>(RayTechnique::screen)) != 0) {
        const bool polar = methodOf(s) == RayMethod::polar;
        pass.shader.defines.emplace_back(polar ? "POLAR" : "SCREEN");
        pass.inputs.push_back({UNIT_EXHIBIT_A, std::string(polar ? "crepuscular_rays.polar" : "crepuscular_rays.rays")});
        pass.counts["fetches"] = static_cast<std::int64_t>(plan.view.raster.drawn().x) * plan.view.raster.drawn().y * (polar ? 2 : s.block.grid.x > 1 ? 9 : 1);
    }
    if (view != RayView::mask && (shown & static_cast<int>(RayTechnique::volume)) != 0) {
        pass.shader.defines.emplace_back("VOLUME");
        pass.inputs.push_back({UNIT_EXHIBIT_B, std::string("crepuscular_rays.scattered")});
        for (const render::Input& input : s.context.surroundings.inputs)
            if (input.unit == UNIT_PROBE_IRRADIANCE) pass.inputs.push_back(input);
    }
    if (view != RayView::picture) pass.shader.defines.emplace_back("REPLACE");
    pass.blocks[BLOCK_LIGHT] = render::bytesOf(s.context.surroundings.light);
    plan.add(std::move(pass));
}

}  // namespace

render::Box CrepuscularRays::bounds(const ParameterValues&) const
{
    return {{-1.3, -1.15, -3.6}, {1.3, 3.95, -3.0}};
}

render::Camera CrepuscularRays::bestView(const ParameterValues&) const
{
    return {{2.35, -0.85, 13.2}, {-0.55, 0.25, -0.5}, 0.959931};
}

double CrepuscularRays::nextChange(const ParameterValues& values, double) const
{
    return values[table_.animate] && values[table_.turnSpeed] > 0 ? 0 : std::numeric_limits<double>::infinity();
}

double CrepuscularRays::turnOfHangings(const ParameterValues& values, double time) const
{
    const double start = values[table_.turn];
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
            {"sun beyond the edge", {{-2.2, -0.85, 6.5}, {-3.6, 0.6, -3.0}, 0.7}, 0, values},
            {"banner in the beam", {{3.3, -0.2, 8.5}, {0.6, 1.4, 0.5}, 0.8}, 0, values}};
}

void CrepuscularRays::planOverFrame(const PlanContext& context, render::FramePlan& plan) const
{
    RaysScene s = raysScene(table_, context, plan);
    const bool maskShown = context.values[table_.view] == RayView::mask;
    std::string noRays = s.uses(RayTechnique::screen) || maskShown ? std::string() : "no technique in use makes them";
    std::string noBeams = s.uses(RayTechnique::volume) && !maskShown ? std::string() : "no technique in use makes them";
    // What is invisible may be drawn all the same, to prove that it is; what cannot be drawn may not.
    if (noRays.empty() && (!plan.runEverything || !s.sun.inFront)) noRays = whyNoScreenRays(s);
    if (noBeams.empty() && (!plan.runEverything || s.beams.empty())) noBeams = whyNoBeams(s, plan.view);

    int shown = 0;
    if (noRays.empty()) {
        planMask(s, plan);
        if (!maskShown) planGathering(s, plan);
        shown |= static_cast<int>(RayTechnique::screen);
    } else {
        for (const char* pass : screenPasses) plan.skip(pass, noRays);
    }
    if (noBeams.empty()) {
        planMarch(s, plan);
        shown |= static_cast<int>(RayTechnique::volume);
    } else {
        plan.skip(beamPass, noBeams);
    }
    if (shown != 0) planComposite(s, shown, plan);
    else plan.skip(lastPass, s.uses(RayTechnique::volume) ? noBeams : noRays);
}

}  // namespace vitrine

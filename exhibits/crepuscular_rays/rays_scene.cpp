#include "exhibits/crepuscular_rays/rays_scene.h"

#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/pixel_blocks.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>

namespace vitrine::crepuscular_rays {
namespace {

// Shown alone, the exhibit has an opening in the position of the hall's tall window, in its own space and without
// walls.
const render::Box ownOpening{{-1.2, -1.1, -4.0}, {1.2, 3.9, -3.4}};
const render::Box ownRoom{{-6, -2.5, -3.5}, {6, 6.5, 20.5}};

constexpr int largestMask = 2048;  ///< Pixels along a side; also a print of any size needs no finer mask of its sky.

int cellSize(RayResolution resolution)
{
    return resolution == RayResolution::full ? 1 : resolution == RayResolution::half ? 2 : 4;
}

/// Returns the view of the whole picture at the size of the mask, with the jitter of the sample.
render::View viewOfWhole(const render::View& view, glm::ivec2 size)
{
    render::View whole = view;
    whole.raster.size = size;
    whole.raster.offset = whole.raster.tile = glm::ivec2(0);
    whole.raster.jitter = view.raster.jitter * (glm::dvec2(size) / glm::dvec2(view.raster.size));
    glm::dmat4 shift(1);
    const glm::dvec2 moved = -2.0 * whole.raster.jitter / glm::dvec2(size);
    shift[3][0] = moved.x;
    shift[3][1] = moved.y;
    whole.clipFromView = shift * render::reversedPerspective(view.tanHalfFov, view.nearPlane, view.tanShift);
    whole.clipFromWorld = whole.clipFromView * view.viewFromWorld;
    return whole;
}

/// Returns the displacement of the dust by the draft in meters: past the banner, and up.
glm::dvec3 dustMoved(const CrepuscularRaysTable& table, const ParameterValues& values, double time)
{
    constexpr double farthest = 4096;  // A float still resolves millimeters here; the dust gets there in a day.
    if (!values[table.animate] || !std::isfinite(time)) return glm::dvec3(0);
    return glm::dvec3(0.8, 0.2, 0.56) * std::fmod(values[table.driftSpeed] * time, farthest);
}

double mostOf(const glm::dvec3& color)
{
    return std::max({color.x, color.y, color.z});
}

void fillBeams(const std::vector<Beam>& beams, RaysBlock& block)
{
    const std::size_t opened = std::min<std::size_t>(beams.size(), MOST_BEAMS);
    for (std::size_t i = 0; i < opened; ++i) {
        BeamBlock& beam = block.beams[i];
        beam.openingLow = glm::vec3(beams[i].opening.low);
        beam.openingHigh = glm::vec3(beams[i].opening.high);
        beam.axis = beams[i].axis;
        beam.plane = static_cast<float>(beams[i].plane);
        beam.airLow = glm::vec3(beams[i].box.low);
        beam.airHigh = glm::vec3(beams[i].box.high);
    }
    block.beamCount = static_cast<int>(opened);
}

}  // namespace

render::Pass RaysScene::pass(const char* name, std::string reason, std::string fragment) const
{
    render::Pass pass = exhibitPass(std::string("crepuscular_rays/") + name, std::move(reason), values,
                                    "lib/fullscreen.vert", std::move(fragment));
    pass.draws = {render::Draw{}};
    pass.draws[0].object = render::std140Bytes(block);
    return pass;
}

render::Factor RaysScene::endOfAir() const
{
    if (context.onNothing) return {0, "there is no background behind the air"};
    return render::required(context.lighting.background != BACKGROUND_STUDIO,
                            "the exhibit is shown alone, without walls to bound the air");
}

render::Factor RaysScene::anyBeam() const
{
    const SceneLighting& around = context.lighting;
    if (around.sunIrradiance == glm::dvec3(0)) return {0, around.sunShadow.whyNone};
    return {beams.empty() ? 0.0 : 1.0, context.alone ? "no sunbeam wider than 30 cm comes in through the window"
                                                     : "no sunbeam wider than 30 cm comes in through window or oculus"};
}

RaysScene raysScene(const CrepuscularRaysTable& table, const PlanContext& context, const render::FramePlan& plan)
{
    const ParameterValues& values = context.values;
    const SceneLighting& around = context.lighting;
    const render::Raster& raster = plan.view.raster;
    RaysScene s{table, context, values, {}, raster.drawn() != raster.size, {}, {}, {}, {}, {}, {}};

    // Mask pixels are picture pixels, except for tiles of a very large picture.
    const double maskScale =
        s.tile ? std::min(1.0, static_cast<double>(largestMask) / std::max(raster.size.x, raster.size.y)) : 1.0;
    s.maskSize = glm::max(glm::ivec2(glm::round(glm::dvec2(raster.size) * maskScale)), glm::ivec2(1));
    s.wholeView = viewOfWhole(plan.view, s.maskSize);
    s.sun = sunInPicture(s.wholeView, around.towardsSun);
    // Beams exist only while the sun shines.
    if (around.sunIrradiance != glm::dvec3(0))
        s.beams = context.alone ? beams(std::span(&ownOpening, 1), ownRoom, around.towardsSun)
                                : beams(around.openings, around.room, around.towardsSun);
    // If the exhibit is shown alone, there is air in the beam only.
    s.air = !context.alone ? around.room : s.beams.empty() ? ownRoom : s.beams.front().box;

    const PixelBlocks cells(raster, cellSize(values[table.resolution]));
    s.coarseSize = cells.count;
    RaysBlock& b = s.block;
    b.cellSize = static_cast<float>(cells.side);
    b.firstCell = glm::vec2(cells.first);
    b.maskScale = static_cast<float>(maskScale);

    b.technique = static_cast<int>(values[table.technique]);

    const double height = s.maskSize.y;
    const double distance = glm::length(s.sun.pixel - 0.5 * glm::dvec2(s.maskSize)) / height;
    const bool plain = values[table.sum] == RaySum::plain;
    const double reach = plain ? 1 : std::max(distance / values[table.streak], 1.0);
    b.sun = glm::vec2(s.sun.pixel - s.wholeView.raster.jitter);
    b.exponent = static_cast<float>(glsl::shaftExponentAt(values[table.decay], reach));
    b.gathered = static_cast<float>(glsl::shaftDensity(values[table.density], reach));
    const glm::dvec3& sunLight = around.sunIrradiance;
    const glm::dvec3 sunColor = sunLight / std::max({sunLight.x, sunLight.y, sunLight.z, 1e-6});
    const double fade = plain ? (s.sun.inFront ? 1 : 0) : glsl::shaftEdgeFade(s.sun.beyond, values[table.edgeFade]);
    // Strength is relative to the finished picture, so exposure is divided out. It is proportional to the strength of
    // the sun, and 1 at the sun's initial strength.
    const double strength = values[table.weight] * std::exp2(values[table.rayExposure]) * fade * around.sunShare /
                            std::max(around.exposure, 1e-9);
    b.strength = glm::vec3(values[table.tint].value * sunColor * strength);
    b.inverseExposure = static_cast<float>(1 / std::max(around.exposure, 1e-9));
    b.threshold = static_cast<float>(values[table.threshold]);
    b.lightAngle = static_cast<float>(values[table.lightSize]);
    b.skyColors = values[table.skyColor];
    b.shiftSamples = values[table.jitter];
    fillBeams(s.beams, b);
    b.airLow = glm::vec3(s.air.low);
    b.airHigh = glm::vec3(s.air.high);
    b.drift = glm::vec3(dustMoved(table, values, context.time));
    return s;
}

render::ContributionBound screenRaysBound(const RaysScene& s)
{
    const ParameterValues& values = s.values;
    const SceneLighting& around = s.context.lighting;
    const bool plain = values[s.table.sum] == RaySum::plain;
    const bool outside = !around.room.contains(s.wholeView.eye);
    const bool sky = s.context.alone || outside ||
                     std::any_of(around.openings.begin(), around.openings.end(),
                                 [&](const render::Box& opening) { return s.wholeView.mayContain(opening); });
    const glm::dvec3 tint = values[s.table.tint].value;
    const double fade = plain ? 1 : glsl::shaftEdgeFade(s.sun.beyond, values[s.table.edgeFade]);
    // The mask and its mean are at most 1; the plain sum adds up all samples.
    return render::boundOf(0, plain ? values[s.table.samples] : 1,
                           {render::required(values[s.table.weight] > 0, "the weight of the rays is 0"),
                            {plain && !(values[s.table.density] > 0) ? 0.0 : 1.0, "the density of the rays is 0"},
                            render::required(around.sunShare > 0, around.sunShadow.whyNone),
                            render::required(mostOf(tint) > 0, "the tint of the rays is black"),
                            s.sunAhead(),
                            render::required(fade > 0, "the sun is too far beyond the picture's edge"),
                            {std::max({s.block.strength.x, s.block.strength.y, s.block.strength.z}),
                             "the sun has no light of the color of the tint"},
                            render::required(sky, "no sky is in view")});
}

namespace {

/// Returns the largest opacity of the air: the longest ray is the diagonal of its box, at the density on the floor.
double mostHidden(const RaysScene& s)
{
    return -std::expm1(-s.values[s.table.airDensity] * 2 * glm::length(s.air.halfSize()));
}

}  // namespace

render::ContributionBound hazeBound(const RaysScene& s, const render::View& view)
{
    const double hidden = mostHidden(s);
    const double scattered =
        mostOf(s.values[s.table.airColor].value) * s.values[s.table.ambient] * s.context.lighting.brightest;
    return render::boundOf(hidden, hidden * scattered,
                           {render::required(s.values[s.table.airDensity] > 0, "the air is clear"), s.endOfAir(),
                            render::required(view.mayContain(s.air), "the air is out of view")});
}

render::ContributionBound beamBound(const RaysScene& s, const render::View& view)
{
    const bool seen =
        std::any_of(s.beams.begin(), s.beams.end(), [&](const Beam& beam) { return view.mayContain(beam.box); });
    const double ahead = glsl::airPhase(1.0, std::abs(s.values[s.table.anisotropy]));
    const double drift = 1 + 1.5 * s.values[s.table.densityNoise];
    const glm::dvec3& sun = s.context.lighting.sunIrradiance;
    const glm::dvec3 scattered = s.values[s.table.airColor].value;
    return render::boundOf(0, ahead * drift * static_cast<double>(std::max<std::size_t>(s.beams.size(), 1)),
                           {{mostHidden(s), "the air is clear"},
                            {mostOf(scattered), "the dust swallows all light"},
                            {s.values[s.table.beamStrength], "the strength of the beams is 0"},
                            s.anyBeam(),
                            {mostOf(sun * scattered) > 0 ? mostOf(sun) : 0, "the dust swallows the light of the sun"},
                            render::required(seen, "the beams are out of view")});
}

}  // namespace vitrine::crepuscular_rays

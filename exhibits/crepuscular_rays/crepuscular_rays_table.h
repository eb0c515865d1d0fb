#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"

namespace vitrine::crepuscular_rays {

enum class RayTechnique : int { none, screen, volume, both };
enum class RayMethod : int { loop, threePasses, polar };
enum class RaySum : int { mean, plain };
enum class RayMask : int { depth, alpha, occluders };
enum class RayResolution : int { full, half, quarter };
enum class RayView : int { picture, mask, light };

/// All parameters of the sunbeams.
struct CrepuscularRaysTable final : Parameters {
    Group show = group("Display");
    Choice<RayTechnique> technique =
        choice("technique", RayTechnique::volume, {"none", "screen space", "volume", "both"},
               "Technique that makes the beams: blurring the bright sky across the picture (screen space), or ray "
               "marching the sun's shadows through dusty air (volume).",
               quality(RayTechnique::volume), essential());
    Choice<RayView> view = choice("view", RayView::picture, {"picture", "mask", "light alone"},
                                  "Picture to show: the finished one, the mask with its occluders black, or only the "
                                  "added light without the hall.",
                                  essential());

    const Condition screenSpace =
        when(technique, {RayTechnique::screen, RayTechnique::both}) or when(view, RayView::mask);
    const Condition volume =
        when(technique, {RayTechnique::volume, RayTechnique::both}) and whenNot(view, RayView::mask);
    const Condition anyBeams = whenNot(technique, RayTechnique::none) and whenNot(view, RayView::mask);

    Group rays = group("Screen space");
    Real weight = real(
        "weight", 0.8, none, Range{0, 10}.soft(0, 1),
        "Strength of the screen-space rays: 0 makes none. In the plain sum, the strength of each sample.", screenSpace);
    Real decay = real("decay", 0.994, none, Range{0, 1}.soft(0.9, 1),
                      "Share of the light that is left after each 128th of the way: 1 lets the sky reach everywhere, "
                      "low keeps rays short.",
                      screenSpace);
    Real density =
        real("density", 1.0, none, {0, 1},
             "Share of the way to the sun over which light is gathered: 0 shows only the mask, 1 gathers all the way.",
             screenSpace);
    Real rayExposure = real("rayExposure", 0.0, stop, Range{-16, 16}.soft(-4, 4),
                            "Brightness of the rays: each stop doubles it.", screenSpace);
    Color tint = color("tint", {1.0, 0.86, 0.66}, "Color of the rays, multiplied with the sun's own.", screenSpace);
    Choice<RaySum> sum = choice("sum", RaySum::mean, {"mean", "plain sum"},
                                "Summation along the ray: the mean, whose brightness does not depend on the number of "
                                "samples, or the plain sum of the reference, which grows with it.",
                                screenSpace);
    Real streak = real("streak", 1.0, none, Range{0.05, 16}.soft(0.25, 3),
                       "Largest length of the rays when the sun is far outside the picture, in picture heights.",
                       screenSpace and when(sum, RaySum::mean));
    Real edgeFade = real("edgeFade", 1.5, none, Range{0.01, 8}.soft(0.1, 4),
                         "Distance of the sun outside the picture at which its rays have faded, in half picture sizes.",
                         screenSpace and when(sum, RaySum::mean));

    Group maskGroup = group("Mask");
    Choice<RayMask> mask = choice("mask", RayMask::depth, {"depth", "alpha", "occluders"},
                                  "Method that separates the sky from the occluders: depth, coverage (alpha), or "
                                  "drawing the occluders once more.",
                                  screenSpace);
    Toggle skyColor = toggle(
        "skyColor", true, "Whether the mask carries the colors of the sky; otherwise it is plain white.", screenSpace);
    Real threshold = real(
        "threshold", 0.0, none, {0, 1},
        "Brightness below which the sky gives no rays: 0 uses all of it, high only the brightest parts.", screenSpace);
    Real lightSize =
        real("lightSize", degrees(90), degree, Range{degrees(0.05), degrees(180)}.soft(degrees(1), degrees(180)),
             "Angle around the sun within which the sky gives rays: 180° uses the whole sky.", screenSpace);

    Group air = group("Air");
    Real airDensity =
        real("airDensity", 0.004, perMeter, Range{0, 10}.soft(0, 0.05),
             "Density of the dust near the floor, as the share of light that a meter of it removes: 0 is clear air.",
             volume, essential());
    Real densityFalloff = real("densityFalloff", 0.03, perMeter, Range{0, 10}.soft(0, 0.5),
                               "Rate at which the dust thins with height: 0 is even, high keeps it near the floor.",
                               volume and whenAbove(airDensity, 0));
    Real anisotropy = real("anisotropy", 0.4, none, Range{-0.95, 0.95}.soft(-0.5, 0.9),
                           "Direction in which the dust scatters: 0 to all sides, positive forward with a glow towards "
                           "the sun, negative backward.",
                           volume and whenAbove(airDensity, 0) and whenLaterAbove("beamStrength", 0));
    Real beamStrength =
        real("beamStrength", 5.0, none, Range{0, 100}.soft(0, 8),
             "Strength of the sunlight that the dust scatters: 1 is physical for the air density, 0 shows no beams.",
             volume and whenAbove(airDensity, 0), essential());
    Real ambient =
        real("ambient", 0.12, none, Range{0, 100}.soft(0, 2),
             "Strength of the hall's ambient light that the dust scatters: 1 is physical, at 0 the dust only darkens.",
             volume and whenAbove(airDensity, 0));
    Color airColor =
        color("airColor", {1.0, 0.9, 0.74},
              "Color of the dust, as the share of light that it scatters rather than absorbs: white absorbs none.",
              volume and whenAbove(airDensity, 0));
    Real densityNoise =
        real("densityNoise", 0.7, none, {0, 1}, "Unevenness of the dust: 0 is even air, high gathers it in drifts.",
             volume and whenAbove(airDensity, 0) and whenAbove(beamStrength, 0));

    Group accuracy = group("Accuracy");
    // Measured at 1280 x 720: for an RMSE of 0.002 the loop needs 105 fetches per pixel, three passes need 20, and the
    // polar sum needs 3.3.
    Choice<RayMethod> method = choice("method", RayMethod::polar, {"loop", "three passes", "polar sum"},
                                      "Method to average along a ray: sample by sample, three passes that build on "
                                      "each other's results, or a running sum on a polar grid.",
                                      quality(RayMethod::loop), screenSpace and when(sum, RaySum::mean));
    Count samples = count("samples", 216, {1, 4096, logarithmic},
                          "Number of samples along a ray: few show bands. With three passes, each takes the cube root "
                          "of this number; the polar grid has two cells per sample.",
                          quality(4096), screenSpace);
    Toggle jitter = toggle(
        "jitter", true,
        "Whether samples and steps are shifted by blue noise: too few of them then look like grain, not like bands.",
        quality(1), anyBeams);
    Count volumeSteps =
        count("volumeSteps", 16, {1, 1024, logarithmic},
              "Number of steps in which a ray crosses the beams of the volume: few are noisy, many cost more.",
              quality(1024), volume and whenAbove(airDensity, 0) and whenAbove(beamStrength, 0), essential());
    Choice<RayResolution> resolution =
        choice("resolution", RayResolution::half, {"full", "half", "quarter"},
               "Resolution at which the beams are computed; lower ones are upsampled with regard to depth.",
               exactAt(RayResolution::full), anyBeams, essential());
    StudiedParameters studied{
        *this,
        {{.name = "samples", .settles = "The polar grid has at most 4096 cells a side: four for each of 1024 samples."},
         {.name = "jitter", .exactInReference = {"volumeSteps", "samples"}}}};

    Group hangings = group("Hangings");
    Toggle animate = toggle("animate", false, "Whether the draft turns the mobile and carries the dust.");
    Real mobileRotation = real("mobileRotation", degrees(20.0535), degree, {degrees(-180), degrees(180)},
                               "Rotation of the mobile about its axis.");
    Real turnSpeed = real("turnSpeed", 0.02, hertz, Range{0, 2}.soft(0, 0.1),
                          "Speed of the animated mobile, in turns per second.", when(animate));
    Real driftSpeed = real("driftSpeed", 0.04, none, Range{0, 10}.soft(0, 0.3),
                           "Speed at which the draft carries the drifts of dust, in meters per second.",
                           when(animate) and volume and whenAbove(densityNoise, 0));
};

}  // namespace vitrine::crepuscular_rays

#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/studied_rows.h"

namespace vitrine {

enum class RayTechnique : int { none, screen, volume, both };
enum class RayMethod : int { loop, threePasses, polar };
enum class RaySum : int { mean, plain };
enum class RayMask : int { depth, alpha, occluders };
enum class RayResolution : int { full, half, quarter };
enum class RayView : int { picture, mask, light };

/// All parameters of the sunbeams.
struct CrepuscularRaysTable final : Parameters {
    Group show = group("On show");
    Choice<RayTechnique> technique =
        choice("technique", RayTechnique::volume, {"none", "screen space", "volume", "both"},
               "How the beams are made: smeared from the bright sky across the picture, or by marching the sun's "
               "shadows through dusty air.",
               quality(RayTechnique::volume));
    Choice<RayView> view =
        choice("view", RayView::picture, {"picture", "mask", "light alone"},
               "The finished picture, the mask with its occluders black, or the added light without the hall.");

    const Condition screenSpace =
        when(technique, {RayTechnique::screen, RayTechnique::both}) or when(view, RayView::mask);
    const Condition volume =
        when(technique, {RayTechnique::volume, RayTechnique::both}) and whenNot(view, RayView::mask);
    const Condition anyBeams = whenNot(technique, RayTechnique::none) and whenNot(view, RayView::mask);

    Group rays = group("Screen space");
    Real weight =
        real("weight", 0.8, none, Range{0, 10}.soft(0, 1),
             "Strength of the rays in the sun's initial light: 0 makes none. In the plain sum, of each sample.",
             screenSpace);
    Real decay = real("decay", 0.994, none, Range{0, 1}.soft(0.9, 1),
                      "How much of the light is left after each 128th of the way: 1 lets the sky reach everywhere, low "
                      "keeps it near.",
                      screenSpace);
    Real density =
        real("density", 1.0, none, {0, 1},
             "How far towards the light is gathered: 0 sees the mask alone, 1 goes all the way.", screenSpace);
    Real rayExposure = real("rayExposure", 0.0, stop, Range{-16, 16}.soft(-4, 4),
                            "Brightness of the rays: each stop doubles it.", screenSpace);
    Color tint = color("tint", {1.0, 0.86, 0.66}, "Color of the rays, on top of the sun's own.", screenSpace);
    Choice<RaySum> sum = choice("sum", RaySum::mean, {"mean", "plain sum"},
                                "The mean over the way, which no number of samples makes brighter or darker; or the "
                                "plain sum of the museum that this exhibit follows, which grows with them.",
                                screenSpace);
    Real streak = real("streak", 1.0, none, Range{0.05, 16}.soft(0.25, 3),
                       "How long rays may become when the sun is far beyond the edge, in heights of the picture.",
                       screenSpace and when(sum, RaySum::mean));
    Real edgeFade =
        real("edgeFade", 1.5, none, Range{0.01, 8}.soft(0.1, 4),
             "How far beyond the picture's edge the sun may be before its rays have faded, in halves of the picture.",
             screenSpace and when(sum, RaySum::mean));

    Group maskGroup = group("Mask");
    Choice<RayMask> mask = choice("mask", RayMask::depth, {"depth", "alpha", "occluders"},
                                  "How the sky is told from what hides it: by depth, by what is not yet covered, or by "
                                  "drawing the occluders once more.",
                                  screenSpace);
    Toggle skyColor =
        toggle("skyColor", true, "Let the mask carry the colors of the sky instead of plain white.", screenSpace);
    Real threshold = real("threshold", 0.0, none, {0, 1},
                          "Brightness below which the sky gives no rays: 0 lets all of it.", screenSpace);
    Real lightSize =
        real("lightSize", degrees(90), degree, Range{degrees(0.05), degrees(180)}.soft(degrees(1), degrees(180)),
             "How far around the sun the sky gives rays: 180° is all of it.", screenSpace);

    Group air = group("Air");
    Real airDensity =
        real("airDensity", 0.007, perMeter, Range{0, 10}.soft(0, 0.05),
             "Dust in the air: what a meter of it takes out of a beam near the floor; 0 is clear air.", volume);
    Real densityFalloff = real("densityFalloff", 0.03, perMeter, Range{0, 10}.soft(0, 0.5),
                               "How fast the dust thins with height: 0 is even, high keeps it near the floor.",
                               volume and whenAbove(airDensity, 0));
    Real anisotropy = real("anisotropy", 0.2, none, Range{-0.95, 0.95}.soft(-0.5, 0.9),
                           "How much the dust scatters forward: 0 to all sides, high glows towards the sun.",
                           volume and whenAbove(airDensity, 0) and whenLaterAbove("beamStrength", 0));
    Real beamStrength = real("beamStrength", 2.6, none, Range{0, 100}.soft(0, 4),
                             "Of the light that the beams scatter: 1 is physical for the density above.",
                             volume and whenAbove(airDensity, 0));
    Real ambient = real("ambient", 0.35, none, Range{0, 100}.soft(0, 2),
                        "Of the hall's own light that the air scatters: 1 is physical, 0 makes the dust only darken.",
                        volume and whenAbove(airDensity, 0));
    Color airColor = color("airColor", {1.0, 0.97, 0.93},
                           "Share of the light that the dust scatters rather than swallows: white swallows none.",
                           volume and whenAbove(airDensity, 0));
    Real densityNoise = real("densityNoise", 0.35, none, {0, 1}, "How much the dust gathers in drifts; 0 is even air.",
                             volume and whenAbove(airDensity, 0) and whenAbove(beamStrength, 0));

    Group accuracy = foldedGroup("Accuracy");
    // Measured at 1280 x 720: for an RMSE of 0.002 the loop needs 105 fetches per pixel, three passes need 20, and the
    // polar sum needs 3.3.
    Choice<RayMethod> method = choice("method", RayMethod::polar, {"loop", "three passes", "polar sum"},
                                      "How the mean along a ray is found: sample by sample, by three passes over each "
                                      "other's results, or by a running sum on a polar grid.",
                                      quality(RayMethod::loop), screenSpace and when(sum, RaySum::mean));
    Count samples =
        count("samples", 216, {1, 4096, logarithmic},
              "Points along a ray: three passes take the cube root each, the polar grid takes two cells a point.",
              quality(4096), screenSpace);
    Toggle jitter =
        toggle("jitter", true,
               "Shift samples and steps by blue noise, so that too few of them look like grain and not like bands.",
               quality(1), anyBeams);
    Count volumeSteps =
        count("volumeSteps", 16, {1, 1024, logarithmic}, "Steps in which a ray crosses a beam of the volume.",
              quality(1024), volume and whenAbove(airDensity, 0) and whenAbove(beamStrength, 0));
    Choice<RayResolution> resolution =
        choice("resolution", RayResolution::half, {"full", "half", "quarter"},
               "Of the beams, before they are brought up to the picture's with regard to its depth.",
               exactAt(RayResolution::full), anyBeams);
    StudiedRows studied{
        *this,
        {{.name = "samples", .settles = "The polar grid has at most 4096 cells a side: four for each of 1024 samples."},
         {.name = "jitter", .exactInReference = {"volumeSteps", "samples"}}}};

    Group hangings = group("Hangings");
    Toggle animate = toggle("animate", false, "Let the draft turn the mobile and carry the dust.");
    Real mobileRotation = real("mobileRotation", degrees(20.0535), degree, {degrees(-180), degrees(180)},
                               "How far the mobile has turned.");
    Real turnSpeed = real("turnSpeed", 0.02, hertz, Range{0, 2}.soft(0, 0.1),
                          "Turns of the mobile in a second, while it is animated.", when(animate));
    Real driftSpeed = real("driftSpeed", 0.04, none, Range{0, 10}.soft(0, 0.3),
                           "Meters per second at which the draft carries the drifts of dust.",
                           when(animate) and volume and whenAbove(densityNoise, 0));
};

}  // namespace vitrine

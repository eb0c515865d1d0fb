#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"
#include "render/image/picture_formats.h"

namespace vitrine::paper_lanterns {

enum class LakeShow : int { picture, heights, normals, parts };
enum class LakeLook : int { physical, reference };
enum class LakeRelease : int { rises, driftsAway };
enum class LakeRide : int { reference, water };
enum class LakeSpeed : int { reference, dispersion };
enum class LakeFlicker : int { together, own };
enum class LakeRepetition : int { ownCell, twoByTwo, threeByThree, cellWall };

/// All parameters of the lake of lanterns. Lengths are in meters of the lake's own world, in which a lantern is two
/// meters high, as in the reference.
struct PaperLanternsTable final : Parameters {
    Group view = group("Display");
    Choice<LakeShow> show = choice("show", LakeShow::picture, {"picture", "heights", "normals", "parts"},
                                   "Picture to show: the finished one, the height of the water, its normals, or the "
                                   "parts of the lanterns in separate colors.");
    Choice<LakeLook> look = choice(
        "look", LakeLook::physical, {"physically based", "reference"},
        "Lighting model: physically based, with translucent paper and Fresnel reflections, or that of the reference.");
    Toggle animate = toggle("animate", false, "Whether time runs: waves roll, flames flicker, lanterns drift.");
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 60),
                       "Time that is shown, or at which the animation starts.");
    Real eyeHeight = real("eyeHeight", 4.8, meter, Range{0.5, 200, logarithmic}.soft(1, 30),
                          "Height of the middle of the frame above the calm water.");
    Real scale = real("scale", 3, none, Range{0.5, 100, logarithmic}.soft(1, 20),
                      "Scale of the lake, in meters of the lake per meter of the hall: high makes lanterns smaller.");
    Count seed = count("seed", 1, {0, 9999}, "Seed of lanterns and ripples: each number places them differently.");

    const Condition inPicture = when(show, LakeShow::picture);
    const Condition physical = when(look, LakeLook::physical) and inPicture;
    const Condition byReference = when(look, LakeLook::reference) and inPicture;
    const Condition rippled = when(look, LakeLook::physical) and when(show, {LakeShow::picture, LakeShow::normals});
    const Condition moving = when(animate) or whenNot(moment, 0);

    Group many = group("Lanterns");
    Count lanterns = count("lanterns", 30000, {1, 1000000, logarithmic},
                           "Number of grid cells for lanterns, in a square whose corner is at the frame: low is a few, "
                           "high reaches to the horizon.",
                           essential());
    Real crowding = real("crowding", 0.8, none, {0, 1},
                         "Share of the cells that hold a lantern: 0 is an empty lake, 1 fills every cell.");
    const Condition afloat = whenAbove(crowding, 0);
    Real spacing =
        real("spacing", 7.5, meter, Range{1, 100, logarithmic}.soft(4, 20),
             "Width of the cells, each of which contains one lantern; a wide lantern may need more.", afloat);
    Real irregularity =
        real("irregularity", 1, none, {0, 1},
             "Random shift of the lanterns from the middle of their cells: 0 is a regular grid.", afloat);
    Real turned =
        real("turned", 1, none, {0, 1}, "Random rotation of the lanterns: at 0 all face the same way.", afloat);
    Choice<LakeRide> ride =
        choice("ride", LakeRide::water, {"reference", "the water"},
               "Motion of the lanterns: on a separate wave as in the reference, or on the water under their base.",
               whenLaterAbove("waveHeight", 0));
    Real drift = real("drift", 0.12, none, Range{0, 20}.soft(0, 1),
                      "Speed at which the wind moves the lanterns, in meters per second.");
    Choice<LakeRelease> release =
        choice("release", LakeRelease::rises, {"rises", "drifts away"},
               "Path of the lantern that the button releases: up into the air, or away on the water.");

    Group candle = group("Candles");
    Toggle candles = toggle("candles", true, "Whether the candles burn.", inPicture);
    const Condition lit = when(candles) and inPicture;
    Real candleStrength = real("candleStrength", 1, none, Range{0, 20}.soft(0, 4),
                               "Strength of the flames' light: 0 gives none.", lit, essential());
    Color candleColor = color("candleColor", {1, 0.48, 0.15}, "Color of the flames' light.", lit);
    Real flameHeight =
        real("flameHeight", 0.55, meter, Range{0.1, 5}.soft(0.2, 1.6), "Height of the flame above the base.", lit);
    Real flicker = real("flicker", 1, none, {0, 1}, "Strength of the flickering: 0 burns evenly.", lit and afloat);
    Choice<LakeFlicker> flickerPhase = choice("flickerPhase", LakeFlicker::own, {"together", "each its own"},
                                              "Phase of the flickering: all flames together, or each on its own.",
                                              lit and whenAbove(flicker, 0) and afloat);
    Real hallGlow =
        real("hallGlow", 1, none, Range{0, 10}.soft(0, 3),
             "Strength of the lanterns' light on the wall and floor beside the frame: 0 gives none.", lit and afloat);

    Group paper = group("Paper");
    Color paperColor = color("paperColor", {0.97, 0.8, 0.5},
                             "Color of the paper, as the share of light that it does not absorb.", physical);
    Real paperThickness = real("paperThickness", 1.6, none, Range{0.05, 20, logarithmic}.soft(0.3, 6),
                               "Optical thickness of the paper, as the mean number of scattering events: low is clear "
                               "and bright, high is dim and white.",
                               physical);
    Real fibers = real("fibers", 0.5, none, {0, 1}, "Unevenness of the paper: 0 is smooth, 1 shows fibers.", inPicture);
    Real colors =
        real("colors", 0.3, none, {0, 1},
             "Variation of color between the papers: at 0 all are alike, at 1 they are as varied as at a festival.",
             physical and afloat);

    Group shape = group("Shape");
    Real paperRadius = real("paperRadius", 0.75, meter, Range{0.1, 3}.soft(0.3, 1.2), "Radius of the paper tube.");
    Real paperHeight = real("paperHeight", 2, meter, Range{0.2, 8}.soft(0.6, 4),
                            "Height of the upper edge of the paper above the middle of the base.");
    Real paperWall =
        real("paperWall", 0.06, meter, Range{0.005, 0.3}.soft(0.01, 0.15), "Thickness of the paper as it is drawn.");
    Real baseWidth = real("baseWidth", 2.2, meter, Range{0.2, 6}.soft(1, 3), "Side length of the wooden base.");
    Real baseThickness =
        real("baseThickness", 0.08, meter, Range{0.01, 1}.soft(0.02, 0.4), "Thickness of the wooden base.");
    Real ringWire =
        real("ringWire", 0.05, meter, Range{0.005, 0.3}.soft(0.01, 0.12), "Radius of the wire of the rings.");
    Real lowRing = real("lowRing", 0.08, meter, Range{0, 4}.soft(0, 0.8), "Height of the lower ring.");
    Real postWire = real("postWire", 0.05, meter, Range{0.005, 0.3}.soft(0.01, 0.12), "Radius of the posts.");
    Real frameBlend = real("frameBlend", 0.1, meter, Range{0, 0.5}.soft(0, 0.3),
                           "Width of the blend between posts and rings; 0 joins them sharply.");

    Group water = group("Water");
    Real waveHeight = real("waveHeight", 0.45, none, Range{0, 8}.soft(0, 3),
                           "Height of the five waves, relative to the reference: 0 is flat water.", essential());
    Choice<LakeSpeed> waveSpeed =
        choice("waveSpeed", LakeSpeed::dispersion, {"reference", "as gravity makes them"},
               "Speed of the waves: as in the reference, one rhythm for all; or by gravity, with long waves slow and "
               "short ones quick.",
               whenAbove(waveHeight, 0) and moving);
    Real ripples =
        real("ripples", 0.055, none, Range{0, 0.5}.soft(0, 0.15),
             "Slope of the small waves that the wind makes: 0 is calm, high stretches reflections.", rippled);
    Real windDirection = real("windDirection", degrees(65), degree, Range{degrees(-180), degrees(180)},
                              "Direction in which the wind blows, from straight ahead: negative is to the left.");
    Color waterColor = color("waterColor", {0.012, 0.03, 0.036}, "Color of deep water.", inPicture);
    Real exaggeration =
        real("exaggeration", 1, none, Range{0, 20}.soft(0, 8),
             "Exaggeration of heights and slopes in the pictures of heights and normals: 1 is true to scale.",
             when(show, {LakeShow::heights, LakeShow::normals}));

    Group sky = group("Moon and sky");
    Real moon = real("moon", 0.5, none, Range{0, 20}.soft(0, 3),
                     "Strength of the moonlight: 0 is a night without a moon.", inPicture, essential());
    const Condition moonlit = inPicture and whenAbove(moon, 0);
    Real moonElevation =
        real("moonElevation", degrees(13), degree, Range{degrees(-10), degrees(90)}.soft(0, degrees(60)),
             "Height of the moon above the horizon.", moonlit);
    Real moonAzimuth =
        real("moonAzimuth", degrees(-17), degree, Range{degrees(-180), degrees(180)},
             "Horizontal direction of the moon, seen through the frame: negative is to the left.", moonlit);
    Real moonSize =
        real("moonSize", degrees(2.4), degree, Range{degrees(0.1), degrees(20)}.soft(degrees(0.5), degrees(6)),
             "Angular diameter of the moon; the real one has half a degree.", physical and moonlit);
    File panorama = file("panorama", "Path of a panorama, twice as wide as high, that replaces the night sky.",
                         extensions(render::readEndings()));
    Real stars = real("stars", 0.7, none, Range{0, 10}.soft(0, 2), "Brightness of the stars: 0 shows none.", physical);
    Real dusk = real("dusk", 0.12, none, Range{0, 10}.soft(0, 2),
                     "Strength of the daylight left in the sky: 0 is deep night.", physical);
    Real afterglow =
        real("afterglow", 0.5, none, {0, 1}, "Warmth of the dusk at the horizon: 0 is cool, 1 glows like a sunset.",
             physical and whenAbove(dusk, 0));
    Real fog =
        real("fog", 0.0022, perMeter, Range{0, 1}.soft(0, 0.03),
             "Density of the fog at the water, as the share of light that a meter removes: 0 is clear.", physical);
    Color horizonColor = color("horizonColor", {0.05, 0.06, 0.085}, "Color of the fog at the horizon.",
                               (physical and whenAbove(fog, 0)) or byReference);
    Real fogHeight = real("fogHeight", 6, meter, Range{0.1, 1000, logarithmic}.soft(1, 60),
                          "Height over which the fog thins out.", physical and whenAbove(fog, 0));

    Group accuracy = group("Accuracy");
    Choice<LakeRepetition> repetition =
        choice("repetition", LakeRepetition::cellWall, {"own cell", "2 x 2 cells", "3 x 3 cells", "to the cell's wall"},
               "Cells whose lanterns a step of a ray tests: only its own, 2 x 2 or 3 x 3 cells (lanterns that reach "
               "farther are cut off), or one cell after the other along the ray, which is exact.",
               exactAt(LakeRepetition::cellWall), afloat, essential());
    Count bounces =
        count("bounces", 1, {0, 3}, "Number of times that the water may reflect a ray: 0 shows no reflections.",
              quality(3), physical, essential());
    Count waterSteps =
        count("waterSteps", 20, {1, 256, logarithmic}, "Largest number of steps in which a ray finds the water.",
              quality(256), whenAbove(waveHeight, 0));
    Count rippleCount =
        count("rippleCount", 16, {0, 23},
              "Number of ripples that are summed, from the longest: few are smooth, many add fine ones.", quality(23),
              rippled and whenAbove(ripples, 0));
    Count lightCells = count("lightCells", 4, {0, 9}, "Number of cells around a point whose flames light it.",
                             quality(9), physical and lit);
    Count rows = count(
        "rows", 80, {1, 256, logarithmic},
        "Number of rows of cells in which a ray searches for lanterns; lanterns beyond are drawn as their average.",
        quality(256), afloat);
    Real pointSize = real("pointSize", 5, pixel, Range{0.5, 100, logarithmic}.soft(1, 40),
                          "Width below which a lantern is drawn as a glowing point.", quality(0.5), physical);
    Real meanSize = real("meanSize", 0.7, pixel, Range{0.02, 10, logarithmic}.soft(0.1, 4),
                         "Width below which lanterns are drawn as their average.", quality(0.02), physical and afloat);
    Count stepLimit = count(
        "stepLimit", 96, {1, 512, logarithmic},
        "Largest number of steps of a ray in one lantern; with a fixed number of cells, in all lanterns together.",
        quality(512));
    Real hitTolerance = real("hitTolerance", 0.1, none, Range{0.01, 16, logarithmic}.soft(0.02, 2),
                             "Distance from a part at which a ray takes small even steps until it hits, in pixels at "
                             "that depth: high makes edges uneven.",
                             quality(0.01));

    StudiedParameters studied{
        *this,
        // Excludes lanterns so far away that they are points of light, which the methods by cells leave out.
        {{.name = "repetition", .with = {{"lanterns", 16}, {"pointSize", 0.5}}},
         {.name = "bounces", .settles = "Mirrored rays lead upwards and seldom meet the water again."},
         {.name = "waterSteps", .settles = "Rays find the water in fewer steps."},
         {.name = "rows",
          .lifted = {"meanSize"},
          .settles = "Rays of a small picture meet the water before they have passed this many rows."},
         {.name = "pointSize", .lifted = {"meanSize", "rows"}},
         {.name = "meanSize",
          .lifted = {"rows"},
          .settles = "The rows of lanterns end before lanterns look this narrow."},
         {.name = "stepLimit", .settles = "Rays end before they have taken this many steps."}}};
};

}  // namespace vitrine::paper_lanterns

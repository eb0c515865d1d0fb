#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/studied_rows.h"

namespace vitrine {

enum class LakeShow : int { picture, heights, normals, parts };
enum class LakeLook : int { ours, source };
enum class LakeRelease : int { rises, driftsAway };
enum class LakeRide : int { source, water };
enum class LakeSpeed : int { source, dispersion };
enum class LakeFlicker : int { together, own };
enum class LakeRepetition : int { ownCell, twoByTwo, threeByThree, cellWall };

/// All parameters of the lake of lanterns. Lengths are in meters of the lake's own world, in which a lantern is two
/// meters high, as in the reference.
struct PaperLanternsTable final : Parameters {
    Group view = group("On show");
    Choice<LakeShow> show =
        choice("show", LakeShow::picture, {"picture", "heights", "normals", "parts"},
               "The picture, or what it is made of: the water's height, its normals, or the parts of "
               "the lanterns by color.");
    Choice<LakeLook> look = choice("look", LakeLook::ours, {"ours", "as in the source"},
                                   "How light is reckoned: through translucent paper, with Fresnel's mirror, or as the "
                                   "source does.");
    Toggle animate = toggle("animate", false, "Let time run: waves roll, flames flicker, lanterns drift.");
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 60), "The moment that is shown, or begun with.");
    Real eyeHeight = real("eyeHeight", 4.8, meter, Range{0.5, 200, logarithmic}.soft(1, 30),
                          "Of the frame's middle above the calm water.");
    Real scale = real("scale", 3, none, Range{0.5, 100, logarithmic}.soft(1, 20),
                      "Meters of the lake in a meter of the hall: more makes lanterns smaller.");
    Count seed = count("seed", 1, {0, 9999}, "Another number strews other lanterns and other ripples.");

    const Condition inPicture = when(show, LakeShow::picture);
    const Condition ours = when(look, LakeLook::ours) and inPicture;
    const Condition bySource = when(look, LakeLook::source) and inPicture;
    const Condition rippled = when(look, LakeLook::ours) and when(show, {LakeShow::picture, LakeShow::normals});
    const Condition moving = when(animate) or whenNot(moment, 0);

    Group many = group("Lanterns");
    Count lanterns = count("lanterns", 30000, {1, 1000000, logarithmic},
                           "Cells with room for a lantern, in a square whose corner is at the frame: one, or up to the "
                           "horizon.");
    Real crowding = real("crowding", 0.8, none, {0, 1}, "Share of these cells that have one: at 0 the lake is empty.");
    const Condition afloat = whenAbove(crowding, 0);
    Real spacing = real("spacing", 7.5, meter, Range{1, 100, logarithmic}.soft(4, 20),
                        "Width of a cell; never less than a lantern needs.", afloat);
    Real irregularity = real("irregularity", 1, none, {0, 1},
                             "How far blue noise moves them from the middle of their cells: 0 is a grid.", afloat);
    Real turned = real("turned", 1, none, {0, 1}, "How far they are turned, each by an angle of its own.", afloat);
    Choice<LakeRide> ride = choice("ride", LakeRide::water, {"as in the source", "the water"},
                                   "What they float on: a wave that the water does not have, or the water under their "
                                   "base.",
                                   whenLaterAbove("waveHeight", 0));
    Real drift = real("drift", 0.12, none, Range{0, 20}.soft(0, 1), "Meters a second by which the wind moves them.");
    Choice<LakeRelease> release = choice("release", LakeRelease::rises, {"rises", "drifts away"},
                                         "What the lantern does that the button sets free.");

    Group candle = group("Candles");
    Toggle candles = toggle("candles", true, "Light them.", inPicture);
    const Condition lit = when(candles) and inPicture;
    Real candleStrength = real("candleStrength", 1, none, Range{0, 20}.soft(0, 4), "How bright the flames are.", lit);
    Color candleColor = color("candleColor", {1, 0.4, 0.09}, "Of the flames.", lit);
    Real flameHeight =
        real("flameHeight", 0.55, meter, Range{0.1, 5}.soft(0.2, 1.6), "Of the flame over the base.", lit);
    Real flicker = real("flicker", 1, none, {0, 1}, "How much flames flicker: 0 burns evenly.", lit and afloat);
    Choice<LakeFlicker> flickerPhase =
        choice("flickerPhase", LakeFlicker::own, {"together", "each its own"}, "Whether they flicker in step.",
               lit and whenAbove(flicker, 0) and afloat);
    Real hallGlow = real("hallGlow", 1, none, Range{0, 10}.soft(0, 3),
                         "Light that the frame throws on wall and floor beside it.", lit and afloat);

    Group paper = group("Paper");
    Color paperColor = color("paperColor", {0.97, 0.8, 0.5}, "What the paper does not absorb.", ours);
    Real paperThickness =
        real("paperThickness", 1.6, none, Range{0.05, 20, logarithmic}.soft(0.3, 6),
             "How often light is scattered in it: low is clear and bright, high dim and white.", ours);
    Real fibers = real("fibers", 0.5, none, {0, 1}, "How uneven it is.", inPicture);
    Real colors = real("colors", 0.3, none, {0, 1}, "How far papers differ in color: 0 not at all, 1 is a festival.",
                       ours and afloat);

    Group shape = foldedGroup("Shape");
    Real paperRadius = real("paperRadius", 0.75, meter, Range{0.1, 3}.soft(0.3, 1.2), "Of the paper tube.");
    Real paperHeight = real("paperHeight", 2, meter, Range{0.2, 8}.soft(0.6, 4), "Of its upper edge.");
    Real paperWall = real("paperWall", 0.06, meter, Range{0.005, 0.3}.soft(0.01, 0.15), "Thickness of its wall.");
    Real baseWidth = real("baseWidth", 2.2, meter, Range{0.2, 6}.soft(1, 3), "Side of the wooden base.");
    Real baseThickness = real("baseThickness", 0.08, meter, Range{0.01, 1}.soft(0.02, 0.4), "Of the base.");
    Real ringWire = real("ringWire", 0.05, meter, Range{0.005, 0.3}.soft(0.01, 0.12), "Radius of the rings' wire.");
    Real lowRing = real("lowRing", 0.08, meter, Range{0, 4}.soft(0, 0.8), "Height of the lower ring.");
    Real postWire = real("postWire", 0.05, meter, Range{0.005, 0.3}.soft(0.01, 0.12), "Radius of the posts.");
    Real frameBlend = real("frameBlend", 0.1, meter, Range{0, 0.5}.soft(0, 0.3), "How softly posts and rings join.");

    Group water = group("Water");
    Real waveHeight = real("waveHeight", 0.45, none, Range{0, 8}.soft(0, 3),
                           "Of the five waves over those of the source: 0 is a mirror.");
    Choice<LakeSpeed> waveSpeed = choice(
        "waveSpeed", LakeSpeed::dispersion, {"as in the source", "as gravity makes them"},
        "One rhythm for all waves, or slow long ones and quick short ones.", whenAbove(waveHeight, 0) and moving);
    Real ripples = real("ripples", 0.055, none, Range{0, 0.5}.soft(0, 0.15),
                        "Slope of the small waves that the wind makes: it draws reflections out.", rippled);
    Real windDirection = real("windDirection", degrees(65), degree, Range{degrees(-180), degrees(180)},
                              "Where the wind blows to, from straight ahead: negative is to the left.");
    Color waterColor = color("waterColor", {0.012, 0.03, 0.036}, "What deep water sends back.", inPicture);
    Real exaggeration =
        real("exaggeration", 1, none, Range{0, 20}.soft(0, 8), "Of heights and slopes in the views of them.",
             when(show, {LakeShow::heights, LakeShow::normals}));

    Group sky = group("Moon and sky");
    Real moon = real("moon", 0.5, none, Range{0, 20}.soft(0, 3), "Its light; 0: it has not risen.", inPicture);
    const Condition moonlit = inPicture and whenAbove(moon, 0);
    Real moonElevation =
        real("moonElevation", degrees(13), degree, Range{degrees(-10), degrees(90)}.soft(0, degrees(60)),
             "Its height above the horizon.", moonlit);
    Real moonAzimuth = real("moonAzimuth", degrees(-17), degree, Range{degrees(-180), degrees(180)},
                            "Where it stands, seen through the frame: negative is to the left.", moonlit);
    Real moonSize =
        real("moonSize", degrees(2.4), degree, Range{degrees(0.1), degrees(20)}.soft(degrees(0.5), degrees(6)),
             "Of its disk: the real one has half a degree.", ours and moonlit);
    File panorama = file("panorama", "A picture of all directions, twice as wide as high, in place of the night sky.",
                         endings("hdr exr jpg jpeg png tif tiff webp bmp gif"));
    Real stars = real("stars", 0.7, none, Range{0, 10}.soft(0, 2), "How bright they are.", ours);
    Real dusk = real("dusk", 0.12, none, Range{0, 10}.soft(0, 2), "Light of the day that is left in the sky.", ours);
    Real afterglow = real("afterglow", 0.5, none, {0, 1}, "How warm its horizon is: of the sun that has set, or rises.",
                          ours and whenAbove(dusk, 0));
    Real fog =
        real("fog", 0.0022, perMeter, Range{0, 1}.soft(0, 0.03), "What a meter of the air at the water hides.", ours);
    Color horizonColor = color("horizonColor", {0.05, 0.06, 0.085}, "Of the mist at the horizon.",
                               (ours and whenAbove(fog, 0)) or bySource);
    Real fogHeight = real("fogHeight", 6, meter, Range{0.1, 1000, logarithmic}.soft(1, 60),
                          "Over which the mist thins out.", ours and whenAbove(fog, 0));

    Group accuracy = foldedGroup("Accuracy");
    Choice<LakeRepetition> repetition =
        choice("repetition", LakeRepetition::cellWall, {"own cell", "2 x 2 cells", "3 x 3 cells", "to the cell's wall"},
               "Which lanterns a step of a ray looks at: those of some cells around it, which cuts what lies beyond, "
               "or all that "
               "the ray can touch, cell by cell.",
               exactAt(LakeRepetition::cellWall), afloat);
    Count bounces = count("bounces", 1, {0, 3}, "How often a ray may be mirrored by the water.", quality(3), ours);
    Count waterSteps = count("waterSteps", 20, {1, 256, logarithmic}, "Steps by which a ray finds the water.",
                             quality(256), whenAbove(waveHeight, 0));
    Count rippleCount = count("rippleCount", 16, {0, 23}, "Ripples that are summed, from the longest on.", quality(23),
                              rippled and whenAbove(ripples, 0));
    Count lightCells =
        count("lightCells", 4, {0, 9}, "Cells around a place whose flames light it.", quality(9), ours and lit);
    Count rows = count("rows", 80, {1, 256, logarithmic},
                       "Rows of cells in which a ray looks for lanterns; those beyond are reckoned as their mean.",
                       quality(256), afloat);
    Real pointSize = real("pointSize", 5, pixel, Range{0.5, 100, logarithmic}.soft(1, 40),
                          "A lantern whose paper looks narrower than this is a glowing point.", quality(0.5), ours);
    Real meanSize =
        real("meanSize", 0.7, pixel, Range{0.02, 10, logarithmic}.soft(0.1, 4),
             "Lanterns that look narrower than this are reckoned as their mean.", quality(0.02), ours and afloat);
    Count stepLimit = count("stepLimit", 96, {1, 512, logarithmic},
                            "Steps a ray may take in one lantern, or, by cells "
                            "around it, in all.",
                            quality(512));
    Real hitTolerance =
        real("hitTolerance", 0.1, none, Range{0.01, 16, logarithmic}.soft(0.02, 2),
             "How near a part rays go on by small even steps until they touch, in pixels at that distance: more "
             "makes edges uneven.",
             quality(0.01));

    StudiedRows studied{
        *this,
        // Excludes lanterns so far away that they are points of light, which the methods by cells leave out.
        {{.name = "repetition", .with = {{"lanterns", 16}, {"pointSize", 0.5}}},
         {.name = "bounces", .settles = "Mirrored rays lead upwards and seldom meet the water again."},
         {.name = "waterSteps", .settles = "Rays have found the water in fewer steps."},
         {.name = "rows", .lifted = {"meanSize"}},
         {.name = "pointSize", .lifted = {"meanSize", "rows"}},
         {.name = "meanSize", .lifted = {"rows"}, .settles = "The rows end before lanterns look so narrow."},
         {.name = "stepLimit", .settles = "Rays end before they have taken so many steps."}}};
};

}  // namespace vitrine

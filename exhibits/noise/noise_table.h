#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/studied_rows.h"

namespace vitrine {

enum class NoiseWork : int { field, fractal, sea, clouds };
enum class NoiseLook : int { ours, source };
enum class NoiseKind : int { value, gradient, simplex, cellular };
enum class NoiseSumKind : int { fbm, ridged, billow, turbulence };
enum class NoiseMarch : int { halved, bounded };
enum class NoiseNormal : int { differences, derivative };
enum class NoiseSun : int { own, hall };
enum class NoiseLookup : int { evaluated, baked };

/// All parameters of the works behind the noise frame. Lengths are in meters of the work's own world.
struct NoiseTable final : Parameters {
    Group show = group("On show");
    Choice<NoiseWork> work =
        choice("work", NoiseWork::sea, {"field", "fractal sum", "sea", "clouds"},
               "Blobs of one octave, the same of many, waves, or a sky of clouds: all made of noise.");
    Choice<NoiseLook> look = choice("look", NoiseLook::ours, {"ours", "as in the source"},
                                    "Our way to draw the work, or that of the scenes that this exhibit follows.");
    Toggle animate = toggle("animate", false, "Let time run: the field drifts, waves roll, clouds sail.");
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 60), "The moment that is shown, or begun with.");
    Count seed = count("seed", 1, {0, 9999}, "Another number is another field, another sea, another sky.");

    const Condition inField = when(work, {NoiseWork::field, NoiseWork::fractal});
    const Condition inFractal = when(work, NoiseWork::fractal);
    const Condition inSea = when(work, NoiseWork::sea);
    const Condition inClouds = when(work, NoiseWork::clouds);
    const Condition ours = when(look, NoiseLook::ours);
    const Condition moving = when(animate) or whenNot(moment, 0);

    Group noise = group("Noise");
    Choice<NoiseKind> kind =
        choice("kind", NoiseKind::gradient, {"value", "gradient", "simplex", "cellular"},
               "What an octave is: numbers at the corners of cells, slopes there, slopes on a lattice without axes, or "
               "the distance to the nearest of scattered points.",
               inField);
    Real frequency = real("frequency", 0.9, perMeter, Range{0.01, 100, logarithmic}.soft(0.1, 10),
                          "Cells of the first octave in a meter.", inField);
    Real threshold = real("threshold", 0.12, none, Range{-1, 1}.soft(-0.4, 0.6),
                          "Noise above this is solid: low fills space, high leaves islands.", inField);
    Real drift = real("drift", 0.25, none, Range{-1000, 1000}.soft(-3, 3),
                      "Meters a second by which the field comes towards you.", inField and moving);
    Real distance = real("distance", 0, meter, Range{-1e7, 1e7}.soft(0, 1000),
                         "How far from the origin of the noise the picture is: ten thousand kilometers off, it is as "
                         "sharp as at home.",
                         inField);

    Group sums = group("Octaves");
    Choice<NoiseSumKind> sum =
        choice("sum", NoiseSumKind::fbm, {"plain", "ridged", "billow", "turbulence"},
               "What is made of each octave: itself, sharp ridges, round lumps, or its absolute value.", inFractal);
    Count octaves =
        count("octaves", 5, {1, 10}, "How many octaves are summed: each has finer grain.", quality(10), inFractal);
    Real gain = real("gain", 0.5, none, Range{0, 1}.soft(0.2, 0.8),
                     "Strength of an octave over that of the one before: low is smooth, high is rough.", inFractal);
    Real lacunarity = real("lacunarity", 2.02, none, Range{1, 8}.soft(1.5, 4),
                           "Frequency of an octave over that of the one before.", inFractal);
    Real octaveRotation =
        real("octaveRotation", degrees(37), degree, Range{degrees(-180), degrees(180)},
             "By which each octave's lattice is turned, so that no two lie along each other.", inFractal);
    Real warp = real("warp", 0, none, Range{0, 4}.soft(0, 1),
                     "How many cells a further noise moves the first ones by: 0 leaves them, high folds and swirls.",
                     inFractal and ours);

    Group light = group("Light");
    Choice<NoiseSun> sunBy = choice("sunBy", NoiseSun::own, {"its own", "the hall's"},
                                    "Whether the work has a sun of its own or the direction of the hall's.", ours);
    Real sunElevation = real("sunElevation", degrees(9), degree, Range{degrees(-5), degrees(90)}.soft(0, degrees(70)),
                             "Height of its own sun above the horizon.", ours and when(sunBy, NoiseSun::own));
    Real sunAzimuth = real("sunAzimuth", degrees(14), degree, Range{degrees(-180), degrees(180)},
                           "Where its own sun stands, seen through the frame: negative is to the left.",
                           ours and when(sunBy, NoiseSun::own));
    Real haze = real("haze", 0.35, none, {0, 1}, "Of the air: 0 is clear to the horizon, 1 hides it.", ours);
    Color albedo = color("albedo", {0.62, 0.56, 0.48}, "Of the solid field.", inField and ours);

    Group sea = group("Sea and wind");
    Real windSpeed = real("windSpeed", 7.5, none, Range{0.5, 25}.soft(2, 16),
                          "Meters a second, ten meters above the water: more makes longer and higher waves.",
                          ours and (inSea or (inClouds and moving)));
    Real windDirection = real("windDirection", degrees(-150), degree, Range{degrees(-180), degrees(180)},
                              "Where the wind blows to, from straight ahead: negative is to the left.",
                              ours and (inSea or (inClouds and moving)));
    Real chop =
        real("chop", 0.85, none, Range{0, 1.2}.soft(0, 1),
             "How much crests are drawn together: 0 is a plain sum of sines, 1 a sea, more breaks.", inSea and ours);
    Real foam = real("foam", 0.5, none, {0, 1}, "How soon crests break into foam; 0 never.", inSea and ours);
    Color water = color("water", {0.016, 0.075, 0.085}, "What deep water sends back of the daylight.", inSea and ours);
    Real eyeHeight = real("eyeHeight", 2.6, meter, Range{1, 1000, logarithmic}.soft(1.5, 50),
                          "Of the frame's middle above the calm water.", inSea and ours);

    Group clouds = group("Clouds");
    Real coverage = real("coverage", 0.72, none, {0, 1}, "How much of the sky the clouds fill.", inClouds and ours);
    Real density = real("density", 0.03, perMeter, Range{0.001, 1, logarithmic}.soft(0.005, 0.2),
                        "What a meter of the thickest cloud takes out of a ray.", inClouds and ours);
    Real erosion =
        real("erosion", 0.65, none, {0, 1}, "How much fine noise takes away from their edges.", inClouds and ours);
    Real altitude = real("altitude", -120, meter, Range{-2000, 4000}.soft(-600, 1500),
                         "Of the frame's middle over the base of the clouds: between 0 and 1400 it is among them.",
                         inClouds and ours);
    Real tilt = real("tilt", degrees(13), degree, {degrees(-45), degrees(45)}, "How far up the frame looks.",
                     inClouds and ours);
    Real forward =
        real("forward", 0.78, none, Range{0, 0.95}.soft(0.3, 0.9),
             "How strongly droplets scatter ahead: high gives silver edges before the sun.", inClouds and ours);
    Real backward = real("backward", 0.3, none, {0, 1},
                         "Share of the light that they scatter in the second lobe, back.", inClouds and ours);
    Count scatterings =
        count("scatterings", 6, {1, 8}, "Orders of scattering that are summed: 1 is dark within, each more is whiter.",
              quality(8), inClouds and ours);

    Group accuracy = foldedGroup("Accuracy");
    Choice<NoiseMarch> march = choice(
        "march", NoiseMarch::bounded, {"as in the source", "bounded"},
        "How rays find what they show: by steps of half the field's value, of the height above the water, of one "
        "length through clouds, or by as much as bounds of the slope allow, with clear air passed quickly.",
        quality(NoiseMarch::bounded), ours);
    Real boundShare =
        real("boundShare", 0.45, none, {0.1, 1},
             "Share of the bounds of slope and curvature that strides go by, proven ones of the field, five and a half "
             "standard deviations of the sea: 1 passes nothing wide, less is quicker, for noise is seldom as steep.",
             exactAt(1), (inField or inSea) and ours and when(march, NoiseMarch::bounded));
    Count stepLimit = count("stepLimit", 160, {1, 1024, logarithmic},
                            "Steps a ray may take to find the field, or the sea of the source.", quality(1024),
                            inField or (inSea and when(look, NoiseLook::source)));
    Real hitTolerance = real("hitTolerance", 0.5, none, Range{0.01, 16, logarithmic}.soft(0.1, 4),
                             "How near a ray must come to the field or the water, in pixels at that distance.",
                             quality(0.01), (inField or inSea) and ours);
    Choice<NoiseLookup> fieldNoise =
        choice("fieldNoise", NoiseLookup::baked, {"evaluated", "baked"},
               "Whether empty space is crossed, and light told, by evaluated noise or by noise that is looked up: the "
               "surface itself is always evaluated.",
               exactAt(NoiseLookup::evaluated), inField and ours and when(march, NoiseMarch::bounded));
    Choice<NoiseNormal> normals = choice("normals", NoiseNormal::derivative, {"differences", "derivative"},
                                         "The field's normal: by six further evaluations, or by its derivative.",
                                         exactAt(NoiseNormal::derivative), inField and ours);
    Count waves =
        count("waves", 48, {1, 64}, "Waves that are summed, from the longest on.", quality(64), inSea and ours);
    Count seaSteps = count("seaSteps", 40, {1, 256, logarithmic}, "Steps by which a ray finds the water.", quality(256),
                           inSea and ours);
    Count cloudSteps =
        count("cloudSteps", 64, {1, 512, logarithmic}, "Steps of a ray through the clouds.", quality(512), inClouds);
    Count lightSteps =
        count("lightSteps", 5, {1, 64, logarithmic}, "Steps from there towards the sun.", quality(64), inClouds);
    Count cloudOctaves =
        count("cloudOctaves", 3, {1, 6}, "Octaves of the clouds' noise: more is finer.", quality(6), inClouds and ours);
    Choice<NoiseLookup> cloudNoise = choice("cloudNoise", NoiseLookup::baked, {"evaluated", "baked"},
                                            "Whether the clouds' noise is evaluated at every step or looked up.",
                                            exactAt(NoiseLookup::evaluated), inClouds and ours);
    Count bakeSize =
        count("bakeSize", 96, {16, 256, logarithmic}, "Texels along each side of the volume it is baked to.",
              quality(256), inClouds and ours and when(cloudNoise, NoiseLookup::baked));
    Toggle jitter = toggle("jitter", true,
                           "Shift the steps by blue noise, another at every supersample, so that few of them look like "
                           "grain and not like shells.",
                           quality(1), inClouds and ours);

    StudiedRows studied{*this,
                        {{.name = "march", .lifted = {"boundShare"}},
                         {.name = "stepLimit", .settles = "Rays end before they have taken so many steps."},
                         {.name = "hitTolerance", .lifted = {"stepLimit", "seaSteps"}},
                         {.name = "seaSteps", .settles = "Rays have found the water in fewer steps."},
                         {.name = "jitter", .exactInReference = {"cloudSteps"}}}};
};

}  // namespace vitrine

#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"

namespace vitrine::noise {

enum class NoiseWork : int { field, fractal, sea, clouds };
enum class NoiseLook : int { physical, reference };
enum class NoiseKind : int { value, gradient, simplex, cellular };
enum class NoiseSumKind : int { fbm, ridged, billow, turbulence };
enum class NoiseMarch : int { halved, bounded };
enum class NoiseNormal : int { differences, derivative };
enum class NoiseSun : int { own, hall, ownByDay };
enum class NoiseLookup : int { evaluated, baked };

/// All parameters of the works behind the noise frame. Lengths are in meters of the work's own world.
struct NoiseTable final : Parameters {
    Group show = group("Display");
    Choice<NoiseWork> work = choice("work", NoiseWork::sea, {"field", "fractal sum", "sea", "clouds"},
                                    "Work to show: blobs of one octave (field), of many octaves (fractal sum), a sea "
                                    "of waves, or a sky of clouds, all made of noise.",
                                    essential());
    Choice<NoiseLook> look =
        choice("look", NoiseLook::physical, {"physically based", "reference"},
               "Shading of the work: physically based, or by the simpler formulas of the reference.");
    Toggle animate =
        toggle("animate", false, "Whether time runs: the field drifts, waves roll, clouds sail.", essential());
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 60),
                       "Time that is shown, or at which the animation starts.");
    Count seed =
        count("seed", 1, {0, 9999}, "Seed of the noise: each number gives another field, sea and sky.", essential());

    const Condition inField = when(work, {NoiseWork::field, NoiseWork::fractal});
    const Condition inFractal = when(work, NoiseWork::fractal);
    const Condition inSea = when(work, NoiseWork::sea);
    const Condition inClouds = when(work, NoiseWork::clouds);
    const Condition physical = when(look, NoiseLook::physical);
    const Condition moving = when(animate) or whenNot(moment, 0);

    Group noise = group("Noise");
    Choice<NoiseKind> kind = choice("kind", NoiseKind::gradient, {"value", "gradient", "simplex", "cellular"},
                                    "Kind of noise: values at the cell corners, gradients there, gradients on a "
                                    "simplex lattice, or the distance to the nearest of scattered points (cellular).",
                                    inField);
    Real frequency =
        real("frequency", 0.9, perMeter, Range{0.01, 100, logarithmic}.soft(0.1, 10),
             "Frequency of the first octave, in cells per meter: low makes large blobs, high small ones.", inField);
    Real threshold = real("threshold", 0.12, none, Range{-1, 1}.soft(-0.4, 0.6),
                          "Noise value above which space is solid: low fills space, high leaves islands.", inField);
    Real drift = real("drift", 0.25, none, Range{-1000, 1000}.soft(-3, 3),
                      "Speed at which the field moves towards the viewer, in meters per second.", inField and moving);
    Real distance = real(
        "distance", 0, meter, Range{-1e7, 1e7}.soft(0, 1000),
        "Distance of the view from the origin of the noise: the picture stays sharp even ten thousand kilometers away.",
        inField);

    Group sums = group("Octaves");
    Choice<NoiseSumKind> sum = choice("sum", NoiseSumKind::fbm, {"plain", "ridged", "billow", "turbulence"},
                                      "Shape of each octave before it is added: plain noise, sharp ridges, round lumps "
                                      "(billow), or its absolute value (turbulence).",
                                      inFractal);
    Count octaves = count("octaves", 5, {1, 10}, "Number of octaves that are summed: each adds finer detail.",
                          quality(10), inFractal);
    Real gain = real("gain", 0.5, none, Range{0, 1}.soft(0.2, 0.8),
                     "Strength of an octave relative to the one before: low is smooth, high is rough.", inFractal);
    Real lacunarity = real("lacunarity", 2.02, none, Range{1, 8}.soft(1.5, 4),
                           "Frequency of an octave relative to the one before: 2 doubles it.", inFractal);
    Real octaveRotation = real(
        "octaveRotation", degrees(37), degree, Range{degrees(-180), degrees(180)},
        "Angle by which the lattice of each octave is rotated against the one before; 0 shows the lattice.", inFractal);
    Real warp = real("warp", 0, none, Range{0, 4}.soft(0, 1),
                     "Strength of domain warping, in cells: 0 is off, high folds and swirls.", inFractal and physical);

    Group light = group("Light");
    Choice<NoiseSun> sunBy =
        choice("sunBy", NoiseSun::ownByDay, {"its own", "the hall's", "its own by day"},
               "Source of the sun's direction: angles of the work's own, the hall's sun, or angles of its own by day, "
               "until the hall's sun sets. A moon then stands at these angles.",
               physical);
    const Condition ownAngles = when(sunBy, {NoiseSun::own, NoiseSun::ownByDay});
    Real sunElevation = real("sunElevation", degrees(9), degree, Range{degrees(-5), degrees(90)}.soft(0, degrees(70)),
                             "Height of the work's own sun above the horizon.", physical and ownAngles, essential());
    Real sunAzimuth =
        real("sunAzimuth", degrees(14), degree, Range{degrees(-180), degrees(180)},
             "Horizontal direction of the work's own sun, seen through the frame: negative is to the left.",
             physical and ownAngles);
    Real haze =
        real("haze", 0.35, none, {0, 1}, "Density of the haze: 0 is clear to the horizon, 1 hides it.", physical);
    Real brightness = real("brightness", 1, none, Range{0.01, 100, logarithmic}.soft(0.1, 10),
                           "Brightness of the whole picture, as a factor: 1 leaves it as it is.", physical);
    Color albedo =
        color("albedo", {0.62, 0.56, 0.48}, "Albedo (diffuse color) of the solid field.", inField and physical);

    Group sea = group("Sea and wind");
    Real windSpeed =
        real("windSpeed", 7.5, none, Range{0.5, 25}.soft(2, 16),
             "Wind speed ten meters above the water, in meters per second: high makes longer and higher waves.",
             physical and (inSea or (inClouds and moving)), essential());
    Real windDirection = real("windDirection", degrees(-150), degree, Range{degrees(-180), degrees(180)},
                              "Direction in which the wind blows, from straight ahead: negative is to the left.",
                              physical and (inSea or (inClouds and moving)));
    Real chop = real(
        "chop", 0.85, none, Range{0, 1.2}.soft(0, 1),
        "Sharpness of the wave crests: 0 is a plain sum of sines, 1 looks like a natural sea, above 1 crests overturn.",
        inSea and physical);
    Real foam = real("foam", 0.5, none, {0, 1}, "Amount of foam on the crests: 0 is none, high foams early.",
                     inSea and physical);
    Color water = color("water", {0.016, 0.075, 0.085}, "Color of deep water in daylight.", inSea and physical);
    Real eyeHeight = real("eyeHeight", 2.6, meter, Range{1, 1000, logarithmic}.soft(1.5, 50),
                          "Height of the middle of the frame above the calm water.", inSea and physical);

    Group clouds = group("Clouds");
    Real coverage = real("coverage", 0.72, none, {0, 1},
                         "Share of the sky that clouds cover: 0 is clear, 1 is overcast.", inClouds and physical);
    Real density = real("density", 0.03, perMeter, Range{0.001, 1, logarithmic}.soft(0.005, 0.2),
                        "Density of the clouds, as the share of light that a meter of the thickest cloud removes.",
                        inClouds and physical);
    Real erosion = real("erosion", 0.65, none, {0, 1},
                        "Amount by which fine noise erodes the edges of the clouds: 0 is smooth, 1 is ragged.",
                        inClouds and physical);
    Real altitude =
        real("altitude", -120, meter, Range{-2000, 4000}.soft(-600, 1500),
             "Height of the middle of the frame above the base of the clouds: between 0 and 1400 m it is inside them.",
             inClouds and physical);
    Real tilt = real("tilt", degrees(13), degree, {degrees(-45), degrees(45)},
                     "Upward tilt of the view: negative looks down.", inClouds and physical);
    Real forward = real("forward", 0.78, none, Range{0, 0.95}.soft(0.3, 0.9),
                        "Strength of forward scattering in the clouds: high gives silver edges in front of the sun.",
                        inClouds and physical);
    Real backward = real("backward", 0.3, none, {0, 1},
                         "Share of the light that the clouds scatter backward, in a second lobe of the phase function.",
                         inClouds and physical);
    Real powder = real("powder", 0.6, none, {0, 1},
                       "Strength of the dark edges of billows that are seen with the sun behind the eye: 0 is none.",
                       inClouds and physical);
    Count scatterings = count("scatterings", 6, {1, 8},
                              "Number of orders of scattering that are summed (how often light is scattered on its "
                              "way): 1 leaves clouds dark inside, each further one makes them whiter.",
                              quality(8), inClouds and physical);

    Group accuracy = group("Accuracy");
    Choice<NoiseMarch> march =
        choice("march", NoiseMarch::bounded, {"reference", "bounded"},
               "Step lengths of the rays: as in the reference (half the field's value, the height above the water, "
               "equal steps through clouds), or as far as bounds of the slope allow.",
               quality(NoiseMarch::bounded), physical, essential());
    Real boundShare = real("boundShare", 0.45, none, {0.1, 1},
                           "Share of the slope and curvature bounds that sets the step length: 1 misses nothing, less "
                           "is quicker but may miss details.",
                           exactAt(1), (inField or inSea) and physical and when(march, NoiseMarch::bounded));
    Count stepLimit = count("stepLimit", 160, {1, 1024, logarithmic},
                            "Largest number of steps of a ray that searches for the field, or for the sea if its march "
                            "is that of the reference.",
                            quality(1024), inField or (inSea and when(look, NoiseLook::reference)));
    Real hitTolerance =
        real("hitTolerance", 0.5, none, Range{0.01, 16, logarithmic}.soft(0.1, 4),
             "Distance at which a ray counts as a hit of the field or the water, in pixels at that depth.",
             quality(0.01), (inField or inSea) and physical);
    Choice<NoiseLookup> fieldNoise =
        choice("fieldNoise", NoiseLookup::baked, {"evaluated", "baked"},
               "Source of the noise for empty space and shadows: evaluated, or baked into a texture. Which of them is "
               "quicker depends on the graphics card. The surface is always evaluated.",
               exactAt(NoiseLookup::evaluated), inField and physical and when(march, NoiseMarch::bounded));
    Choice<NoiseNormal> normals =
        choice("normals", NoiseNormal::derivative, {"differences", "derivative"},
               "Normals of the field: by six further evaluations (differences), or by the analytic derivative.",
               exactAt(NoiseNormal::derivative), inField and physical);
    Count waves = count("waves", 48, {1, 64},
                        "Number of waves that are summed, from the longest: few are smooth, many add small waves.",
                        quality(64), inSea and physical);
    Count seaSteps = count("seaSteps", 40, {1, 256, logarithmic},
                           "Largest number of steps in which a ray finds the water.", quality(256), inSea and physical);
    Count cloudSteps =
        count("cloudSteps", 64, {1, 512, logarithmic},
              "Number of steps of a ray through the clouds: few are noisy, many cost more.", quality(512), inClouds);
    Count lightSteps = count("lightSteps", 10, {1, 64, logarithmic},
                             "Number of steps towards the sun from each point in a cloud.", quality(64), inClouds);
    Count cloudOctaves =
        count("cloudOctaves", 3, {1, 6}, "Number of octaves of the clouds' noise: each adds finer detail.", quality(6),
              inClouds and physical);
    Choice<NoiseLookup> cloudNoise =
        choice("cloudNoise", NoiseLookup::baked, {"evaluated", "baked"},
               "Source of the clouds' noise: evaluated at every step, or baked into a texture, which is quicker.",
               exactAt(NoiseLookup::evaluated), inClouds and physical);
    Count bakeSize = count("bakeSize", 96, {16, 256, logarithmic},
                           "Resolution of the volume into which noise is baked, in texels per side: low loses detail.",
                           quality(256), inClouds and physical and when(cloudNoise, NoiseLookup::baked));
    Toggle jitter = toggle("jitter", true,
                           "Whether the steps are shifted by blue noise, differently in each sample: too few of them "
                           "then look like grain, not like shells.",
                           quality(1), inClouds and physical);

    Real cloudTolerance =
        real("cloudTolerance", 0.08, none, Range{0, 1}.soft(0, 0.2),
             "Largest difference between neighboring pixels of a picture of half the size up to which the clouds "
             "between them are interpolated, as a share of white: 0 marches a ray through every pixel.",
             exactAt(0), inClouds and physical and when(march, NoiseMarch::bounded));

    StudiedParameters studied{*this,
                              {{.name = "march", .lifted = {"boundShare"}, .exactInReference = {"cloudTolerance"}},
                               {.name = "stepLimit", .settles = "Rays end before they have taken this many steps."},
                               {.name = "hitTolerance", .lifted = {"stepLimit", "seaSteps"}},
                               {.name = "seaSteps", .settles = "Rays find the water in fewer steps."},
                               {.name = "jitter", .exactInReference = {"cloudSteps"}}}};
};

}  // namespace vitrine::noise

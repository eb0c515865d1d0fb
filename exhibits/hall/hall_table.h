#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"
#include "render/image/picture_formats.h"

#include <array>
#include <vector>

namespace vitrine::hall {

enum class SunBy : int { angles, hour };
enum class ShadowFilter : int { hard, tent3, tent5, disk };
enum class FloorMirror : int { probe, shapes, screen };
enum class LampsLit : int { automatic, on, off };
enum class ToneCurve : int { vitrine, agx, aces, neutral, none };
enum class HallHeatMap : int { none, overdraw };

/// Base of an object of the user.
enum class ObjectStand : int { freePlinth, ownPlinth, floor };

/// Largest number of the user's objects in the hall.
inline constexpr std::size_t mostOwnObjects = 4;

/// Parameters of one object of the user.
struct OwnObjectParameters {
    File model;
    Real modelSize, modelRotation;
    Choice<ObjectStand> modelStand;
    Real modelAcross, modelAlong, modelPlinthHeight;
};

/// Title of the hall; defined here, so lists need not read the building itself.
inline constexpr std::string_view hallTitle = "The hall";
inline constexpr std::string_view hallSummary =
    "The museum itself: its sun, its sky, its reflections and the exposure of the picture.";

/// Parameters of the building: light, reflections and tone mapping.
struct HallTable final : Parameters {
    Group picture = group("Picture");
    Real exposure = real("exposure", 0.0, stop, Range{-16, 16}.soft(-4, 4),
                         "Brightness of the whole picture: each stop doubles it.", essential());
    Choice<ToneCurve> toneCurve =
        choice("toneCurve", ToneCurve::vitrine, {"Vitrine", "AgX", "ACES", "Khronos neutral", "none"},
               "Curve from light to the screen: Vitrine has deep shadows and keeps hues, AgX is softer and paler, ACES "
               "turns bright orange yellow, Khronos neutral keeps the colors of surfaces, and none cuts off at white.");
    Real glare = real("glare", 2.0, none, Range{0, 6}.soft(0, 4),
                      "Strength of the halos around light that is brighter than the screen's white: 0 gives none, 1 is "
                      "that of a healthy eye, and high that of a hazy lens.");
    Count glareLevels = count("glareLevels", 8, {1, 10},
                              "Number of widths from which halos are composed, each twice as wide as the one before: "
                              "few keep halos narrow, many let them reach across the picture.",
                              quality(10), whenAbove(glare, 0));

    Count supersamples = count(
        "supersamples", 16, Range{1, 1024, logarithmic}.soft(1, 64),
        "Number of samples per pixel to which an idle picture is refined: few leave jagged edges, many take longer.",
        quality(64));
    Real resolutionScale =
        real("resolutionScale", 1.0, none, {0.25, 1},
             "Resolution of the drawn picture relative to the window, per side: below 1 is quicker and blurred.",
             exactAt(1));
    Toggle temporalAntialiasing = toggle("temporalAntialiasing", true,
                                         "Whether frames in motion are averaged with motion compensation (TAA); "
                                         "without it, edges crawl and fine details flicker until the picture is idle.",
                                         quality(1));
    // Measured at 640 x 360: with 8 frames, at most 0.43 % of the pixels flicker by more than 16 of 255 levels. The
    // error against 64 samples is also the smallest; 16 and 32 frames blur.
    Count historyFrames =
        count("historyFrames", 8, Range{1, 64, logarithmic}.soft(1, 32),
              "Number of frames averaged while the picture moves: few flicker, many blur fine details.", quality(64),
              when(temporalAntialiasing));
    Choice<HallHeatMap> heatMap =
        choice("heatMap", HallHeatMap::none, {"none", "overdraw"},
               "Quantity by which the whole picture is colored: overdraw is the number of fragments of surfaces that "
               "are shaded in each pixel. Ray-marched objects, fur and blended surfaces are not counted.");
    Real heatScale = real("heatScale", 8, none, Range{1, 256, logarithmic}.soft(2, 32),
                          "Number of fragments that the heat map shows in white: low brings out small numbers.",
                          when(heatMap, HallHeatMap::overdraw));

    Group sun = group("Sun");
    Choice<SunBy> sunBy = choice(
        "sunBy", SunBy::angles, {"angles", "time of day"},
        "Way to set the sun: by its angles and color, or by the time of day, with which it moves, reddens and sets.",
        labeled("Set sun by"));
    Real timeOfDay = real(
        "timeOfDay", 16.1, hour, Range{0, 24}.soft(6, 18.5),
        "Hour of a day at the equinox: sunlight comes through the window from three o'clock, and the sun sets at six.",
        when(sunBy, SunBy::hour));
    Real sunElevation =
        real("sunElevation", degrees(20), degree, Range{degrees(2), degrees(88)}.soft(degrees(8), degrees(50)),
             "Height of the sun above the horizon: low reaches far into the hall, high lights the window's foot.",
             when(sunBy, SunBy::angles), essential());
    Real sunAzimuth =
        real("sunAzimuth", degrees(13), degree, Range{degrees(-180), degrees(180)}.soft(degrees(-45), degrees(45)),
             "Horizontal direction of the sun, seen through the window: negative is to the left.",
             when(sunBy, SunBy::angles));
    Real sunStrength = real("sunStrength", 4.6, none, Range{0, 1000}.soft(0, 30),
                            "Strength of the sunlight relative to the sky: 0 is an overcast day.", essential());
    Real sunTemperature = real("sunTemperature", 3900, kelvin, Range{1000, 20000}.soft(2000, 8000),
                               "Color temperature of the sunlight: low is the red of evening, high is bluish.",
                               when(sunBy, SunBy::angles) && whenAbove(sunStrength, 0));
    Toggle sunShadows = toggle(
        "sunShadows", true, "Whether walls and exhibits block the sun; without it, the sun shines through everything.");
    // Measured at 160 x 90: the error is 0.027 with the disk and 0.070 with the tent of 5 x 5. The disk takes 19 ms of
    // a frame, the tent 5.6 ms.
    Choice<ShadowFilter> shadowFilter =
        choice("shadowFilter", ShadowFilter::tent5, {"hard", "tent 3x3", "tent 5x5", "sun's disk"},
               "Filter of the shadow edges: hard, a fixed number of texels (tent), or as wide as the sun's disk makes "
               "them at that distance.",
               quality(ShadowFilter::disk), when(sunShadows), essential());
    Real sunDisk = real(
        "sunDisk", degrees(0.53), degree, Range{degrees(0.005), degrees(12)}.soft(degrees(0.1), degrees(1.7)),
        "Angular diameter of the sun for the disk filter: large softens shadows. The real sun has about half a degree.",
        when(shadowFilter, ShadowFilter::disk));
    Count diskSamples =
        count("diskSamples", 24, {1, 256, logarithmic},
              "Number of shadow-map comparisons over the sun's disk in a half-shadow: few are noisy, many cost more.",
              quality(256), when(shadowFilter, ShadowFilter::disk));
    Count shadowMapSize =
        count("shadowMapSize", 2048, {256, 8192, logarithmic},
              "Resolution of the sun's shadow map, in texels per side: low gives coarse shadow edges.", quality(8192),
              when(sunShadows));

    Group sky = group("Sky");
    Real skyStrength = real("skyStrength", 2.3, none, Range{0, 1000}.soft(0, 4),
                            "Strength of the sky's light through window and oculus: 0 is a black sky.", essential());
    Real skyTemperature = real("skyTemperature", 9500, kelvin, Range{1000, 25000}.soft(5000, 20000),
                               "Color temperature of the sky's light: high is bluer.", whenAbove(skyStrength, 0));
    Toggle bakedLight =
        toggle("bakedLight", true,
               "Whether baked sky light and occlusion light the walls; without it, they get one even ambient light.",
               quality(1));
    Toggle contactShadows = toggle("contactShadows", true,
                                   "Whether the floor is darkened around the things that stand on it; without it, feet "
                                   "and plinths seem to float.");
    File environment =
        file("environment",
             "Path of a panorama that replaces the sky: HDR, EXR, or an ordinary picture twice as wide as high.",
             extensions(render::readEndings()));
    Real environmentRotation =
        real("environmentRotation", 0.0, degree, {degrees(-180), degrees(180)},
             "Rotation of the panorama about the vertical axis.", whenGiven(environment), labeled("Rotation"));

    Group vaultLamps = group("Lamps");
    Choice<LampsLit> lamps = choice("lamps", LampsLit::automatic, {"automatic", "on", "off"},
                                    "When the lamps in the vault are lit: automatically while the sun is lower than "
                                    "eight degrees, always, or never.");
    Real spotStrength =
        real("spotStrength", 1.0, none, Range{0, 1000}.soft(0, 4),
             "Strength of the spotlights on the exhibits: 0 leaves the even light of the vault, high makes pools of "
             "light. Those above frames shine all day, the others with the lamps.",
             when(lamps, {LampsLit::on, LampsLit::automatic}));
    Real lampStrength =
        real("lampStrength", 1.0, none, Range{0, 1000}.soft(0, 6),
             "Strength of the lamps in the vault: 0 leaves the spotlights alone, 1 is a dim background, 5 lights "
             "the whole hall evenly.",
             when(lamps, {LampsLit::on, LampsLit::automatic}));
    Real lampTemperature =
        real("lampTemperature", 4300, kelvin, Range{1000, 20000}.soft(1800, 6500),
             "Color temperature of the lamps: low is candlelight, high is bluish.", whenAbove(lampStrength, 0));

    Group reflections = group("Reflections");
    Toggle reflectionProbe = toggle(
        "reflectionProbe", true,
        "Whether the hall is captured once as a reflection probe for everything in it; without it, nothing reflects.");
    Count probeSize =
        count("probeSize", 256, {16, 1024, logarithmic},
              "Resolution of the reflection probe, in texels per side of a face: low blurs polished surfaces.",
              quality(1024), when(reflectionProbe));
    Count probeSamples = count(
        "probeSamples", 24, {1, 1024, logarithmic},
        "Number of samples per texel with which the reflection probe is blurred for rough surfaces: few are noisy.",
        quality(1024), when(reflectionProbe));

    Choice<FloorMirror> floorMirror =
        choice("floorMirror", FloorMirror::shapes, {"probe", "shapes", "screen"},
               "Reflections of the polished floor: the soft reflection probe alone, or with ray-traced shapes of the "
               "window, its bars and everything on the floor; screen: with everything that the picture shows, found in "
               "screen space, and with those shapes where the picture does not show it.",
               quality(FloorMirror::shapes), when(reflectionProbe), essential());

    // Penumbrae are visible on the floor.
    StudiedParameters studied{*this,
                              {{.name = "diskSamples", .views = {"along the floor", "best view"}},
                               {.name = "glareLevels", .settles = "The picture is too small for wider halos."}}};

    /// The first is on the free plinth; its parameters have no prefix: model, modelSize, ... The others are where their
    /// parameters say: secondModel, secondModelSize, ...
    std::vector<OwnObjectParameters> objects =
        groups("objects", objectElements, [this](std::size_t which) { return object(which); });

private:
    static constexpr std::array<Element, mostOwnObjects> objectElements{{{"", "Visitor's object"},
                                                                         {"second", "Second object"},
                                                                         {"third", "Third object"},
                                                                         {"fourth", "Fourth object"}}};
    /// Initial position of each object beside the free plinth, x and z: it hides nothing and obstructs nobody.
    static constexpr std::array<glm::dvec2, mostOwnObjects> objectSpots{
        {{4.8, -3.5}, {-4.9, -3.5}, {4.7, -0.5}, {-4.7, -10.2}}};

    OwnObjectParameters object(std::size_t which)
    {
        const bool first = which == 0;
        const File model =
            file("model",
                 first ? "Path of a glTF object (.glb or .gltf) to show, at first on the free plinth."
                       : "Path of one more glTF object (.glb or .gltf) to show, at first on a plinth of its own.",
                 extensions("glb gltf"));
        const Real modelSize = real("modelSize", 0.8, meter, Range{0.01, 100, logarithmic}.soft(0.1, 3),
                                    "Length of the object's largest side.", whenGiven(model));
        const Real modelRotation = real("modelRotation", 0.0, degree, {degrees(-180), degrees(180)},
                                        "Rotation of the object about the vertical axis.", whenGiven(model));
        const Choice<ObjectStand> modelStand = choice(
            "modelStand", first ? ObjectStand::freePlinth : ObjectStand::ownPlinth,
            {"free plinth", "own plinth", "floor"},
            "Base of the object: the free plinth of the hall, a plinth of its own, or the floor.", whenGiven(model));
        const auto moved = whenGiven(model) && when(modelStand, {ObjectStand::ownPlinth, ObjectStand::floor});
        const glm::dvec2 spot = objectSpots.at(which);
        const Real modelAcross = real("modelAcross", spot.x, meter, {-5.6, 5.6},
                                      "Position of the object to the right of the hall's middle, seen from the "
                                      "entrance; walls and furniture limit it.",
                                      moved);
        const Real modelAlong = real(
            "modelAlong", spot.y, meter, {-11.6, 11.6},
            "Position of the object from the hall's middle towards the entrance; walls and furniture limit it.", moved);
        const Real modelPlinthHeight =
            real("modelPlinthHeight", 0.8, meter, Range{0.05, 3}.soft(0.2, 1.4), "Height of the object's own plinth.",
                 whenGiven(model) && when(modelStand, ObjectStand::ownPlinth));
        return {model, modelSize, modelRotation, modelStand, modelAcross, modelAlong, modelPlinthHeight};
    }
};

}  // namespace vitrine::hall

#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::test {

enum class Method { forward, tetrahedron, central };

/// Table with parameters that have an effect only sometimes, and words for numbers.
struct IdleTable final : Parameters {
    Group sun = group("Sun");
    Choice<Method> sunBy =
        choice("sunBy", Method::forward, {"angles", "hour", "nothing"}, "How the sun is set.", labeled("Set sun by"));
    Real height = real("sunHeight", 0.5, none, {0, 1}, "Above the horizon.", when(sunBy, Method::forward));
    Real hourOfDay = real("hourOfDay", 16.1, hour, {0, 24}, "Of the day.", when(sunBy, Method::tetrahedron));
    Real gap = real("convergence", 0, meter, {0, 10}, "Where the views meet.", reads(0, "auto"));
    Group accuracy = group("Accuracy");
    Count steps = count("steps", 8, {1, 64}, "Of the march.");
};

enum class Beams { volume, screen };

/// Table with essential parameters, and at first a group without any effect.
struct EssentialTable final : Parameters {
    Group show = group("Display");
    Choice<Beams> technique =
        choice("technique", Beams::volume, {"volume", "screen space"}, "How beams are made.", essential());
    Real angle = real("angle", 0, none, {0, 1}, "Angle of the view.");
    Group rays = group("Screen space");
    Real decay = real("decay", 0.5, none, {0, 1}, "Decay of the rays.", when(technique, Beams::screen));
    Real weight = real("weight", 0.5, none, {0, 1}, "Weight of the rays.", when(technique, Beams::screen));
    Group air = group("Air");
    Real density = real("airDensity", 0.5, none, {0, 1}, "Density of the dust.", essential());
    Real falloff = real("airFalloff", 0.5, none, {0, 1}, "Falloff of the dust with height.");
    Group color = group("Color");
    Real tint = real("tint", 0.5, none, {0, 1}, "Color of the dust.", essential());
};

/// Table with one parameter of every kind, unit style and scale.
struct SampleTable final : Parameters {
    Group shape = group("Shape");
    Real morph = real("morph", 0.5, none, {0, 1},
                      "0 is a torus, 1 is a mug, and everything between is one solid with one hole.");
    Toggle animated = toggle("animated", true, "Lets the morph travel from end to end and back.");
    Real speed = real("speed", 0.05, hertz, Range{0, 5}.soft(0, 0.5), "Round trips per second: low melts, high jumps.",
                      when(animated));
    Real tube =
        real("tubeRadius", 0.012, millimeter, {0.001, 0.2, logarithmic, 0.002, 0.1}, "Radius of the torus's tube.");
    Real tilt = real("tilt", 0, degree, {-3.14159265358979, 3.14159265358979},
                     "Turns the solid about the axis to the visitor.");

    Group surface = group("Surface");
    Color base =
        color("baseColor", {0.76, 0.21, 0.09}, "Color of light reflected straight back: chrome takes it as its tint.");
    Real roughness = real("roughness", 0.25, none, {0, 1}, "0 mirrors, 1 is chalk.");
    Choice<Method> material =
        choice("material", Method::forward, {"chrome", "glazed ceramic", "glass"}, "What it is made of.");
    Direction light = direction("lightDirection", {0.4, 0.7, -0.6}, "Where the light comes from.");
    File environment =
        file("environment", "A panorama (EXR, HDR, PNG) in place of the sky.", extensions("hdr exr png"));

    Group tracing = group("Tracing");
    Count stepLimit = count("stepLimit", 96, {1, 512, logarithmic},
                            "Steps a ray may take before it ends on its best candidate.", quality(512));
    Count bounces =
        count("reflectionBounces", 2, {0, 4}, "Reflections of reflections: 0 sees only the room.", quality(4));
    Real tolerance =
        real("hitTolerance", 0.5, pixel, {0.01, 8, logarithmic}, "A ray has hit when it is this near.", quality(0.01));
    Choice<Method> normal = choice("normalMethod", Method::central, {"forward", "tetrahedron", "central"},
                                   "How the normal is estimated.", quality(2));
    Real exposure = real("exposure", 0, stop, Range{-16, 16}.soft(-4, 4), "Brightens by powers of two.");
    Real haze = real("haze", 0.1, percent, {0, 1}, "Light scattered on the way.");
};

}  // namespace vitrine::test

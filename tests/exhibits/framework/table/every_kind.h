#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::test {

enum class Way : std::uint8_t { plain, Fancy, both };

/// Table with parameters of every kind and unit.
struct EveryKind final : Parameters {
    Real morph = real("morph", 0.5, none, {0, 1}, "A plain number.");
    Real exposure = real("exposure", 0, stop, {-16, 16}, "A number in stops.");
    Real angle = real("angle", 0.5235987755982988, degree, {-3.141592653589793, 3.141592653589793}, "An angle.");
    Real gap = real("gap", 0.012, millimeter, {0, 10}, "A length in millimeters.");
    Real grain = real("grain", 1e-6, micrometer, {1e-9, 1, logarithmic}, "A length in micrometers.");
    Real share = real("share", 0.25, percent, {0, 1}, "A share.");
    Real density = real("density", 2, perMeter, {0, 1000}, "Something per meter.");
    Count stepLimit = count("stepLimit", 96, {1, 512, logarithmic}, "A whole number.", quality(512));
    Toggle wind = toggle("wind", false, "A switch.");
    Choice<Way> way = choice("way", Way::plain, {"plain", "Fancy", "both"}, "A choice.");
    Color tint = color("tint", {1, 0.5, 0.25}, "A color.");
    Direction sun = direction("sun", {0, 1, 0}, "A direction.");
    File picture = file("picture", "A file.");
};

inline const EveryKind everyKind;

}  // namespace vitrine::test

#pragma once

#include "exhibits/framework/table/studied_parameters.h"
#include "exhibits/kit/sdf_parameters.h"

#include <numbers>

namespace vitrine::sdf_morph {

/// Parameters of the melting torus-mug. Lengths are in meters, in its own space.
struct TorusMugParameters : virtual Parameters {
    Group shape = group("Shape");
    Real morph =
        real("morph", 0.62, none, {0, 1}, "Shape between torus and mug: 0 is the torus, 1 is the mug.", essential());
    Real majorRadius = real("majorRadius", 0.35, meter, Range{0.01, 10}.soft(0.1, 0.6),
                            "Radius of the torus, from its center to the middle of the tube.");
    Real minorRadius =
        real("minorRadius", 0.12, meter, Range{0.001, 10}.soft(0.02, 0.3), "Radius of the tube of the torus.");
    Real mugRadius =
        real("mugRadius", 0.28, meter, Range{0.01, 10}.soft(0.1, 0.5), "Radius of the outside of the mug.");
    Real mugHeight =
        real("mugHeight", 0.66, meter, Range{0.01, 10}.soft(0.2, 1.2), "Height of the mug, from its foot to its lip.");
    Real wallThickness = real("wallThickness", 0.045, meter, Range{0.001, 1}.soft(0.01, 0.12),
                              "Thickness of the wall of the mug: thin walls need small steps.");
    Real handleRadius = real("handleRadius", 0.165, meter, Range{0.01, 2}.soft(0.05, 0.3),
                             "Radius of the handle, from its center to the middle of its tube.");
    Real handleThickness =
        real("handleThickness", 0.09, meter, Range{0.001, 1}.soft(0.02, 0.2), "Diameter of the tube of the handle.");
    Real blend = real("blend", 0.06, meter, Range{0, 1}.soft(0, 0.2),
                      "Width of the fillet where the handle meets the cup; 0 joins them hard.");

    Group motion = group("Motion");
    Toggle animate =
        toggle("animate", false, "Whether the shape melts back and forth, starting from the morph above.", essential());
    Real speed = real("speed", 0.08, hertz, Range{0, 10}.soft(0, 0.5), "Frequency of the melting, to the mug and back.",
                      when(animate));
};

/// Position of the hall's sun, in radians, from which it shines nearly straight through the window at the exhibit in
/// the middle.
inline constexpr double straightSunElevation = 19 * std::numbers::pi / 180;
inline constexpr double straightSunAzimuth = -3 * std::numbers::pi / 180;

/// All parameters of the exhibit.
struct SdfMorphTable final : TorusMugParameters, SdfMaterialParameters, SdfParameters {
    // Bare metal shows no shadow of its own, and a small sun hardly any penumbra. The sun of the hall as it opens
    // passes the exhibit by.
    StudiedParameters studied{*this,
                              {{.name = "shadowMethod",
                                .with = {{"metalness", 0}},
                                .hall = {{"sunElevation", straightSunElevation}, {"sunAzimuth", straightSunAzimuth}},
                                .views = {"best view", "into the mug, along its wall"}},
                               {.name = "shadowRays",
                                .with = {{"metalness", 0}, {"sunWidth", degrees(10)}},
                                .hall = {{"sunElevation", straightSunElevation}, {"sunAzimuth", straightSunAzimuth}},
                                .views = {"best view", "into the mug, along its wall"}}}};
};

}  // namespace vitrine::sdf_morph

#include "exhibits/ice_cream/ice_cream_table.h"

namespace vitrine {

CreamRows IceCreamRows::layer(const CreamInitial& initial)
{
    CreamRows rows{};
    rows.lobes = count("lobes", initial.lobes, {3, 12}, "Cones around the axis.");
    rows.radius = real("radius", initial.radius, meter, Range{0.01, 0.5}.soft(0.03, 0.3), "Of a cone at its base.");
    rows.height = real("height", initial.height, meter, Range{0.05, 1.5}.soft(0.1, 0.9), "Of a cone.");
    rows.corner =
        real("corner", 0.03, meter, Range{0, 0.2}.soft(0, 0.08), "Radius of its edges; cut so that a cone is left.");
    rows.offsetX = real("offsetX", initial.offsetX, meter, Range{-0.5, 0.5}, "Where its base is, across.");
    rows.offsetZ = real("offsetZ", initial.offsetZ, meter, Range{-0.5, 0.5}, "Where its base is, towards the front.");
    rows.raise =
        real("raise", initial.raise, meter, Range{-0.5, 1}.soft(-0.2, 0.5), "Of its base above the rim of the bowl.");
    rows.tilt = real("tilt", initial.tilt, degree, Range{degrees(-180), degrees(180)}.soft(degrees(-90), degrees(90)),
                     "How far it leans: below 0 towards the axis.");
    rows.yaw = real("yaw", initial.yaw, degree, Range{degrees(-180), degrees(180)},
                    "How far it leans past the axis to a side.");
    rows.twist = real("twist", initial.twist, perMeter, Range{-30, 30}.soft(-12, 12),
                      "Radians by which the layer turns for each meter of height.");
    rows.blend = real("blend", 0.01, meter, Range{0, 0.3}.soft(0, 0.08),
                      "Width of the fillet between neighbors: wide makes soft folds.");
    rows.color = color("color", {0.8388, 0.8468, 0.6939}, "Of the layer.");
    return rows;
}

CandyRows IceCreamRows::candy(const CandyInitial& initial)
{
    CandyRows rows{};
    rows.x = real("x", initial.x, meter, Range{-20, 20}.soft(-1, 1), "Where it is, across.");
    rows.y = real("y", initial.y, meter, Range{-20, 20}.soft(0, 1.5), "How high it is.");
    rows.z = real("z", initial.z, meter, Range{-20, 20}.soft(-1, 1), "Where it is, towards the front.");
    rows.halfX = real("halfX", 0.02, meter, Range{0.001, 0.5}.soft(0.005, 0.08), "Half its width.");
    rows.halfY = real("halfY", 0.03, meter, Range{0.001, 0.5}.soft(0.005, 0.08), "Half its height.");
    rows.halfZ = real("halfZ", 0.01, meter, Range{0.001, 0.5}.soft(0.005, 0.08), "Half its depth.");
    rows.corner = real("corner", 0.007, meter, Range{0, 0.5}.soft(0, 0.05),
                       "Radius of its edges, cut to half its smallest side.");
    rows.color = color("color", initial.color, "Of the candy.");
    rows.tumble = count("tumble", initial.tumble, {0, 9999}, "Which of many ways it lies; 0 is upright.");
    rows.spin = real("spin", initial.spin, none, Range{-100, 100}.soft(-5, 5),
                     "How fast it spins, against the source's slow and uneven turn.", whenLater("animate", 1));
    rows.bob = real("bob", initial.bob, meter, Range{0, 2}.soft(0, 0.2), "How far it floats up and down.",
                    whenLater("animate", 1));
    return rows;
}

}  // namespace vitrine

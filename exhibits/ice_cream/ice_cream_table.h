#pragma once

#include "exhibits/framework/table/studied_parameters.h"
#include "exhibits/kit/sdf_parameters.h"

#include <array>
#include <vector>

namespace vitrine::ice_cream {

inline constexpr std::size_t creamLayerCount = 2;
inline constexpr std::size_t candyCount = 10;

enum class IceCreamParts : int { all, foot, collar, bowl, rings, bars, lower, upper, candies, sprinkles };
enum class IceCreamColors : int { material, part };
enum class IceCreamLighting : int { hall, reference };
enum class IceCreamHighlight : int { ggx, blinnPhong };
enum class SprinkleColors : int { candies, one };
/// Stages of the build-up: the STAGE_ numbers of shaders/ice_cream/ice_cream_block.glsl.
enum class IceCreamStage : int {
    foot,
    collar,
    bowl,
    rings,
    bars,
    wafer,
    cone,
    round,
    repeated,
    joined,
    twist,
    upper,
    layers,
    candies,
    colors,
    specular,
    classic,
    improved,
    occlusion,
    fog,
    finished
};

/// Parameters of one layer of cream. Lengths are in meters before scaling by `size`.
struct CreamParameters {
    Count lobes;
    Real radius, height, corner, offsetX, offsetZ, raise, tilt, yaw, twist, blend;
    Color color;
};

/// Parameters of one candy. Lengths are in meters before scaling by `size`.
struct CandyParameters {
    Real x, y, z, halfX, halfY, halfZ, corner;
    Color color;
    Count tumble;
    Real spin, bob;
};

/// Parameters of the soft serve: its shape, its materials, its two lights. Lengths are in meters before scaling by
/// `size`; y is up from the wafer's foot. The colors are those of the reference, which displayed them without a gamma
/// curve: here they are linear light.
struct IceCreamParameters : virtual Parameters {
    Group whole = group("Ice cream");
    Choice<IceCreamStage> stage = choice(
        "stage", IceCreamStage::finished,
        {"foot",        "collar",     "bowl",           "rings",           "bars",        "smooth wafer",  "one cone",
         "round edges", "repeated",   "joined",         "twisted",         "upper layer", "smooth layers", "candies",
         "colors",      "highlights", "shadow k h / t", "improved shadow", "occlusion",   "fog",           "finished"},
        "Stage of the build-up, in the order of the reference's slides; each stage includes all before it.",
        essential());
    Toggle buildUp = toggle("buildUp", false, "Whether the ice cream is built up stage by stage, again and again.");
    Real stageTime = real("stageTime", 1.5, second, Range{0.05, 60, logarithmic}.soft(0.2, 10),
                          "Time for which each stage is shown.", when(buildUp));
    Choice<IceCreamParts> show =
        choice("show", IceCreamParts::all,
               {"all", "foot", "collar", "bowl", "rings", "bars", "lower cream", "upper cream", "candies", "sprinkles"},
               "Part of the ice cream to show: one alone, or all.");
    Choice<IceCreamColors> colorBy = choice("colorBy", IceCreamColors::material, {"material", "part"},
                                            "Meaning of the colors: the materials, or one color per part.");
    Toggle animate =
        toggle("animate", false, "Whether the candies spin, those in the air float, and the whole ice cream turns.");
    Real orbitSpeed =
        real("orbitSpeed", 0.1 / (2 * std::numbers::pi), hertz, Range{-10, 10}.soft(-0.2, 0.2),
             "Speed at which the ice cream turns, in turns per second: negative turns the other way.", when(animate));
    Real orbitAngle = real("orbitAngle", 0.0, degree, Range{degrees(-180), degrees(180)},
                           "Rotation of the ice cream about its axis.");
    Real size = real("size", 0.66, none, Range{0.01, 10, logarithmic}.soft(0.2, 1.5),
                     "Size relative to the reference, which is 1.4 m high.");

    Group wafer = group("Wafer");
    Real footHeight = real("footHeight", 0.46, meter, Range{0.02, 2}.soft(0.1, 1),
                           "Height of the foot, the frustum on which the wafer stands.");
    Real footRadius =
        real("footRadius", 0.2, meter, Range{0.01, 1}.soft(0.05, 0.4), "Radius of the foot at its bottom.");
    Real footTop = real("footTop", 0.25, meter, Range{0.01, 1}.soft(0.05, 0.4), "Radius of the foot at its top.");
    Real collarHeight = real("collarHeight", 0.04, meter, Range{0.002, 0.5}.soft(0.01, 0.15),
                             "Height of the collar, the second frustum.");
    Real collarRadius =
        real("collarRadius", 0.2675, meter, Range{0.01, 1}.soft(0.1, 0.4), "Radius of the collar at its bottom.");
    Real collarTop =
        real("collarTop", 0.2375, meter, Range{0.01, 1}.soft(0.1, 0.4), "Radius of the collar at its top.");
    Real bowlRadius = real("bowlRadius", 0.325, meter, Range{0.02, 1}.soft(0.2, 0.5),
                           "Radius of the sphere from which the bowl is cut.");
    Real bowlBottom = real("bowlBottom", 0.2535, meter, Range{0.01, 1}.soft(0.1, 0.32),
                           "Radius of the bowl at its bottom; at most that of its sphere.");
    Real bowlTop =
        real("bowlTop", 0.32175, meter, Range{0.01, 1}.soft(0.2, 0.5),
             "Radius of the bowl at its rim; at least the radius of its bottom, and at most that of its sphere.");
    Count rings = count("rings", 3, {0, 24}, "Number of rings around the foot, evenly spaced over its height.");
    Real ringTube =
        real("ringTube", 0.0075, meter, Range{0.0005, 0.05}.soft(0.002, 0.02), "Radius of the tube of the rings.");
    Count bars = count("bars", 7, {0, 36}, "Number of bars up the side of the foot.");
    Real barRadius = real("barRadius", 0.01, meter, Range{0.0005, 0.05}.soft(0.002, 0.025),
                          "Radius of the round cross-section of the bars.");
    Real reliefBlend = real("reliefBlend", 0.00875, meter, Range{0, 0.1}.soft(0, 0.03),
                            "Width of the fillet where bars cross rings; 0 joins them sharply.");
    Real footBlend =
        real("footBlend", 0.0075, meter, Range{0, 0.1}.soft(0, 0.03),
             "Width of the fillet between the relief (bars and rings) and the foot; 0 joins them sharply.");

    /// Indexed by layer: lowerLobes, ... upperLobes, ...
    std::vector<CreamParameters> layers =
        groups("layers", layerElements, [this](std::size_t i) { return layer(i, layerInitials[i]); });
    Group joints = group("Fillets of the cream");
    Real layerBlend = real("layerBlend", 0.1, meter, Range{0, 0.5}.soft(0, 0.15),
                           "Width of the fillet between the two layers of cream; 0 joins them sharply.");
    Real waferBlend = real("waferBlend", 0.01, meter, Range{0, 0.5}.soft(0, 0.1),
                           "Width of the fillet between cream and wafer: wide looks melted.");

    /// Indexed by candy: candy1X, ... candy10Bob.
    std::vector<CandyParameters> candies =
        groups("candies", candyElements, [this](std::size_t i) { return candy(candyInitials[i]); });

    Group sprinkling = group("Sprinkles");
    Count sprinkles = count("sprinkles", 130, Range{0, 5000}.soft(0, 1500),
                            "Number of sprinkles on the cream, placed at random.", essential());
    Count sprinkleSeed =
        count("sprinkleSeed", 1, {1, 9999}, "Seed of the sprinkles' places: each number places them elsewhere.",
              whenLaterAbove("sprinkles", 0));
    Real sprinkleLength = real("sprinkleLength", 0.034, meter, Range{0.001, 0.2}.soft(0.005, 0.08),
                               "Length of a sprinkle.", whenLaterAbove("sprinkles", 0));
    Real sprinkleThickness = real("sprinkleThickness", 0.010, meter, Range{0.001, 0.05}.soft(0.004, 0.02),
                                  "Thickness of a sprinkle.", whenLaterAbove("sprinkles", 0));
    Choice<SprinkleColors> sprinkleColors = choice(
        "sprinkleColors", SprinkleColors::candies, {"candies", "one"},
        "Colors of the sprinkles: those of the first five candies, or a single one.", whenLaterAbove("sprinkles", 0));
    Color sprinkleColor = color("sprinkleColor", {0.16, 0.055, 0.022}, "Color of all sprinkles.",
                                when(sprinkleColors, SprinkleColors::one));

    Group surface = group("Cream and wafer");
    Choice<SdfMaterial> material = choice(
        "material", SdfMaterial::opaque, {"opaque", "glass"},
        "Material of the ice cream: opaque reflects, glass also refracts at every surface.", whenLater("lighting", 0));
    Color glassColor = color("glassColor", {0.86, 0.95, 0.97}, "Color of white light after 10 cm of the glass.",
                             when(material, SdfMaterial::glass));
    Real refractiveIndex =
        real("refractiveIndex", 1.5, none, Range{1, 3}.soft(1, 2.4),
             "Refractive index of the glass: 1 bends nothing, 2.4 is diamond.", when(material, SdfMaterial::glass));
    Color waferColor = color("waferColor", {0.7156, 0.3814, 0.0865}, "Color of the wafer.");
    Real waferRoughness =
        real("waferRoughness", 1.0, none, {0, 1}, "Roughness of the wafer: 0 is a mirror, 1 is chalk.");
    Real toast = real("toast", 0.5, none, {0, 1},
                      "Darkness of the wafer where it was hottest, on ridges and rims: 0 is pale, 1 is well toasted.",
                      when(material, SdfMaterial::opaque));
    Real pores = real("pores", 0.7, none, {0, 1}, "Depth of the pores in the wafer: 0 is smooth, 1 is coarse.",
                      when(material, SdfMaterial::opaque));
    Real creamRoughness =
        real("creamRoughness", 0.45, none, {0, 1}, "Roughness of the cream: low looks melting, high dry.");
    Real melt = real("melt", 0.45, none, {0, 1},
                     "Share of the cream's surface that has begun to melt and shines: 0 is none, 1 is all of it.",
                     when(material, SdfMaterial::opaque));
    Real subsurface =
        real("subsurface", 0.75, none, {0, 1},
             "Share of the lamp's light that enters the cream and leaves it elsewhere: 0 is hard like porcelain, high "
             "is soft and glows where it is thin.",
             when(material, SdfMaterial::opaque) && whenLaterAbove("lamp", 0));
    Real subsurfaceDepth = real("subsurfaceDepth", 0.06, meter, Range{0.002, 0.5, logarithmic}.soft(0.01, 0.2),
                                "Depth to which light enters the cream.", whenAbove(subsurface, 0));
    Real candyRoughness =
        real("candyRoughness", 0.65, none, {0, 1}, "Roughness of candies and sprinkles: 0 is a mirror, 1 is chalk.");
    Real metalness = real("metalness", 0.0, none, {0, 1},
                          "Share of metal in all materials: 0 is none, 1 is bare metal in their colors.");

    Group stand = group("Plinth");
    Toggle plinth = toggle("plinth", true, "Whether the ice cream stands on a plinth.");
    Color plinthColor = color("plinthColor", {0.36, 0.31, 0.26}, "Color of the plinth.", when(plinth));
    Real plinthRoughness = real("plinthRoughness", 0.55, none, {0, 1},
                                "Roughness of the plinth: 0 is a mirror, 1 is chalk.", when(plinth));

    Group ownLight = group("Light");
    Choice<IceCreamLighting> lighting = choice(
        "lighting", IceCreamLighting::hall, {"hall", "reference"},
        "Lighting of the ice cream: by the hall around it, or by the sun, ambient light and fog of the reference.",
        essential());
    Real lamp =
        real("lamp", 1.9, none, Range{0, 100}.soft(0, 8),
             "Strength of the lamp in front of the niche: 0 switches it off.", when(lighting, IceCreamLighting::hall));
    Color lampColor =
        color("lampColor", {1.0, 0.88, 0.74}, "Color of the lamp in front of the niche.", whenAbove(lamp, 0));
    Direction lampDirection = direction("lampDirection", {-0.85, 0.62, 0.42},
                                        "Direction from the ice cream to the lamp.", whenAbove(lamp, 0));
    Real backdrop =
        real("backdrop", 0.36, none, Range{0, 100}.soft(0, 3),
             "Strength of the light on the backdrop behind the ice cream; 0 leaves the niche bare and dark.",
             when(lighting, IceCreamLighting::hall));
    Color backdropColor = color("backdropColor", {0.10, 0.30, 0.33}, "Color of the backdrop.", whenAbove(backdrop, 0));
    Choice<IceCreamHighlight> highlight = choice("highlight", IceCreamHighlight::blinnPhong, {"GGX", "Blinn-Phong"},
                                                 "Model of the highlights of the reference's sun: microfacets (GGX), "
                                                 "or Blinn-Phong with the exponent 2^(10 (1 - roughness)).",
                                                 when(lighting, IceCreamLighting::reference));
    Direction referenceSun = direction("referenceSun", {-16, 12, 4}, "Direction to the sun of the reference.",
                                       when(lighting, IceCreamLighting::reference));
    Color referenceSunColor = color("referenceSunColor", {1.0, 0.7, 0.5}, "Color of the reference's sun.",
                                    when(lighting, IceCreamLighting::reference));
    Real referenceSunStrength =
        real("referenceSunStrength", 1 / 1.2, none, Range{0, 100}.soft(0, 3),
             "Strength of the reference's sun: 0 switches it off.", when(lighting, IceCreamLighting::reference));
    Color referenceAmbient = color("referenceAmbient", {0.2, 0.1, 0.0},
                                   "Color of the reference's ambient light, of which more comes from above.",
                                   when(lighting, IceCreamLighting::reference));
    Count occlusionTaps =
        count("occlusionTaps", 5, {2, 64, logarithmic},
              "Number of samples along the normal that darken what is hidden from the ambient light: few are coarse.",
              quality(64), when(lighting, IceCreamLighting::reference) && whenLater("ambientOcclusion", 1));
    Real referenceFog =
        real("referenceFog", 0.0005, none, Range{0, 10}.soft(0, 0.05),
             "Density of the reference's black fog: light falls to 1/e where this value times the cube of "
             "the distance is 1.",
             when(lighting, IceCreamLighting::reference));
    Toggle ground =
        toggle("ground", true, "Whether sand and a black horizon surround the ice cream when it is shown alone.",
               when(lighting, IceCreamLighting::reference));
    Color groundColor =
        color("groundColor", {0.8796, 0.8796, 0.8796}, "Color of the sand in white light.", when(ground));

private:
    struct CreamInitial {
        int lobes;
        double radius, height, offsetX, offsetZ, raise, tilt, yaw, twist, blend;
    };
    static constexpr std::array<Element, creamLayerCount> layerElements{
        {{"lower", "Lower layer of cream"}, {"upper", "Upper layer of cream"}}};
    // The reference raises the upper layer by the lower one's height less 0.05, along x and z as well as up. Here it is
    // lower by another 0.046, and the fillets are wider, so that no holes are left between the cones.
    static constexpr double raised = 0.4 * 0.5403023058681398;
    static constexpr std::array<CreamInitial, creamLayerCount> layerInitials{{
        {7, 0.16, 0.40, 0.1, 0.3, 0.03, -1.0, std::numbers::pi / 10, 5, 0.015},
        {5, 0.10, 0.60, 0.06 - raised, 0.3 - raised, 0.03 + raised - 0.096, -0.33, -std::numbers::pi / 3, 6, 0.035},
    }};
    struct CandyInitial {
        double x, y, z;
        glm::dvec3 color;
        int tumble;
        double spin, bob;
    };
    static constexpr std::array<Element, candyCount> candyElements{{{"candy1", "Candy 1"},
                                                                    {"candy2", "Candy 2"},
                                                                    {"candy3", "Candy 3"},
                                                                    {"candy4", "Candy 4"},
                                                                    {"candy5", "Candy 5"},
                                                                    {"candy6", "Candy 6"},
                                                                    {"candy7", "Candy 7"},
                                                                    {"candy8", "Candy 8, in the air"},
                                                                    {"candy9", "Candy 9, in the air"},
                                                                    {"candy10", "Candy 10, in the air"}}};
    static constexpr glm::dvec3 red{0.8796, 0.0158, 0.0137}, green{0.0173, 0.8456, 0.0092},
        blue{0.0155, 0.0754, 0.8796}, yellow{0.9266, 0.8796, 0.0053}, pink{0.6795, 0.0996, 0.2219};
    // The fourth and the sixth candy are moved to the surface of this cream, by 5 and 23 mm.
    // In the reference, z of the first candy is 16 instead of .16, so it is out of sight. The fifth one, at (-.06, 1.1,
    // -.11), is inside the cream there; here it is moved out to the surface.
    static constexpr std::array<CandyInitial, candyCount> candyInitials{{
        {0.12, 1.0, 0.16, red, 1, 0, 0},
        {0.06, 1.2, -0.08, green, 2, 0, 0},
        {-0.16, 0.9, 0.11, blue, 3, 0, 0},
        {-0.203, 0.842, -0.203, yellow, 4, 0, 0},
        {-0.0745, 1.1, -0.1365, pink, 5, 0, 0},
        {0.151, 0.95, -0.140, yellow, 6, 0, 0},
        {0.01, 0.94, 0.19, red, 7, 0, 0},
        // The last three float in the air. In the reference they are a meter from the axis; here they are nearer,
        // because of the walls.
        {0.27, 1.12, 0.36, green, 8, 1, 0.07},
        {-0.46, 1.05, 0.08, pink, 9, 1, 0.05},
        {0.32, 1.32, -0.2, blue, 10, 1, 0.06},
    }};

    CreamParameters layer(std::size_t which, const CreamInitial& initial)
    {
        CreamParameters rows{};
        rows.lobes = count("lobes", initial.lobes, {3, 12}, "Number of cones around the axis of this layer.");
        rows.radius =
            real("radius", initial.radius, meter, Range{0.01, 0.5}.soft(0.03, 0.3), "Radius of a cone at its base.");
        rows.height = real("height", initial.height, meter, Range{0.05, 1.5}.soft(0.1, 0.9), "Height of a cone.");
        rows.corner = real("corner", 0.03, meter, Range{0, 0.2}.soft(0, 0.08),
                           "Radius of the rounded edges of a cone; limited so that a cone is left.");
        rows.offsetX = real("offsetX", initial.offsetX, meter, Range{-0.5, 0.5},
                            "Sideways position of the cones' bases, measured from the axis.");
        rows.offsetZ = real("offsetZ", initial.offsetZ, meter, Range{-0.5, 0.5},
                            "Position of the cones' bases towards the front, measured from the axis.");
        rows.raise = real("raise", initial.raise, meter, Range{-0.5, 1}.soft(-0.2, 0.5),
                          "Height of the cones' bases above the rim of the bowl.");
        rows.tilt =
            real("tilt", initial.tilt, degree, Range{degrees(-180), degrees(180)}.soft(degrees(-90), degrees(90)),
                 "Tilt of the cones: negative leans them towards the axis.");
        rows.yaw = real("yaw", initial.yaw, degree, Range{degrees(-180), degrees(180)},
                        "Sideways rotation of the cones, by which they lean past the axis.");
        rows.twist = real("twist", initial.twist, perMeter, Range{-30, 30}.soft(-12, 12),
                          "Twist of the layer, in radians per meter of height: 0 is straight.", essential(which == 1));
        rows.blend = real("blend", initial.blend, meter, Range{0, 0.3}.soft(0, 0.08),
                          "Width of the fillet between neighboring cones: wide makes soft folds.");
        rows.color = color("color", {0.8388, 0.8468, 0.6939}, "Color of this layer.");
        return rows;
    }
    CandyParameters candy(const CandyInitial& initial)
    {
        CandyParameters rows{};
        rows.x = real("x", initial.x, meter, Range{-20, 20}.soft(-1, 1),
                      "Sideways position of the candy, measured from the axis.");
        rows.y = real("y", initial.y, meter, Range{-20, 20}.soft(0, 1.5),
                      "Height of the candy above the foot of the wafer.");
        rows.z = real("z", initial.z, meter, Range{-20, 20}.soft(-1, 1),
                      "Position of the candy towards the front, measured from the axis.");
        rows.halfX = real("halfX", 0.02, meter, Range{0.001, 0.5}.soft(0.005, 0.08), "Half the width of the candy.");
        rows.halfY = real("halfY", 0.03, meter, Range{0.001, 0.5}.soft(0.005, 0.08), "Half the height of the candy.");
        rows.halfZ = real("halfZ", 0.01, meter, Range{0.001, 0.5}.soft(0.005, 0.08), "Half the depth of the candy.");
        rows.corner = real("corner", 0.007, meter, Range{0, 0.5}.soft(0, 0.05),
                           "Radius of the rounded edges of the candy; at most half its smallest side.");
        rows.color = color("color", initial.color, "Color of the candy.");
        rows.tumble =
            count("tumble", initial.tumble, {0, 9999}, "Seed of the random rotation of the candy; 0 is upright.");
        rows.spin = real("spin", initial.spin, none, Range{-100, 100}.soft(-5, 5),
                         "Speed at which the candy spins, relative to the slow and uneven rotation in the reference.",
                         whenLater("animate", 1));
        rows.bob = real("bob", initial.bob, meter, Range{0, 2}.soft(0, 0.2),
                        "Distance by which the candy floats up and down.", whenLater("animate", 1));
        return rows;
    }
};

/// All parameters of the exhibit.
struct IceCreamTable final : IceCreamParameters, SdfParameters {
    IceCreamTable() : SdfParameters(0, when(lighting, IceCreamLighting::reference)) {}

    // The hall's sun hardly reaches the niche, but the reference's sun does.
    StudiedParameters studied{*this,
                              {{.name = "shadowMethod", .views = {"reference"}},
                               {.name = "shadowRays", .with = {{"sunWidth", degrees(10)}}, .views = {"reference"}}}};
};

}  // namespace vitrine::ice_cream

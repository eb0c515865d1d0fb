#pragma once

#include "exhibits/framework/studied_rows.h"
#include "exhibits/kit/sdf_rows.h"

#include <array>
#include <vector>

namespace vitrine {

inline constexpr std::size_t creamLayerCount = 2;
inline constexpr std::size_t candyCount = 10;

enum class IceCreamParts : int { all, foot, collar, bowl, rings, bars, lower, upper, candies, sprinkles };
enum class IceCreamColors : int { material, part };
enum class IceCreamLighting : int { hall, source };
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
struct CreamRows {
    Count lobes;
    Real radius, height, corner, offsetX, offsetZ, raise, tilt, yaw, twist, blend;
    Color color;
};

/// Parameters of one candy. Lengths are in meters before scaling by `size`.
struct CandyRows {
    Real x, y, z, halfX, halfY, halfZ, corner;
    Color color;
    Count tumble;
    Real spin, bob;
};

/// Parameters of the soft serve: its shape, its materials, its two lights. Lengths are in meters before scaling by
/// `size`; y is up from the wafer's foot. The colors are those of the reference, which displayed them without a gamma
/// curve: here they are linear light.
struct IceCreamRows : virtual Parameters {
    Group whole = group("Ice cream");
    Choice<IceCreamStage> stage = choice(
        "stage", IceCreamStage::finished,
        {"foot",        "collar",     "bowl",           "rings",           "bars",        "smooth wafer",  "one cone",
         "round edges", "repeated",   "joined",         "twisted",         "upper layer", "smooth layers", "candies",
         "colors",      "highlights", "shadow k h / t", "improved shadow", "occlusion",   "fog",           "finished"},
        "How far it is built up, as its author's slides go; each stage has all before it.");
    Toggle buildUp = toggle("buildUp", false, "Build it up by itself, again and again.");
    Real stageTime = real("stageTime", 1.5, second, Range{0.05, 60, logarithmic}.soft(0.2, 10),
                          "How long each stage is shown.", when(buildUp));
    Choice<IceCreamParts> show =
        choice("show", IceCreamParts::all,
               {"all", "foot", "collar", "bowl", "rings", "bars", "lower cream", "upper cream", "candies", "sprinkles"},
               "One part alone, or all of them.");
    Choice<IceCreamColors> colorBy =
        choice("colorBy", IceCreamColors::material, {"material", "part"},
               "Whether colors are those of what it is made of, or tell the parts from each other.");
    Toggle animate = toggle("animate", false, "Spin the candies, let those in the air float, and turn the whole.");
    Real orbitSpeed = real("orbitSpeed", 0.1 / (2 * std::numbers::pi), hertz, Range{-10, 10}.soft(-0.2, 0.2),
                           "Turns a second, as if the camera went round it.", when(animate));
    Real orbitAngle = real("orbitAngle", 0.0, degree, Range{degrees(-180), degrees(180)}, "How far it is turned.");
    Real size = real("size", 0.66, none, Range{0.01, 10, logarithmic}.soft(0.2, 1.5),
                     "Its size against the source's, which is 1.4 m high.");

    Group wafer = group("Wafer");
    Real footHeight = real("footHeight", 0.46, meter, Range{0.02, 2}.soft(0.1, 1), "Of the frustum that it stands on.");
    Real footRadius = real("footRadius", 0.2, meter, Range{0.01, 1}.soft(0.05, 0.4), "Of that frustum at the bottom.");
    Real footTop = real("footTop", 0.25, meter, Range{0.01, 1}.soft(0.05, 0.4), "Of that frustum at the top.");
    Real collarHeight = real("collarHeight", 0.04, meter, Range{0.002, 0.5}.soft(0.01, 0.15), "Of the second frustum.");
    Real collarRadius =
        real("collarRadius", 0.2675, meter, Range{0.01, 1}.soft(0.1, 0.4), "Of the second frustum at the bottom.");
    Real collarTop =
        real("collarTop", 0.2375, meter, Range{0.01, 1}.soft(0.1, 0.4), "Of the second frustum at the top.");
    Real bowlRadius =
        real("bowlRadius", 0.325, meter, Range{0.02, 1}.soft(0.2, 0.5), "Of the ball that the bowl is cut from.");
    Real bowlBottom = real("bowlBottom", 0.2535, meter, Range{0.01, 1}.soft(0.1, 0.32),
                           "Radius of the bowl at the bottom; cut to that of the ball.");
    Real bowlTop = real("bowlTop", 0.32175, meter, Range{0.01, 1}.soft(0.2, 0.5),
                        "Radius of the bowl at the rim, between those of bottom and ball.");
    Count rings = count("rings", 3, {0, 24}, "Around the foot, evenly up its side.");
    Real ringTube =
        real("ringTube", 0.0075, meter, Range{0.0005, 0.05}.soft(0.002, 0.02), "Radius of the rings' tube.");
    Count bars = count("bars", 7, {0, 36}, "Up the side of the foot.");
    Real barRadius =
        real("barRadius", 0.01, meter, Range{0.0005, 0.05}.soft(0.002, 0.025), "Of the bars' round section.");
    Real reliefBlend = real("reliefBlend", 0.00875, meter, Range{0, 0.1}.soft(0, 0.03),
                            "Width of the fillet where bars cross rings; 0 joins them hard.");
    Real footBlend =
        real("footBlend", 0.0075, meter, Range{0, 0.1}.soft(0, 0.03), "Width of the fillet between them and the foot.");

    /// Indexed by layer: lowerLobes, ... upperLobes, ...
    std::vector<CreamRows> layers =
        groups("layers", layerElements, [this](std::size_t i) { return layer(layerInitials[i]); });
    Group joints = group("Joints of the cream");
    Real layerBlend =
        real("layerBlend", 0.05, meter, Range{0, 0.5}.soft(0, 0.15), "Width of the fillet between the two layers.");
    Real waferBlend = real("waferBlend", 0.01, meter, Range{0, 0.5}.soft(0, 0.1),
                           "Width of the fillet between cream and wafer: wide runs down.");

    /// Indexed by candy: candy1X, ... candy10Bob.
    std::vector<CandyRows> candies =
        groups("candies", candyElements, [this](std::size_t i) { return candy(candyInitials[i]); });

    Group sprinkling = group("Sprinkles");
    Count sprinkles =
        count("sprinkles", 0, Range{0, 5000}.soft(0, 1500), "Strewn over the cream, each by a seed of its own.");
    Count sprinkleSeed =
        count("sprinkleSeed", 1, {1, 9999}, "Another number strews them elsewhere.", whenLaterAbove("sprinkles", 0));
    Real sprinkleLength = real("sprinkleLength", 0.034, meter, Range{0.001, 0.2}.soft(0.005, 0.08), "Of a sprinkle.",
                               whenLaterAbove("sprinkles", 0));
    Real sprinkleThickness = real("sprinkleThickness", 0.010, meter, Range{0.001, 0.05}.soft(0.004, 0.02),
                                  "Of a sprinkle.", whenLaterAbove("sprinkles", 0));
    Choice<SprinkleColors> sprinkleColors =
        choice("sprinkleColors", SprinkleColors::candies, {"candies", "one"},
               "Whether they have the colors of the first five candies, or one.", whenLaterAbove("sprinkles", 0));
    Color sprinkleColor =
        color("sprinkleColor", {0.16, 0.055, 0.022}, "Of all sprinkles.", when(sprinkleColors, SprinkleColors::one));

    Group surface = group("Material");
    Choice<SdfMaterial> material =
        choice("material", SdfMaterial::opaque, {"opaque", "glass"},
               "Opaque reflects; glass also refracts, in and out through every wall.", whenLater("lighting", 0));
    Color glassColor = color("glassColor", {0.86, 0.95, 0.97}, "What 10 cm of the glass leave of white.",
                             when(material, SdfMaterial::glass));
    Real refractiveIndex = real("refractiveIndex", 1.5, none, Range{1, 3}.soft(1, 2.4),
                                "Of the glass: 1 bends nothing, 2.4 is diamond.", when(material, SdfMaterial::glass));
    Color waferColor = color("waferColor", {0.7156, 0.3814, 0.0865}, "Of the wafer.");
    Real waferRoughness = real("waferRoughness", 1.0, none, {0, 1}, "Of the wafer: 0 is a mirror, 1 is chalk.");
    Real creamRoughness = real("creamRoughness", 0.25, none, {0, 1}, "Of the cream: low melts, high is dry.");
    Real candyRoughness = real("candyRoughness", 0.65, none, {0, 1}, "Of candies and sprinkles.");
    Real metalness = real("metalness", 0.0, none, {0, 1}, "0 is edible, 1 is bare metal in these colors.");

    Group stand = group("Plinth");
    Toggle plinth = toggle("plinth", true, "Stand it on a plinth.");
    Color plinthColor = color("plinthColor", {0.36, 0.31, 0.26}, "Of the plinth.", when(plinth));
    Real plinthRoughness = real("plinthRoughness", 0.55, none, {0, 1}, "Of the plinth.", when(plinth));

    Group ownLight = group("Light");
    Choice<IceCreamLighting> lighting =
        choice("lighting", IceCreamLighting::hall, {"hall", "as in the source"},
               "Lit by what is around it, or by the one sun, the ambient light and the fog of the source.");
    Real lamp = real("lamp", 1.1, none, Range{0, 100}.soft(0, 8), "Strength of the lamp before the niche.",
                     when(lighting, IceCreamLighting::hall));
    Color lampColor = color("lampColor", {1.0, 0.88, 0.74}, "Of that lamp.", whenAbove(lamp, 0));
    Direction lampDirection =
        direction("lampDirection", {-0.85, 0.62, 0.42}, "Where it hangs, seen from the ice cream.", whenAbove(lamp, 0));
    Choice<IceCreamHighlight> highlight = choice(
        "highlight", IceCreamHighlight::blinnPhong, {"GGX", "Blinn-Phong"},
        "What roughness means for the source's sun: a lobe of microfacets, or the exponent 2^(10 (1 - roughness)).",
        when(lighting, IceCreamLighting::source));
    Direction sourceSun = direction("sourceSun", {-16, 12, 4}, "Where the source's sun stands.",
                                    when(lighting, IceCreamLighting::source));
    Color sourceSunColor =
        color("sourceSunColor", {1.0, 0.7, 0.5}, "Of that sun.", when(lighting, IceCreamLighting::source));
    Real sourceSunStrength = real("sourceSunStrength", 1 / 1.2, none, Range{0, 100}.soft(0, 3), "Of that sun.",
                                  when(lighting, IceCreamLighting::source));
    Color sourceAmbient = color("sourceAmbient", {0.2, 0.1, 0.0}, "Light from everywhere, more of it from above.",
                                when(lighting, IceCreamLighting::source));
    Count occlusionTaps = count("occlusionTaps", 5, {2, 64, logarithmic},
                                "Samples up the normal that darken what is hidden from that light.", quality(64),
                                when(lighting, IceCreamLighting::source) && whenLater("ambientOcclusion", 1));
    Real sourceFog = real("sourceFog", 0.0005, none, Range{0, 10}.soft(0, 0.05),
                          "How fast distance fades to black: light falls by e where this times its cube is 1.",
                          when(lighting, IceCreamLighting::source));
    Toggle ground = toggle("ground", true, "Sand around it, and a black horizon, where it is shown alone.",
                           when(lighting, IceCreamLighting::source));
    Color groundColor =
        color("groundColor", {0.8796, 0.8796, 0.8796}, "Of the sand, before the warm light.", when(ground));

private:
    struct CreamInitial {
        int lobes;
        double radius, height, offsetX, offsetZ, raise, tilt, yaw, twist;
    };
    static constexpr std::array<Element, creamLayerCount> layerElements{
        {{"lower", "Lower layer of cream"}, {"upper", "Upper layer of cream"}}};
    // The reference raises the upper layer by the lower one's height less 0.05, along x and z as well as up.
    static constexpr double raised = 0.4 * 0.5403023058681398;
    static constexpr std::array<CreamInitial, creamLayerCount> layerInitials{{
        {7, 0.16, 0.40, 0.1, 0.3, 0.03, -1.0, std::numbers::pi / 10, 5},
        {5, 0.10, 0.60, 0.06 - raised, 0.3 - raised, 0.03 + raised - 0.05, -0.33, -std::numbers::pi / 3, 6},
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
    // In the reference, z of the first candy is 16 instead of .16, so it is out of sight. The fifth one, at (-.06, 1.1,
    // -.11), is inside the cream there; here it is moved out to the surface.
    static constexpr std::array<CandyInitial, candyCount> candyInitials{{
        {0.12, 1.0, 0.16, red, 1, 0, 0},
        {0.06, 1.2, -0.08, green, 2, 0, 0},
        {-0.16, 0.9, 0.11, blue, 3, 0, 0},
        {-0.2, 0.84, -0.2, yellow, 4, 0, 0},
        {-0.0745, 1.1, -0.1365, pink, 5, 0, 0},
        {0.168, 0.95, -0.156, yellow, 6, 0, 0},
        {0.01, 0.94, 0.19, red, 7, 0, 0},
        // The last three float in the air. In the reference they are a meter from the axis; here they are nearer,
        // because of the walls.
        {0.27, 1.12, 0.36, green, 8, 1, 0.07},
        {-0.46, 1.05, 0.08, pink, 9, 1, 0.05},
        {0.32, 1.32, -0.2, blue, 10, 1, 0.06},
    }};

    CreamRows layer(const CreamInitial& initial)
    {
        CreamRows rows{};
        rows.lobes = count("lobes", initial.lobes, {3, 12}, "Cones around the axis.");
        rows.radius = real("radius", initial.radius, meter, Range{0.01, 0.5}.soft(0.03, 0.3), "Of a cone at its base.");
        rows.height = real("height", initial.height, meter, Range{0.05, 1.5}.soft(0.1, 0.9), "Of a cone.");
        rows.corner = real("corner", 0.03, meter, Range{0, 0.2}.soft(0, 0.08),
                           "Radius of its edges; cut so that a cone is left.");
        rows.offsetX = real("offsetX", initial.offsetX, meter, Range{-0.5, 0.5}, "Where its base is, across.");
        rows.offsetZ =
            real("offsetZ", initial.offsetZ, meter, Range{-0.5, 0.5}, "Where its base is, towards the front.");
        rows.raise = real("raise", initial.raise, meter, Range{-0.5, 1}.soft(-0.2, 0.5),
                          "Of its base above the rim of the bowl.");
        rows.tilt =
            real("tilt", initial.tilt, degree, Range{degrees(-180), degrees(180)}.soft(degrees(-90), degrees(90)),
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
    CandyRows candy(const CandyInitial& initial)
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
};

/// All parameters of the exhibit.
struct IceCreamTable final : IceCreamRows, SdfRows {
    IceCreamTable() : SdfRows(0, when(lighting, IceCreamLighting::source)) {}

    // The hall's sun hardly reaches the niche, but the reference's sun does.
    StudiedRows studied{*this,
                        {{.name = "shadowMethod", .views = {"as in the source"}},
                         {.name = "shadowRays", .with = {{"sunWidth", degrees(10)}}, .views = {"as in the source"}}}};
};

}  // namespace vitrine

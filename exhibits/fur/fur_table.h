#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"

#include <array>
#include <vector>

namespace vitrine::fur {

inline constexpr int furBodyCount = 3;
enum FurBodyIndex : int { furBall, furRoll, furRing };

enum class FurRotation : int { matrixMix, nlerp, slerp };
enum class FurSpring : int { explicitEuler, semiImplicit, closedForm };
enum class FurSilhouette : int { none, fins, byAngle, march };
enum class FurOrder : int { outerFirst, innerFirst };
/// Values as MARKING_NONE and others in shaders/fur/body_block.glsl.
enum class FurMarking : int { none, ticked, stripes, spots };

/// Parameters of the coat of one body.
struct CoatParameters {
    Real length, uniformity;
    Count density;
    Real thickness;
    Color root, tip;
    Choice<FurMarking> marking;
    Color markColor;
    Real markSize;
};

/// All parameters of the furry bodies. Lengths are in meters, or in strand lengths where the description says so.
struct FurTable final : Parameters {
    /// Indexed by FurBodyIndex: ballLength, ... rollLength, ... ringLength, ...
    std::vector<CoatParameters> coats =
        groups("coats", coatElements, [this](std::size_t body) { return coat(body, coatInitials[body]); });
    Group ring = group("Coat of the ring");
    File ringModel =
        file("ringModel",
             "Path of a glTF object that wears the ring's coat in place of the ring; models/teddy.glb is supplied.",
             extensions("glb gltf"));

    Group strands = group("Strands");
    Real strandRoundness = real(
        "strandRoundness", 0.4, none, {0, 0.999},
        "Shape of the strands along their length: 0 tapers them to a needle, high keeps them thick with a blunt tip.");
    Real thicknessVariation = real("thicknessVariation", 0.0, none, {0, 1},
                                   "Variation of thickness between strands: at 0 all have the coat's thickness, at 1 "
                                   "they range from that down to none.");
    Real tipSoftness = real("tipSoftness", 0.45, none, {0, 1},
                            "Share of a strand's length that fades out towards its tip: 0 is opaque to the end, at 1 "
                            "the whole strand lets light through.");
    Real distanceAttenuation = real("distanceAttenuation", 0.5, none, Range{0.01, 3}.soft(0.3, 3),
                                    "Distribution of the shells over the length of the fur: below 1 more of them lie "
                                    "near the tips, above 1 near the skin.");
    Real curvature = real("curvature", 0.8, none, Range{0, 10}.soft(0, 5),
                          "Curvature of the strands: 0 leans them like straight sticks, high bends only the tips.");
    Real comb = real("comb", 0.6, none, Range{0, 10}.soft(0, 2),
                     "Strength of the combing to one side: 0 leaves strands upright, high lays them flat.");
    Real disorder = real("disorder", 0.22, none, Range{0, 10}.soft(0, 2),
                         "Strength of random swirls in the coat: 0 is even, high is tousled.");
    Real clump =
        real("clump", 0.75, none, {0, 0.95},
             "Gathering of strands into tufts towards their tips: 0 is freshly brushed, high looks wet.", essential());
    Real clumpSize = real("clumpSize", 10.0, none, Range{1, 50}.soft(2, 20),
                          "Number of strands along one side of a tuft: low makes fine tufts, high makes broad ones.",
                          whenAbove(clump, 0) || whenLaterAbove("curl", 0));
    Real curl = real("curl", 0.0, none, Range{0, 1}.soft(0, 0.3),
                     "Radius of the curls of a tuft, in strand lengths: 0 is straight.");
    Real curlTurns = real("curlTurns", 1.5, none, Range{0, 20}.soft(0, 5),
                          "Number of turns of a curl from skin to tip.", whenAbove(curl, 0));

    Group light = group("Light");
    Real occlusionAttenuation =
        real("occlusionAttenuation", 1.2, none, {0, 5},
             "Darkness between the roots: 0 is not darkened, high darkens strands all the way up.");
    Real occlusionBias =
        real("occlusionBias", 0.05, none, {0, 1},
             "Share of the light that reaches even the roots: 0 leaves them black, 1 removes the darkening.");
    Real contrast =
        real("contrast", 0.8, none, {0, 1},
             "Darkening of the side of the coat that faces away from the room's light: 0 lights all sides alike.");
    Real selfShadow =
        real("selfShadow", 0.8, none, Range{0, 10}.soft(0, 3),
             "Absorption of sunlight on its way into the coat: 0 casts no shadow on the fur, high darkens it quickly.",
             essential());
    Real sheen = real("sheen", 0.5, none, Range{0, 4}.soft(0, 2), "Gloss along the strands: 0 is wool, high is silk.");
    Real rimLight =
        real("rimLight", 1.0, none, Range{0, 8}.soft(0, 3),
             "Amount of light that comes through the fringe from behind: 0 is none, high gives a bright rim.");
    Real gradient = real(
        "gradient", 0.8, none, Range{0.05, 10, logarithmic}.soft(0.2, 4),
        "Position along the strand where the color changes from root to tip: low near the root, high near the tip.");
    Real colorVariation =
        real("colorVariation", 0.5, none, {0, 1}, "Variation of color between strands: at 0 all have the same color.");

    Real lamp = real("lamp", 1.6, none, Range{0, 1000}.soft(0, 6),
                     "Strength of the lamp in the vault above the pit: 0 switches it off.");
    Direction lampDirection =
        direction("lampDirection", {-0.62, 0.62, -0.48}, "Direction from the pit to the lamp.", whenAbove(lamp, 0));

    Group floor = group("Floor of the pit");
    Real rugRadius = real("rugRadius", 1.4, meter, Range{0, 1.6}.soft(0, 1.55),
                          "Radius of the braided rug on the floor of the pit; 0 leaves the floor bare.");
    Color rugColor =
        color("rugColor", {0.035, 0.062, 0.11}, "Color of the colored braids of the rug.", whenAbove(rugRadius, 0));

    Group jumping = group("Jump");
    Real jump = real("jump", 3.1, none, Range{0, 8}.soft(1, 5),
                     "Speed at which the bodies leave the ground when the button is pressed, in meters per second.",
                     whenLater("byHand", 0));
    Count toss = count("toss", 2, Range{1, 9999}.soft(1, 20),
                       "Seed of the random directions and spins of a jump: the same number gives the same jump.",
                       whenLater("byHand", 0));
    Real frozenAt = real("frozenAt", 0.0, second, Range{0, 10}.soft(0, 5),
                         "Time after a jump at which the bodies are frozen; 0 lets them move with button and clock.",
                         reads(0, "off"), whenLater("byHand", 0));
    Real bouncePeriod = real("bouncePeriod", 0.0, second, Range{0, 60}.soft(0, 12),
                             "Time between automatic jumps; 0 lets the bodies jump only when the button is pressed.",
                             reads(0, "off"), whenLater("byHand", 0) && when(frozenAt, 0));
    Real growth =
        real("growth", 0.05, meter, Range{0, 0.2}.soft(0, 0.12),
             "Amount by which the ball's radius grows and shrinks; 0 keeps its size.", whenLater("byHand", 0));
    Real growthRate =
        real("growthRate", 0.7, hertz, Range{0, 20}.soft(0, 3), "Rate at which the ball grows and shrinks; 0 stops it.",
             whenLater("byHand", 0) && whenAbove(growth, 0));
    Toggle growing =
        toggle("growing", false, "Whether the ball grows and shrinks all the time; otherwise only during a jump.",
               whenLater("byHand", 0) && whenAbove(growth, 0) && whenAbove(growthRate, 0));

    Group motion = group("Motion of the fur");
    Real frequency = real("frequency", 2.2, hertz, Range{0, 1000}.soft(0.3, 12),
                          "Stiffness of the fur as the frequency at which it swings: low sways, high snaps back.",
                          whenLater("byHand", 0), essential());
    Real damping =
        real("damping", 0.3, none, Range{0, 100}.soft(0, 2),
             "Damping of the swinging fur: 0 never stops, 1 stops without overshooting.", whenLater("byHand", 0));
    Real inertia = real("inertia", 0.45, none, Range{0, 100}.soft(0, 3),
                        "Amount by which the fur lags behind when the body starts, stops or spins: 0 follows at once.",
                        whenLater("byHand", 0));
    Real gravity = real("gravity", 0.35, none, Range{0, 20}.soft(0, 3),
                        "Distance by which the tips hang down at rest, in strand lengths.", whenLater("byHand", 0));
    Real airDrag = real("airDrag", 0.22, none, Range{0, 10}.soft(0, 1),
                        "Distance by which the tips trail in moving air, in strand lengths per meter per second.",
                        whenLater("byHand", 0));
    Real strength = real("strength", 1.0, none, Range{0, 10}.soft(0, 3),
                         "Scale of the whole motion of the fur: 0 keeps every strand upright, 1 is as simulated.",
                         whenLater("byHand", 0));
    Real displacementLimit = real("displacementLimit", 2.2, none, Range{0, 100}.soft(0, 5),
                                  "Largest displacement of the tips, in strand lengths.", whenLater("byHand", 0));
    Real rotationLimit =
        real("rotationLimit", degrees(68.755), degree, {0, degrees(180)},
             "Largest angle by which the tips lag behind the rotation of their body; the reference allows 30 degrees.",
             whenLater("byHand", 0));
    Real wind = real("wind", 0.0, none, Range{0, 20}.soft(0, 3),
                     "Strength of the draft over the pit: 0 is still air, above 0 the fur keeps moving.");
    Direction windDirection =
        direction("windDirection", {1, 0, -0.3}, "Direction in which the draft blows.", whenAbove(wind, 0));
    Real gustiness = real("gustiness", 0.5, none, {0, 1},
                          "Unevenness of the draft: 0 is a steady draft that only bends the fur, 1 blows in gusts.",
                          whenAbove(wind, 0));
    Real flattening = real("flattening", 0.75, none, {0, 1},
                           "Compression of the fur where it touches something: 0 carries the body on its tips, 1 lets "
                           "the skin down to the ground.");
    Toggle byHand =
        toggle("byHand", false, "Whether the next four parameters set how the fur lies, while the bodies stand still.");
    Real handX = real("handX", 0.0, none, Range{-20, 20}.soft(-3, 3),
                      "Displacement of the tips to the right, in strand lengths, when set by hand.", when(byHand));
    Real handY = real("handY", -3.0, none, Range{-20, 20}.soft(-3, 3),
                      "Displacement of the tips upwards, in strand lengths, when set by hand.", when(byHand));
    Real handZ =
        real("handZ", 0.0, none, Range{-20, 20}.soft(-3, 3),
             "Displacement of the tips towards the entrance, in strand lengths, when set by hand.", when(byHand));
    Real handRotation =
        real("handRotation", 0.0, degree, Range{degrees(-180), degrees(180)},
             "Rotation of the tips about the axis towards the entrance, when set by hand.", when(byHand));

    Group accuracy = group("Accuracy");
    // Measured at 640 x 360: with 10 shells, 5 % of the outline are wrong with marching between them and 33 % without.
    // With 64 shells without marching, drawn from inside out, 12.7 times as many samples pass as with the initial
    // values, for the same error.
    Count shellCount =
        count("shellCount", 18, {1, 256, logarithmic},
              "Number of layers (shells) drawn from tip to skin: few show gaps, many are more accurate and cost more.",
              quality(256), essential());
    Count samplesBetween = count(
        "samplesBetween", 16, {1, 32},
        "Largest number of cells of the strand lattice that a ray tests between two shells where it grazes the coat.",
        quality(32), whenLater("silhouette", static_cast<double>(FurSilhouette::march)));
    Choice<FurSilhouette> silhouette =
        choice("silhouette", FurSilhouette::march, {"none", "fins", "by angle", "march"},
               "Method that fills the gaps between shells seen from the side: nothing, fins along the edges, more "
               "shells at oblique angles, or ray marching between the shells.",
               quality(FurSilhouette::march), essential());
    Choice<FurOrder> drawOrder = choice("drawOrder", FurOrder::outerFirst, {"outer first", "inner first"},
                                        "Order in which shells are drawn: outer shells first hide the inner ones early "
                                        "and save work. The picture is the same.",
                                        exactAt(FurOrder::outerFirst));
    Toggle levelOfDetail = toggle("levelOfDetail", true,
                                  "Whether fewer shells are drawn where the coat is far away and small.", exactAt(0));
    Choice<FurRotation> rotationModel = choice("rotationModel", FurRotation::slerp, {"matrix mix", "nlerp", "slerp"},
                                               "Interpolation of the rotation from root to tip: the matrix mix "
                                               "shortens strands, nlerp turns unevenly, slerp is exact.",
                                               exactAt(FurRotation::slerp));
    Choice<FurSpring> springModel =
        choice("springModel", FurSpring::closedForm, {"explicit Euler", "semi-implicit", "closed form"},
               "Integration method of the springs: explicit Euler gains energy, semi-implicit Euler fails at long time "
               "steps, the closed form is exact.",
               exactAt(FurSpring::closedForm), when(byHand, false));
    Count springRate = count("springRate", 240, {15, 240, logarithmic},
                             "Number of spring steps per second: with few, the two Euler methods fail.", quality(240),
                             when(byHand, false));

    StudiedParameters studied{
        *this,
        {{.name = "shellCount", .lifted = {"levelOfDetail"}},
         {.name = "samplesBetween", .settles = "No ray grazes a shell along this many cells."},
         {.name = "levelOfDetail", .with = {{"shellCount", 256}}},
         {.name = "drawOrder",
          .same = "What lies behind a shell is covered in either order, so that the picture is the same."},
         {.name = "rotationModel", .views = {"spin of 120 degrees"}},
         {.name = "springModel", .views = {"stiff fur in long steps", "landing"}},
         {.name = "springRate",
          .with = {{"springModel", static_cast<double>(FurSpring::semiImplicit)}},
          .views = {"landing"}}}};

private:
    struct CoatInitial {
        double length, uniformity;
        int density;
        double thickness;
        glm::dvec3 root, tip, markColor;
    };
    static constexpr std::array<Element, furBodyCount> coatElements{
        {{"ball", "Coat of the ball"}, {"roll", "Coat of the roll"}, {"ring", "Coat of the ring"}}};
    static constexpr std::array<CoatInitial, furBodyCount> coatInitials{{
        {0.2, 0.35, 60000, 0.0045, {0.24, 0.075, 0.03}, {0.95, 0.58, 0.31}, {0.05, 0.02, 0.01}},
        {0.10, 0.5, 30000, 0.0048, {0.018, 0.022, 0.032}, {0.50, 0.55, 0.62}, {0.03, 0.025, 0.022}},
        {0.075, 0.6, 42000, 0.0042, {0.10, 0.006, 0.016}, {0.78, 0.16, 0.20}, {0.93, 0.80, 0.72}},
    }};

    CoatParameters coat(std::size_t body, const CoatInitial& initial)
    {
        CoatParameters rows{};
        rows.length =
            real("length", initial.length, meter, Range{0, 1}.soft(0, 0.4),
                 "Length of the longest strands of this coat: 0 leaves the bare skin.", essential(body == furBall));
        rows.uniformity = real("uniformity", initial.uniformity, none, {0, 1},
                               "Length of the shortest strands as a share of the longest: at 0 they have no length, at "
                               "1 all are equally long, like a lawn.",
                               whenAbove(rows.length, 0));
        rows.density =
            count("density", initial.density, Range{1, 1000000, logarithmic}.soft(100, 200000),
                  "Number of strands per square meter: low is thin fur, high is dense.", whenAbove(rows.length, 0));
        rows.thickness = real("thickness", initial.thickness, meter, Range{0.0001, 0.1, logarithmic}.soft(0.0005, 0.02),
                              "Thickness of a strand at its root.", whenAbove(rows.length, 0));
        rows.root = color("root", initial.root, "Color of this coat at the skin.");
        rows.tip =
            color("tip", initial.tip, "Color of this coat at the tips of the strands.", whenAbove(rows.length, 0));
        rows.marking = choice("marking", FurMarking::none, {"none", "ticked", "stripes", "spots"},
                              "Marking of this coat in another color: a band below the tip of each strand, stripes "
                              "around the body, or spots like a leopard's.",
                              whenAbove(rows.length, 0));
        const Condition marked = whenNot(rows.marking, FurMarking::none);
        rows.markColor = color("markColor", initial.markColor, "Color of the markings of this coat.", marked);
        rows.markSize = real("markSize", 0.13, meter, Range{0.02, 1, logarithmic}.soft(0.05, 0.4),
                             "Distance between two stripes or spots of this coat.",
                             when(rows.marking, {FurMarking::stripes, FurMarking::spots}));
        return rows;
    }
};

}  // namespace vitrine::fur

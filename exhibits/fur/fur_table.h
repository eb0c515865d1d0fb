#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/studied_rows.h"

#include <array>
#include <vector>

namespace vitrine {

inline constexpr int furBodyCount = 3;
enum FurBodyIndex : int { furBall, furRoll, furRing };

enum class FurRotation : int { matrixMix, nlerp, slerp };
enum class FurSpring : int { explicitEuler, semiImplicit, closedForm };
enum class FurSilhouette : int { none, fins, byAngle, march };
enum class FurOrder : int { outerFirst, innerFirst };

/// Parameters of the coat of one body.
struct CoatRows {
    Real length, uniformity;
    Count density;
    Real thickness;
    Color root, tip;
};

/// All parameters of the furry bodies. Lengths are in meters, or in strand lengths where the description says so.
struct FurTable final : Parameters {
    /// Indexed by FurBodyIndex: ballLength, ... rollLength, ... ringLength, ...
    std::vector<CoatRows> coats =
        groups("coats", coatElements, [this](std::size_t body) { return coat(coatInitials[body]); });
    Group ring = group("Coat of the ring");
    File ringModel = file(
        "ringModel", "A glTF object that wears the ring's coat in place of the ring; models/teddy.glb is one of ours.",
        endings("glb gltf"));

    Group strands = group("Strands");
    Real strandRoundness = real("strandRoundness", 0.55, none, {0, 0.999},
                                "0 tapers every strand like a needle, high leaves it thick with a blunt tip.");
    Real thicknessVariation = real("thicknessVariation", 0.0, none, {0, 1},
                                   "How far strands differ in thickness: 0 makes all as thick as said above, 1 any "
                                   "thickness from that down to none.");
    Real distanceAttenuation =
        real("distanceAttenuation", 0.5, none, Range{0.01, 3}.soft(0.3, 3),
             "How shells are spread: below 1 more of them near the tips, above 1 near the skin.");
    Real curvature = real("curvature", 0.8, none, Range{0, 10}.soft(0, 5),
                          "How late a strand bends: 0 leans like a stick, high bends only the tip.");
    Real comb = real("comb", 0.6, none, Range{0, 10}.soft(0, 2), "How far the coat is combed to one side.");
    Real disorder = real("disorder", 0.22, none, Range{0, 10}.soft(0, 2), "How far it lies in swirls instead.");
    Real clump = real("clump", 0.75, none, {0, 0.95},
                      "How far strands draw together towards their tips: 0 is freshly brushed, high is wet.");
    Real clumpSize = real("clumpSize", 10.0, none, Range{1, 50}.soft(2, 20), "Strands along a side of one tuft.",
                          whenAbove(clump, 0) || whenLaterAbove("curl", 0));
    Real curl = real("curl", 0.0, none, Range{0, 1}.soft(0, 0.3), "Radius of the curls of a tuft, in strand lengths.");
    Real curlTurns =
        real("curlTurns", 1.5, none, Range{0, 20}.soft(0, 5), "Turns of a curl from skin to tip.", whenAbove(curl, 0));

    Group light = group("Light");
    Real occlusionAttenuation = real("occlusionAttenuation", 1.2, none, {0, 5},
                                     "How dark it is between the roots: 0 not at all, high all the way up.");
    Real occlusionBias = real("occlusionBias", 0.05, none, {0, 1}, "Light that reaches even the roots.");
    Real contrast =
        real("contrast", 0.8, none, {0, 1}, "How much darker the coat is on the side away from the room's light.");
    Real selfShadow =
        real("selfShadow", 0.8, none, Range{0, 10}.soft(0, 3), "How fast sunlight fades on its way into the coat.");
    Real sheen = real("sheen", 0.5, none, Range{0, 4}.soft(0, 2), "Gloss along the strands: 0 is wool, high is silk.");
    Real rimLight =
        real("rimLight", 1.0, none, Range{0, 8}.soft(0, 3), "How much light comes through the fringe from behind.");
    Real gradient = real("gradient", 0.8, none, Range{0.05, 10, logarithmic}.soft(0.2, 4),
                         "Where the color changes from root to tip: low near the root, high near the tip.");
    Real colorVariation = real("colorVariation", 0.5, none, {0, 1}, "How far strands differ in color.");

    Real lamp = real("lamp", 1.6, none, Range{0, 1000}.soft(0, 6), "Strength of the lamp in the vault above the pit.");
    Direction lampDirection =
        direction("lampDirection", {-0.62, 0.62, -0.48}, "Where it hangs, seen from the pit.", whenAbove(lamp, 0));

    Group jumping = group("Jump");
    Real jump =
        real("jump", 3.1, none, Range{0, 8}.soft(1, 5),
             "How fast they leave the ground when the button is pressed, in meters a second.", whenLater("byHand", 0));
    Count toss = count("toss", 2, Range{1, 9999}.soft(1, 20),
                       "Which of many ways they are tossed: the same number is the same jump.", whenLater("byHand", 0));
    Real frozenAt =
        real("frozenAt", 0.0, second, Range{0, 10}.soft(0, 5),
             "Shows them so long after a jump and stops the clock there; 0 lets the button and the clock decide.",
             reads(0, "off"), whenLater("byHand", 0));
    Real bouncePeriod = real("bouncePeriod", 0.0, second, Range{0, 60}.soft(0, 12),
                             "Lets them jump by themselves every so often; 0 leaves it to the button.", reads(0, "off"),
                             whenLater("byHand", 0) && when(frozenAt, 0));
    Real growth = real("growth", 0.05, meter, Range{0, 0.2}.soft(0, 0.12),
                       "How much the ball's radius grows and shrinks.", whenLater("byHand", 0));
    Real growthRate = real("growthRate", 0.7, hertz, Range{0, 20}.soft(0, 3), "How often it does so.",
                           whenLater("byHand", 0) && whenAbove(growth, 0));
    Toggle growing = toggle("growing", false, "Grow and shrink all the time, not only while they jump.",
                            whenLater("byHand", 0) && whenAbove(growth, 0) && whenAbove(growthRate, 0));

    Group motion = foldedGroup("Motion of the fur");
    Real frequency = real("frequency", 2.2, hertz, Range{0, 1000}.soft(0.3, 12),
                          "How stiff the fur is: low sways, high snaps back.", whenLater("byHand", 0));
    Real damping = real("damping", 0.3, none, Range{0, 100}.soft(0, 2),
                        "How soon it stops swaying: 0 never, 1 without one overshoot.", whenLater("byHand", 0));
    Real inertia = real("inertia", 0.45, none, Range{0, 100}.soft(0, 3),
                        "How far it lags behind when the body starts, stops or spins.", whenLater("byHand", 0));
    Real gravity = real("gravity", 0.35, none, Range{0, 20}.soft(0, 3), "How far it hangs at rest, in strand lengths.",
                        whenLater("byHand", 0));
    Real airDrag =
        real("airDrag", 0.22, none, Range{0, 10}.soft(0, 1),
             "How far it trails in moving air, in strand lengths for each meter a second.", whenLater("byHand", 0));
    Real strength = real("strength", 1.0, none, Range{0, 10}.soft(0, 3),
                         "How much of all this is seen: 0 keeps every strand upright.", whenLater("byHand", 0));
    Real displacementLimit = real("displacementLimit", 2.2, none, Range{0, 100}.soft(0, 5),
                                  "How far tips may be drawn at most, in strand lengths.", whenLater("byHand", 0));
    Real rotationLimit = real(
        "rotationLimit", degrees(68.755), degree, {0, degrees(180)},
        "How far they may turn less than their body at most; the museum that this exhibit follows allows 30 degrees.",
        whenLater("byHand", 0));
    Real wind =
        real("wind", 0.0, none, Range{0, 20}.soft(0, 3), "Strength of a draft over the pit: it keeps the fur moving.");
    Direction windDirection = direction("windDirection", {1, 0, -0.3}, "Where the draft blows.", whenAbove(wind, 0));
    Real gustiness = real("gustiness", 0.5, none, {0, 1},
                          "How uneven it is: 0 leans on the fur steadily and moves nothing.", whenAbove(wind, 0));
    Real flattening = real("flattening", 0.75, none, {0, 1},
                           "How flat fur is pressed by what it touches: 0 carries the body on its tips, 1 lets the "
                           "skin down to the ground.");
    Toggle byHand =
        toggle("byHand", false, "Set how the fur lies by the four numbers below, and keep the bodies still.");
    Real handX = real("handX", 0.0, none, Range{-20, 20}.soft(-3, 3),
                      "By hand: how far the tips are drawn to the right.", when(byHand));
    Real handY =
        real("handY", -3.0, none, Range{-20, 20}.soft(-3, 3), "By hand: how far they are drawn up.", when(byHand));
    Real handZ = real("handZ", 0.0, none, Range{-20, 20}.soft(-3, 3),
                      "By hand: how far they are drawn towards the entrance.", when(byHand));
    Real handRotation = real("handRotation", 0.0, degree, Range{degrees(-180), degrees(180)},
                             "By hand: how far they are turned about the axis towards the entrance.", when(byHand));

    Group accuracy = foldedGroup("Accuracy");
    // Measured at 640 x 360: with 10 shells, 5 % of the outline are wrong with marching between them and 33 % without.
    // With 64 shells without marching, drawn from inside out, 12.7 times as many samples pass as with the initial
    // values, for the same error.
    Count shellCount = count("shellCount", 16, {1, 256, logarithmic}, "Layers drawn from tip to skin.", quality(256));
    Count samplesBetween =
        count("samplesBetween", 16, {1, 32},
              "Cells of the strands' lattice at most that a ray looks into at each shell, where it grazes it.",
              quality(32), whenLater("silhouette", static_cast<double>(FurSilhouette::march)));
    Choice<FurSilhouette> silhouette =
        choice("silhouette", FurSilhouette::march, {"none", "fins", "by angle", "march"},
               "What fills the gaps between shells seen from the side: nothing, fins along the edges, more shells "
               "where they are seen at an angle, or a march from shell to shell.",
               quality(FurSilhouette::march));
    Choice<FurOrder> drawOrder =
        choice("drawOrder", FurOrder::outerFirst, {"outer first", "inner first"},
               "Outer shells first hide what is behind them before it is drawn; the picture is the same.",
               exactAt(FurOrder::outerFirst));
    Toggle levelOfDetail =
        toggle("levelOfDetail", true, "Fewer shells where the coat is far away and small.", exactAt(0));
    Choice<FurRotation> rotationModel = choice("rotationModel", FurRotation::slerp, {"matrix mix", "nlerp", "slerp"},
                                               "How a strand turns from root to tip: the mix of matrices shortens it, "
                                               "nlerp hurries in the middle, slerp does neither.",
                                               exactAt(FurRotation::slerp));
    Choice<FurSpring> springModel =
        choice("springModel", FurSpring::closedForm, {"explicit Euler", "semi-implicit", "closed form"},
               "How the springs are stepped: the first gains energy, the second fails when steps are long, the third "
               "is exact.",
               exactAt(FurSpring::closedForm), when(byHand, false));
    Count springRate =
        count("springRate", 240, {15, 240, logarithmic}, "Spring steps a second: few make the first two methods fail.",
              quality(240), when(byHand, false));

    StudiedRows studied{
        *this,
        {{.name = "shellCount", .lifted = {"levelOfDetail"}},
         {.name = "samplesBetween", .settles = "No ray grazes a shell along so many cells."},
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
        glm::dvec3 root, tip;
    };
    static constexpr std::array<Element, furBodyCount> coatElements{
        {{"ball", "Coat of the ball"}, {"roll", "Coat of the roll"}, {"ring", "Coat of the ring"}}};
    static constexpr std::array<CoatInitial, furBodyCount> coatInitials{{
        {0.2, 0.35, 60000, 0.0045, {0.24, 0.075, 0.03}, {0.95, 0.58, 0.31}},
        {0.10, 0.5, 30000, 0.0048, {0.018, 0.022, 0.032}, {0.50, 0.55, 0.62}},
        {0.075, 0.6, 42000, 0.0042, {0.10, 0.006, 0.016}, {0.78, 0.16, 0.20}},
    }};

    CoatRows coat(const CoatInitial& initial)
    {
        CoatRows rows{};
        rows.length = real("length", initial.length, meter, Range{0, 1}.soft(0, 0.4),
                           "Of its longest strands: 0 leaves the bare skin.");
        rows.uniformity = real("uniformity", initial.uniformity, none, {0, 1},
                               "Length of its shortest strands: 0 is nothing, 1 is a lawn, all as long as the longest.",
                               whenAbove(rows.length, 0));
        rows.density = count("density", initial.density, Range{1, 1000000, logarithmic}.soft(100, 200000),
                             "Strands on a square meter.", whenAbove(rows.length, 0));
        rows.thickness = real("thickness", initial.thickness, meter, Range{0.0001, 0.1, logarithmic}.soft(0.0005, 0.02),
                              "Of a strand, at its root.", whenAbove(rows.length, 0));
        rows.root = color("root", initial.root, "Of its fur at the skin.");
        rows.tip = color("tip", initial.tip, "Of its fur at the tips.", whenAbove(rows.length, 0));
        return rows;
    }
};

}  // namespace vitrine

#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"

#include <memory>
#include <vector>

namespace vitrine::scenes {

struct ShownScene;

enum class SceneLook : int { scene, physical, reference };
enum class SceneShadow : int { look, none, hard, classic, improved, signedDistance, area };
enum class SceneOcclusion : int { look, none, taps, hemisphere, cones };
enum class SceneHeatMap : int { none, steps, evaluations, normals, shapes };
enum class SceneEvaluation : int { automatic, near, shapes };

/// Parameters of the exhibit with the scene behind the frame. The parameters of a scene file are appended.
struct SdfScenesTable final : Parameters {
    /// Makes the parameters for a scene; null: the initial scene, without parameters of its own.
    explicit SdfScenesTable(std::shared_ptr<const ShownScene> = {});

    Group show = group("Display");
    File scene =
        file("scene", "Path of a scene of shapes (JSON); its format is described in assets/scenes/scene.schema.json.",
             extensions("json"), addsParameters(), inAssetFolder("scenes"), essential());
    File document = this->Parameters::document(
        "document", scene,
        "The edited scene (JSON) with all changes that are not in its file yet. Resetting it discards them.");
    Choice<SceneLook> look = choice("look", SceneLook::scene, {"as the scene says", "physically based", "reference"},
                                    "Shading of the scene: as set in its file, physically based (metal, glaze and "
                                    "glass), or by Phong's formulas as in the reference.",
                                    essential());
    Toggle animate = toggle("animate", false, "Whether time runs; it shows only in scenes in which something moves.");
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 20),
                       "Time that is shown, or at which the animation starts.");
    Real orbit = real("orbit", 0, degree, Range{degrees(-3600), degrees(3600)}.soft(degrees(-180), degrees(180)),
                      "Angle of the camera around its target.");
    Real orbitSpeed = real("orbitSpeed", 0, degree, Range{degrees(-360), degrees(360)}.soft(degrees(-30), degrees(30)),
                           "Speed of the camera around its target, per second: 0 stands still.");

    Group light = group("Light");
    Real brightness = real("brightness", 1, none, Range{0.01, 100, logarithmic}.soft(0.1, 10),
                           "Brightness of the whole picture, as a factor: 1 leaves it as it is.");
    Count bounces = count("bounces", 4, {0, 4},
                          "Largest number of reflections along a ray: 0 shows none. A scene may limit it further.",
                          quality(4), essential());
    Choice<SceneShadow> shadowMethod =
        choice("shadowMethod", SceneShadow::look,
               {"as the look has it", "none", "hard", "classic", "improved", "signed", "area"},
               "Method of the shadows between shapes: the one that belongs to the look, none, one ray (hard), three "
               "estimates of soft shadows from one ray, or many rays (area).",
               quality(SceneShadow::area), essential());
    Count shadowRays =
        count("shadowRays", 16, {1, 64, logarithmic},
              "Number of rays over each light, for the area method: few are noisy, many cost more.", quality(64),
              when(shadowMethod, SceneShadow::area) || rightIs("rightShadowMethod", SceneShadow::area));
    Real lampSize = real("lampSize", 0.1, meter, Range{0, 100}.soft(0, 1),
                         "Radius of the scene's point lights: large gives soft shadows and wide highlights.",
                         whenNot(look, SceneLook::reference) ||
                             when(shadowMethod, {SceneShadow::classic, SceneShadow::improved,
                                                 SceneShadow::signedDistance, SceneShadow::area}) ||
                             rightIs("rightShadowMethod", SceneShadow::classic) ||
                             rightIs("rightShadowMethod", SceneShadow::improved) ||
                             rightIs("rightShadowMethod", SceneShadow::signedDistance) ||
                             rightIs("rightShadowMethod", SceneShadow::area));
    Choice<SceneOcclusion> occlusionMethod =
        choice("occlusionMethod", SceneOcclusion::look, {"as the look has it", "none", "5 taps", "hemisphere", "cones"},
               "Method of ambient occlusion: the one that belongs to the look, none, 5 taps along the normal, rays "
               "over the hemisphere, or cones.",
               quality(SceneOcclusion::hemisphere), essential());
    Count occlusionRays = count(
        "occlusionRays", 32, {1, 512, logarithmic},
        "Number of rays over the hemisphere, denser along the normal: few are noisy, many cost more.", quality(512),
        when(occlusionMethod, SceneOcclusion::hemisphere) ||
            rightIs("rightOcclusionMethod", SceneOcclusion::hemisphere));
    Real occlusionRange =
        real("occlusionRange", 1.5, meter, Range{0.001, 1000, logarithmic}.soft(0.05, 20),
             "Distance beyond which shapes cause no ambient occlusion; the reference has no such limit.",
             when(occlusionMethod, {SceneOcclusion::taps, SceneOcclusion::hemisphere, SceneOcclusion::cones}) ||
                 (when(occlusionMethod, SceneOcclusion::look) && whenNot(look, SceneLook::reference)) ||
                 rightIs("rightOcclusionMethod", SceneOcclusion::taps) ||
                 rightIs("rightOcclusionMethod", SceneOcclusion::hemisphere) ||
                 rightIs("rightOcclusionMethod", SceneOcclusion::cones) ||
                 (rightIs("rightOcclusionMethod", SceneOcclusion::look) && whenNot(look, SceneLook::reference)));

    Group accuracy = group("Accuracy");
    Real hitTolerance = real(
        "hitTolerance", 1, none, Range{0.001, 64, logarithmic}.soft(0.05, 16),
        "Distance at which a ray counts as a hit, in half pixels at that depth: low is accurate, high saves steps.",
        quality(0.001));
    Count stepLimit = count("stepLimit", 160, {1, 512, logarithmic},
                            "Largest number of steps of a ray; towards a light at most 128.", quality(512));
    Real normalStep =
        real("normalStep", 0.0005, meter, Range{1e-7, 0.1, logarithmic}.soft(1e-6, 0.02),
             "Step of the finite differences for normals: too small suffers from rounding, too large rounds creases.",
             quality(0.0005));

    Group halves = group("Split view");
    Toggle split =
        toggle("split", false, "Whether the picture is split into two halves; the right one has its own parameters.");
    Real divider = real("divider", 0.5, none, {0, 1},
                        "Position of the boundary between the halves: 0 is the left edge of the opening, 1 the right.",
                        when(split));
    Choice<SceneShadow> rightShadowMethod =
        choice("rightShadowMethod", SceneShadow::none,
               {"as the look has it", "none", "hard", "classic", "improved", "signed", "area"},
               "Method for shadows in the right half of a split view.", when(split));
    Choice<SceneOcclusion> rightOcclusionMethod = choice(
        "rightOcclusionMethod", SceneOcclusion::look, {"as the look has it", "none", "5 taps", "hemisphere", "cones"},
        "Method for occlusion in the right half of a split view.", when(split));
    Count rightBounces = count("rightBounces", 4, {0, 4},
                               "Number of mirror reflections in the right half of a split view.", when(split));
    Choice<SceneEvaluation> rightEvaluation =
        choice("rightEvaluation", SceneEvaluation::automatic, {"automatic", "what is near", "every shape"},
               "Method of evaluating the field in the right half of a split view.", when(split));
    Count rightStepLimit = count("rightStepLimit", 160, {1, 512, logarithmic},
                                 "Largest number of steps of a ray in the right half of a split view.", when(split));
    Real rightHitTolerance = real("rightHitTolerance", 1, none, Range{0.001, 64, logarithmic}.soft(0.05, 16),
                                  "Hit tolerance in the right half of a split view, in half pixels.", when(split));

    Group costs = group("Costs");
    Choice<SceneHeatMap> heatMap =
        choice("heatMap", SceneHeatMap::none, {"none", "steps", "evaluations", "normals", "shapes"},
               "Quantity by which the scene is colored: the steps, evaluations or shape evaluations that it cost, or "
               "its normals.",
               essential());
    Real heatScale = real("heatScale", 64, none, Range{1, 4096, logarithmic}.soft(8, 512),
                          "Count that the heat map shows in white: low brings out small costs, high large ones.",
                          when(heatMap, {SceneHeatMap::steps, SceneHeatMap::evaluations, SceneHeatMap::shapes}));
    Choice<SceneEvaluation> evaluation = choice(
        "evaluation", SceneEvaluation::automatic, {"automatic", "what is near", "every shape"},
        "Shapes that the shader evaluates at a point: those that matter there, from lists of cells, or all of them.",
        exactAt(SceneEvaluation::shapes));
    StudiedParameters studied{
        *this,
        {{.name = "bounces", .settles = "The scene asks for fewer mirror images of mirror images."},
         {.name = "hitTolerance", .lifted = {"stepLimit"}},
         {.name = "stepLimit", .settles = "Rays end before they have taken this many steps."},
         {.name = "normalStep", .settles = "Steps of half and of double that length give the same normals."}}};

    const std::shared_ptr<const ShownScene> shown;
    std::vector<Real> ofScene;  ///< Parameters of the scene, in their order.

private:
    /// Returns the condition that there is a right half, and a parameter of it has this value.
    template <typename Value> [[nodiscard]] static Condition rightIs(std::string_view row, Value value)
    {
        return whenLater("split", 1) && whenLater(row, static_cast<double>(value));
    }
};

/// Returns the values for drawing the right half: its own parameters replace those of the whole picture.
[[nodiscard]] ParameterValues rightHalf(const SdfScenesTable&, ParameterValues);

}  // namespace vitrine::scenes

#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/studied_rows.h"

#include <memory>
#include <vector>

namespace vitrine {

namespace scenes {
struct ShownScene;
}

enum class SceneLook : int { scene, ours, source };
enum class SceneShadow : int { look, none, hard, classic, improved, signedDistance, area };
enum class SceneOcclusion : int { look, none, taps, hemisphere, cones };
enum class SceneHeatMap : int { none, steps, evaluations, normals, shapes };
enum class SceneEvaluation : int { automatic, near, shapes };

/// Parameters of the exhibit with the scene behind the frame. The parameters of a scene file are appended.
struct SdfScenesTable final : Parameters {
    /// Makes the parameters for a scene; null: the initial scene, without parameters of its own.
    explicit SdfScenesTable(std::shared_ptr<const scenes::ShownScene> = {});

    Group show = group("On show");
    File scene = file("scene", "A scene of shapes, as JSON: assets/scenes/scene.schema.json says what may stand in it.",
                      endings("json"), givesRows(), shippedIn("scenes"));
    File document = this->Parameters::document(
        "document", scene, "The scene as it was edited here, as JSON: what is not in its file yet. Reset gives it up.");
    Choice<SceneLook> look =
        choice("look", SceneLook::scene, {"as the scene says", "ours", "as in the source"},
               "How it is lit: by metal, glaze and glass in the light around them, or by Phong's formulas.");
    Toggle animate = toggle("animate", false, "Let time run, in scenes in which something moves.");
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 20), "The moment that is shown, or begun with.");
    Real orbit = real("orbit", 0, degree, Range{degrees(-3600), degrees(3600)}.soft(degrees(-180), degrees(180)),
                      "How far the camera has gone around what it looks at.");
    Real orbitSpeed = real("orbitSpeed", 0, degree, Range{degrees(-360), degrees(360)}.soft(degrees(-30), degrees(30)),
                           "How far it goes in a second.");

    Group light = group("Light");
    Real brightness = real("brightness", 1, none, Range{0.01, 100, logarithmic}.soft(0.1, 10), "Of the whole picture.");
    Count bounces =
        count("bounces", 4, {0, 4}, "Mirror images of mirror images, at most; a scene may ask for fewer.", quality(4));
    Choice<SceneShadow> shadowMethod =
        choice("shadowMethod", SceneShadow::look,
               {"as the look has it", "none", "hard", "classic", "improved", "signed", "area"},
               "How shapes shade each other: one ray, three kinds of estimate from one ray, or many rays.",
               quality(SceneShadow::area));
    Count shadowRays =
        count("shadowRays", 16, {1, 64, logarithmic}, "Rays over each light, for the area method.", quality(64),
              when(shadowMethod, SceneShadow::area) || rightIs("rightShadowMethod", SceneShadow::area));
    Real lampSize = real("lampSize", 0.1, meter, Range{0, 100}.soft(0, 1),
                         "Radius of the scene's points of light: wide ones give soft shadows and wide highlights.",
                         whenNot(look, SceneLook::source) ||
                             when(shadowMethod, {SceneShadow::classic, SceneShadow::improved,
                                                 SceneShadow::signedDistance, SceneShadow::area}) ||
                             rightIs("rightShadowMethod", SceneShadow::classic) ||
                             rightIs("rightShadowMethod", SceneShadow::improved) ||
                             rightIs("rightShadowMethod", SceneShadow::signedDistance) ||
                             rightIs("rightShadowMethod", SceneShadow::area));
    Choice<SceneOcclusion> occlusionMethod =
        choice("occlusionMethod", SceneOcclusion::look, {"as the look has it", "none", "5 taps", "hemisphere", "cones"},
               "How much of the light around a point shapes keep away: up the normal, or by rays or cones around it.",
               quality(SceneOcclusion::hemisphere));
    Count occlusionRays = count("occlusionRays", 32, {1, 512, logarithmic},
                                "Rays of the hemisphere, more of them along the normal.", quality(512),
                                when(occlusionMethod, SceneOcclusion::hemisphere) ||
                                    rightIs("rightOcclusionMethod", SceneOcclusion::hemisphere));
    Real occlusionRange =
        real("occlusionRange", 1.5, meter, Range{0.001, 1000, logarithmic}.soft(0.05, 20),
             "What is farther away keeps no light away. The source knows no such limit.",
             when(occlusionMethod, {SceneOcclusion::taps, SceneOcclusion::hemisphere, SceneOcclusion::cones}) ||
                 (when(occlusionMethod, SceneOcclusion::look) && whenNot(look, SceneLook::source)) ||
                 rightIs("rightOcclusionMethod", SceneOcclusion::taps) ||
                 rightIs("rightOcclusionMethod", SceneOcclusion::hemisphere) ||
                 rightIs("rightOcclusionMethod", SceneOcclusion::cones) ||
                 (rightIs("rightOcclusionMethod", SceneOcclusion::look) && whenNot(look, SceneLook::source)));

    Group accuracy = foldedGroup("Accuracy");
    Real hitTolerance = real("hitTolerance", 1, none, Range{0.001, 64, logarithmic}.soft(0.05, 16),
                             "How near a ray must come to a surface, in half pixels at that distance.", quality(0.001));
    Count stepLimit = count("stepLimit", 160, {1, 512, logarithmic},
                            "Steps that a ray may take; towards a light at most 128.", quality(512));
    Real normalStep =
        real("normalStep", 0.0005, meter, Range{1e-7, 0.1, logarithmic}.soft(1e-6, 0.02),
             "Step of the differences that give the normal: small drowns in rounding, large rounds creases.",
             quality(0.0005));

    Group halves = foldedGroup("Two halves");
    Toggle split = toggle("split", false, "Divide the picture in two halves, the right one with settings of its own.");
    Real divider =
        real("divider", 0.5, none, {0, 1}, "Where the right half begins, as a share of the opening.", when(split));
    Choice<SceneShadow> rightShadowMethod =
        choice("rightShadowMethod", SceneShadow::none,
               {"as the look has it", "none", "hard", "classic", "improved", "signed", "area"},
               "The shadow method of the right half.", when(split));
    Choice<SceneOcclusion> rightOcclusionMethod = choice(
        "rightOcclusionMethod", SceneOcclusion::look, {"as the look has it", "none", "5 taps", "hemisphere", "cones"},
        "The occlusion method of the right half.", when(split));
    Count rightBounces = count("rightBounces", 4, {0, 4}, "The bounces of the right half.", when(split));
    Choice<SceneEvaluation> rightEvaluation =
        choice("rightEvaluation", SceneEvaluation::automatic, {"automatic", "what is near", "every shape"},
               "The evaluation of the right half.", when(split));
    Count rightStepLimit =
        count("rightStepLimit", 160, {1, 512, logarithmic}, "The step limit of the right half.", when(split));
    Real rightHitTolerance = real("rightHitTolerance", 1, none, Range{0.001, 64, logarithmic}.soft(0.05, 16),
                                  "The hit tolerance of the right half.", when(split));

    Group costs = group("Costs");
    Choice<SceneHeatMap> heatMap =
        choice("heatMap", SceneHeatMap::none, {"none", "steps", "evaluations", "normals", "shapes"},
               "Color the scene by what it cost, or by what was found.");
    Real heatScale =
        real("heatScale", 64, none, Range{1, 4096, logarithmic}.soft(8, 512), "The count that is shown white.",
             when(heatMap, {SceneHeatMap::steps, SceneHeatMap::evaluations, SceneHeatMap::shapes}));
    Choice<SceneEvaluation> evaluation = choice(
        "evaluation", SceneEvaluation::automatic, {"automatic", "what is near", "every shape"},
        "Shapes that the shader evaluates at a point: those that matter there, from lists of cells, or all of them.",
        exactAt(SceneEvaluation::shapes));
    StudiedRows studied{
        *this,
        {{.name = "bounces", .settles = "The scene asks for fewer mirror images of mirror images."},
         {.name = "hitTolerance", .lifted = {"stepLimit"}},
         {.name = "stepLimit", .settles = "Rays end before they have taken so many steps."},
         {.name = "normalStep", .settles = "Steps of half and of double that length give the same normals."}}};

    const std::shared_ptr<const scenes::ShownScene> shown;
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

}  // namespace vitrine

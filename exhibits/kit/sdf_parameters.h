#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"

#include <optional>

namespace vitrine {

enum class SdfMaterial : int { opaque, glass };
enum class SdfRelaxation : int { none, fixed, automatic };
enum class SdfDrawnOver : int { box, picture };
enum class SdfNormal : int { forward, tetrahedron, central };
enum class SdfShadow : int { none, hard, classic, improved, signedDistance, area };
enum class SdfShown : int { field, mesh };
enum class SdfHeatMap : int { none, steps, evaluations, normals, distance };

// Parameters of every exhibit that is a distance field. A table inherits them after its own:
//
//     struct BallParameters : virtual Parameters { Real radius = real("radius", 0.3, meter, {0.01, 1}, "Ball radius");
//     }; struct BallTable final : BallParameters, SdfMaterialParameters, SdfParameters {};

/// Uniform material of the whole body, read by shaders/kit/sdf/even_material.glsl.
struct SdfMaterialParameters : virtual Parameters {
    Group surface = group("Material");
    Choice<SdfMaterial> material =
        choice("material", SdfMaterial::opaque, {"opaque", "glass"},
               "Material of the object: opaque reflects, glass also refracts at every surface.", essential());
    Color baseColor =
        color("baseColor", {0.95, 0.93, 0.88}, "Color of the glaze, of the metal, or of 10 cm of the glass.");
    Real roughness =
        real("roughness", 0.06, none, {0, 1}, "Roughness of the surface: 0 is a mirror, 1 is chalk.", essential());
    Real metalness =
        real("metalness", 1.0, none, {0, 1}, "Share of metal: 0 is a glaze over a colored body, 1 is bare metal.",
             when(material, SdfMaterial::opaque) || whenLater("shownAs", static_cast<double>(SdfShown::mesh)));
    Real specular = real("specular", 0.5, none, {0, 1},
                         "Reflectance of nonmetals: 0 reflects nothing, 0.5 is the 4 % of most glazes.",
                         whenNot(metalness, 1) || when(material, SdfMaterial::glass));
    Real refractiveIndex =
        real("refractiveIndex", 1.5, none, Range{1, 3}.soft(1, 2.4),
             "Refractive index of the glass: 1 bends nothing, 2.4 is diamond.", when(material, SdfMaterial::glass));
};

/// Parameters of marching, shading and inspecting the body.
struct SdfParameters : virtual Parameters {
    /// `initialBounces` is small for rough bodies, on which reflections of themselves are invisible. `litBesides` is
    /// the condition for a light of the exhibit itself, which also shines on the surroundings. Then ambient occlusion
    /// acts on glass, too, and occlusion and shadow act on the surroundings.
    explicit SdfParameters(int initialBounces = 2, std::optional<Condition> litBesides = {})
        : initialBounces_(initialBounces), litBesides_(std::move(litBesides))
    {
    }

private:
    int initialBounces_;
    std::optional<Condition> litBesides_;

public:
    Group reflections = group("Material");
    Count bounces =
        count("bounces", initialBounces_, {0, 4},
              "Number of times a reflected ray may meet the object again before it sees only the hall: 0 is cheapest.",
              quality(4), whenFollowed());
    Toggle ambientOcclusion =
        toggle("ambientOcclusion", true,
               "Whether the hall's light is darkened where the object hides it, at five evaluations per pixel.",
               whenOccluded());

    Group light = group("Shadow");
    Choice<SdfShadow> shadowMethod =
        choice("shadowMethod", SdfShadow::signedDistance, {"none", "hard", "classic", "improved", "signed", "area"},
               "Method with which the object shades itself from the sun: none, one ray (hard), three estimates of soft "
               "shadows from one ray, or many rays (area).",
               quality(SdfShadow::area), whenShaded(), essential());
    Count shadowRays = count("shadowRays", 16, {1, 256, logarithmic},
                             "Number of rays over the sun's disk, for the area method: few are noisy, many cost more.",
                             quality(256), when(shadowMethod, SdfShadow::area));
    Real sunWidth =
        real("sunWidth", degrees(1.5), degree, Range{degrees(0.01), degrees(60)}.soft(degrees(0.1), degrees(10)),
             "Angular diameter of the sun: wide gives soft shadows. The real sun has half a degree.",
             when(shadowMethod, {SdfShadow::classic, SdfShadow::improved, SdfShadow::signedDistance, SdfShadow::area}));

    Group accuracy = group("Accuracy");
    Real hitTolerance = real(
        "hitTolerance", 1.0, none, Range{0.001, 64, logarithmic}.soft(0.05, 16),
        "Distance at which a ray counts as a hit, in half pixels at that depth: low is accurate, high saves steps.",
        quality(0.001));
    Count stepLimit =
        count("stepLimit", 128, {1, 1024, logarithmic},
              "Largest number of steps of a ray; beyond it, the ray ends at the best candidate so far.", quality(1024));
    Choice<SdfRelaxation> relaxation = choice("relaxation", SdfRelaxation::automatic, {"none", "fixed", "automatic"},
                                              "Relaxation of the step length beyond the distance: none, by a fixed "
                                              "factor, or as far as the slope of the field allows.",
                                              exactAt(SdfRelaxation::none));
    Real relaxationFactor =
        real("relaxationFactor", 1.2, none, {1, 1.99},
             "Factor of the fixed relaxation: 1 is none, higher takes longer steps and has to take back more of them.",
             exactAt(1), when(relaxation, SdfRelaxation::fixed));
    Toggle conePrepass =
        toggle("conePrepass", true,
               "Whether one cone per 8 × 8 pixels is marched first; their rays start at the end of the cone.",
               exactAt(0), whenMarched());
    Choice<SdfNormal> normalMethod = choice("normalMethod", SdfNormal::central, {"forward", "tetrahedron", "central"},
                                            "Finite differences that give the normal, at 4, 4 or 6 evaluations; the "
                                            "first two are less accurate at creases.",
                                            quality(SdfNormal::central), whenFollowed());
    Real normalStep = real("normalStep", 0.0003, meter, Range{1e-7, 0.1, logarithmic}.soft(1e-6, 0.02),
                           "Step of the finite differences for normals near the eye: too small suffers from rounding, "
                           "too large rounds creases.",
                           quality(0.0003), whenFollowed());

    Group bounds = group("Bounding box");
    Real boxSize = real("boxSize", 1.0, none, Range{0.05, 10}.soft(0.5, 1.5),
                        "Size of the bounding mesh in which rays march, relative to the smallest that holds the "
                        "object: below 1 clips it.");
    Choice<SdfDrawnOver> drawnOver =
        choice("drawnOver", SdfDrawnOver::box, {"box", "picture"},
               "Triangles from whose pixels rays start: those of the bounding mesh, or one over the whole picture, as "
               "in demos of distance fields. The picture is the same.",
               exactAt(SdfDrawnOver::box), whenMarched());
    Toggle showBox =
        toggle("showBox", false,
               "Whether the edges of the bounding mesh are drawn: amber if it holds the object, red if it clips it.");

    Group showing = group("Display");
    Choice<SdfShown> shownAs =
        choice("shownAs", SdfShown::field, {"field", "mesh"},
               "Representation of the object: the distance field, ray-marched, or a mesh of it, rasterized.");
    Count tessellation =
        count("tessellation", 24, {4, 256, logarithmic},
              "Number of mesh cells along the longest side of the box: few show facets in the reflections.",
              quality(256), when(shownAs, SdfShown::mesh));
    Choice<SdfHeatMap> heatMap = choice(
        "heatMap", SdfHeatMap::none, {"none", "steps", "evaluations", "normals", "distance"},
        "Quantity by which the object is colored: the steps or evaluations that it cost, its normals, or its distance.",
        whenMarched(), essential());
    Real heatScale = real("heatScale", 64, none, Range{1, 4096, logarithmic}.soft(4, 512),
                          "Count that the heat map shows in white: low brings out small costs, high large ones.",
                          when(heatMap, {SdfHeatMap::steps, SdfHeatMap::evaluations}));

private:
    StudiedParameters studiedMarch_{
        *this,
        {{.name = "hitTolerance", .lifted = {"stepLimit"}},
         {.name = "stepLimit", .settles = "Rays end before they have taken this many steps."},
         {.name = "drawnOver",
          .same = "Rays that pass the bounding mesh meet nothing, so that the picture is the same."},
         {.name = "normalStep", .settles = "A quarter of a pixel is wider, and is used instead."},
         {.name = "bounces", .settles = "No ray meets the object this many times."}}};

    /// Returns the condition that rays are marched for the picture.
    [[nodiscard]] static Condition whenMarched() { return whenLater("shownAs", static_cast<double>(SdfShown::field)); }
    /// Returns `whenMarched`, or that a light of the exhibit itself casts shadows on the surroundings.
    [[nodiscard]] Condition whenShaded() const { return litBesides_ ? *litBesides_ || whenMarched() : whenMarched(); }
    /// Returns `whenMarched`, or that rays of the sun are traced through glass.
    [[nodiscard]] Condition whenFollowed() const
    {
        return find("material") ? whenMarched() || whenLater("material", static_cast<double>(SdfMaterial::glass))
                                : whenMarched();
    }
    [[nodiscard]] Condition whenOccluded() const
    {
        if (!find("material")) return whenMarched();
        Condition occluded = whenLater("material", static_cast<double>(SdfMaterial::opaque)) ||
                             whenLater("heatMap", static_cast<double>(SdfHeatMap::evaluations));
        Condition marched = whenMarched() && std::move(occluded);
        return litBesides_ ? *litBesides_ || std::move(marched) : std::move(marched);
    }
};

}  // namespace vitrine

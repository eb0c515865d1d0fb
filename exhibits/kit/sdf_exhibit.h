#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/framework/offers_comparisons.h"
#include "exhibits/kit/sdf_rows.h"

#include <functional>
#include <memory>
#include <string>

namespace vitrine {

/// Where a field's GLSL comes from: files under shaders/, or texts that are made at run time.
struct SdfShaders {
    /// Defines `float fieldDistance(vec3 p)`: meters, negative inside, 1-Lipschitz, in the body's own space.
    std::string field;
    /// Defines `FieldMaterial fieldMaterial(vec3 p)` (shaders/kit/sdf/material.glsl) of a point of the surface. By
    /// default that of SdfMaterialRows, everywhere.
    std::string material = "kit/sdf/even_material.glsl";
    /// Defines what is seen of it (shaders/kit/sdf/shading.glsl). By default the hall's light on that material.
    std::string shading = "kit/sdf/plain_shading.glsl";
    /// Texts that take the place of files, by path.
    std::shared_ptr<const render::ShaderSources> generated = {};
};

/// What passes of the kit are built with.
[[nodiscard]] std::shared_ptr<const render::ShaderSources> sdfSources(const SdfShaders&);

/// A body at one moment.
struct SdfBody {
    /// `parameters` of its shaders: the table's values, with what is animated as it is at this moment.
    ParameterValues values;
    render::Box box;  ///< The smallest known one that holds it; own space.
    /// The same field as its shaders', at float64: for the mesh and for what a visitor points at.
    std::function<double(const glm::dvec3&)> distance;
    /// Another text for every other field (`derive::keyOf`): the mesh is kept by it.
    std::string shape;
    /// A uniform block of its own (`render::std140Bytes`), at BLOCK_EXHIBIT; empty where `parameters` tells all.
    render::Bytes block = {};
    glm::dmat4 exhibitFromBody{1};  ///< Where it stands in the exhibit's space: the box is its own.
    double ownLight =
        0;  ///< The most that light of its own sends to its surfaces (irradiance): it shades itself from that.
    render::Factor occluded = {};                 ///< What ambient occlusion darkens is in proportion to it.
    std::string_view switchedOff = {};            ///< Why `values` lack an effect that the table asks for.
    std::string variant = {};                     ///< `render::Pass::variant` of its march.
    std::vector<std::string> defines = {};        ///< Permutations of its field, material and shading.
    std::vector<render::BufferUse> buffers = {};  ///< What its field reads at STORAGE_EXHIBIT_A, B and C.
    /// Shaders of its own (`sdfSources`), where the exhibit's are not for every state: those of a scene that was read.
    /// Make them once for each text, not for each picture. While new ones are built, the last ones are drawn.
    std::shared_ptr<const render::ShaderSources> sources = {};
};

struct SdfScene;

/// An exhibit that is a signed distance field: it supplies the field (`SdfShaders`, `body`), a table with SdfRows, and
/// a material. Sphere tracing with its cone pre-pass, its shadow, the bounding mesh and its overlay, a
/// rasterized mesh in its place, and heat maps are here.
class SdfExhibit : public Exhibit, public CastsGlassShadow, public OffersComparisons {
public:
    [[nodiscard]] render::Box bounds(const ParameterValues&) const final;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const final;
    [[nodiscard]] double firstHit(const ExhibitState&, const render::Ray&) const final;
    /// From before it and a little above, so that it fills the picture. By default.
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    /// Never, by default.
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    void planShadow(const PlanContext&, render::FramePlan&) const final;
    [[nodiscard]] bool castsGlassShadow(const ParameterValues& values) const final { return isGlass(values); }
    void plan(const PlanContext&, render::FramePlan&) const final;
    /// Field and mesh with each other, and the picture with what it costs.
    [[nodiscard]] std::vector<OfferedComparison> comparisons() const override;

    /// As it is `time` seconds after the exhibit's clock started.
    [[nodiscard]] virtual SdfBody body(const ParameterValues&, double time) const = 0;

protected:
    explicit SdfExhibit(const SdfShaders&);

    /// What takes time to make: `complete` is given it. Null where it needs nothing.
    [[nodiscard]] virtual std::shared_ptr<const PreparedPart> prepareBody(const PrepareContext&) const
    {
        return nullptr;
    }
    /// Adds to a body what was prepared for it.
    virtual void complete(SdfBody&, const PreparedPart*) const {}
    /// Adds passes beside the body's own, or says why not.
    virtual void planBeside(const SdfScene&, render::FramePlan&) const {}

    [[nodiscard]] virtual const SdfRows& rows() const = 0;
    /// Null where the table has no such rows: the field's own material tells all, and nothing is glass.
    [[nodiscard]] virtual const SdfMaterialRows* materialRows() const { return nullptr; }
    /// Whether rays go through it. By default where the material rows say so.
    [[nodiscard]] virtual bool isGlass(const ParameterValues&) const;
    /// A box that holds it at any time.
    [[nodiscard]] virtual render::Box boxOverTime(const ParameterValues& values) const { return body(values, 0).box; }

private:
    /// At its place; holds references to both.
    [[nodiscard]] SdfScene sceneOf(const PlanContext&, const SdfBody&) const;

    std::shared_ptr<const render::ShaderSources> sources_;
};

}  // namespace vitrine

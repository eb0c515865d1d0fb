#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/offers_comparisons.h"
#include "exhibits/kit/sdf_parameters.h"

#include <functional>
#include <memory>
#include <string>

namespace vitrine {

/// GLSL of a field: files under shaders/, or texts made at run time.
struct SdfShaders {
    /// Defines `float fieldDistance(vec3 p)`: meters, negative inside, 1-Lipschitz, in the body's own space.
    std::string field;
    /// Defines `FieldMaterial fieldMaterial(vec3 p)` (shaders/kit/sdf/material.glsl) for a point of the surface. By
    /// default it is uniform, from SdfMaterialParameters.
    std::string material = "kit/sdf/even_material.glsl";
    /// Defines the shading (shaders/kit/sdf/shading.glsl). By default it is the hall's light on that material.
    std::string shading = "kit/sdf/plain_shading.glsl";
    /// Texts in place of files, by path.
    std::shared_ptr<const render::ShaderSources> generated = {};
};

/// Returns the sources with which the kit's passes are built.
[[nodiscard]] std::shared_ptr<const render::ShaderSources> sdfSources(const SdfShaders&);

/// Body at one time.
struct SdfBody {
    /// `parameters` of its shaders: the values with animated ones at their current state.
    ParameterValues values;
    render::Box box;  ///< Smallest known bounding box, in body space.
    /// The same field as in the shaders, in float64; used for the mesh and for picking.
    std::function<double(const glm::dvec3&)> distance;
    /// Key of the field, different for every field (`derive::keyOf`). The mesh is cached by it.
    std::string shape;
    /// Its uniform block (`render::std140Bytes`) at BLOCK_EXHIBIT; empty if `parameters` are sufficient.
    render::Bytes block = {};
    glm::dmat4 exhibitFromBody{1};  ///< Position of body space, which includes the box, in exhibit space.
    double ownLight = 0;            ///< Upper bound of the irradiance by its own light; the body shades itself from it.
    render::Factor occluded = {};   ///< Ambient occlusion is proportional to it.
    std::string_view switchedOff = {};            ///< Reason why `values` lack an effect that the parameters contain.
    std::string variant = {};                     ///< `render::Pass::variant` of its march.
    std::vector<std::string> defines = {};        ///< Permutations of its field, material and shading.
    std::vector<render::BufferUse> buffers = {};  ///< Buffers that its field reads.
    /// Its own shaders (`sdfSources`), if the exhibit's do not fit every state, such as those of a scene file. Make
    /// them once per text, not per frame. While new ones are compiled, the last ones are drawn.
    std::shared_ptr<const render::ShaderSources> sources = {};
};

struct SdfScene;

/// An exhibit that is a signed distance field. It supplies the field (`SdfShaders`, `body`), parameters with
/// SdfParameters, and a material. This class provides sphere tracing with its cone pre-pass, its shadow, the bounding
/// box with its overlay, the rasterized mesh, and heat maps.
class SdfExhibit : public Exhibit, public CastsGlassShadow, public MirrorsSurroundings, public OffersComparisons {
public:
    [[nodiscard]] render::Box bounds(const ParameterValues&) const final;
    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext&) const final;
    [[nodiscard]] double firstHit(const ExhibitState&, const render::Ray&) const final;
    /// Returns a camera in front of the exhibit and a little above it, so it fills the picture; may be overridden.
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override;
    /// Returns infinity (no change) unless overridden.
    [[nodiscard]] double nextChange(const ParameterValues&, double time) const override;
    void planShadow(const PlanContext&, render::FramePlan&) const final;
    [[nodiscard]] bool castsGlassShadow(const ParameterValues& values) const final { return isGlass(values); }
    /// Returns whether its material is smooth.
    [[nodiscard]] bool mirrors(const ParameterValues&) const final;
    void plan(const PlanContext&, render::FramePlan&) const final;
    /// Offers comparisons of field and mesh, and of the picture and its cost.
    [[nodiscard]] std::vector<OfferedComparison> comparisons() const override;

    /// Returns the body `time` seconds after the exhibit's clock started.
    [[nodiscard]] virtual SdfBody body(const ParameterValues&, double time) const = 0;

protected:
    explicit SdfExhibit(const SdfShaders&);

    /// Prepares what takes time to make, which `complete` then gets. Null if nothing is needed.
    [[nodiscard]] virtual std::shared_ptr<const PreparedPart> prepareBody(const PrepareContext&) const
    {
        return nullptr;
    }
    /// Adds to a body what was prepared for it.
    virtual void complete(SdfBody&, const PreparedPart*) const {}
    /// Adds passes beside the body's own, or the reasons for skipping them.
    virtual void planBeside(const SdfScene&, render::FramePlan&) const {}

    [[nodiscard]] virtual const SdfParameters& rows() const = 0;
    /// Returns null if the parameters contain none; then the field's own material applies, and nothing is glass.
    [[nodiscard]] virtual const SdfMaterialParameters* materialParameters() const { return nullptr; }
    /// Returns whether rays pass through the body; by default if the material is glass.
    [[nodiscard]] virtual bool isGlass(const ParameterValues&) const;
    /// Returns a box that contains the body at any time.
    [[nodiscard]] virtual render::Box boxOverTime(const ParameterValues& values) const { return body(values, 0).box; }

private:
    /// Returns the body at its place; it keeps references to both arguments.
    [[nodiscard]] SdfScene sceneOf(const PlanContext&, const SdfBody&) const;

    std::shared_ptr<const render::ShaderSources> sources_;
};

}  // namespace vitrine

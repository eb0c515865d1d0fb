#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/sdf_morph/sdf_morph_table.h"
#include "render/scene/mesh.h"
#include "render/scene/ray.h"

#include <glm/glm.hpp>

namespace vitrine {

/// The object at one moment: the table's values with the morph as animated.
struct SdfMoment {
    const SdfMorphTable& table;
    const ParameterValues& values;
    double morph = 0;
};

/// The smallest known box around the object at this moment, or over the whole melt.
[[nodiscard]] render::Box momentaryBox(const SdfMoment&);
[[nodiscard]] render::Box boxOverMorph(const SdfMoment&);
/// `box` with its size around its center changed by a factor.
[[nodiscard]] render::Box resized(const render::Box&, double factor);

/// Where a ray in the object's space first meets it, as `render::firstHit` counts: sphere tracing in float64.
[[nodiscard]] double firstHitOf(const SdfMoment&, const render::Ray&);

/// Mirrors the std140 block Object of shaders/sdf_morph/object.glsl.
struct SdfObject {
    glm::mat4 worldFromLocal{1};
    glm::mat4 localFromWorld{1};
    glm::vec4 boxLow{0}, boxHigh{0};  ///< Local; w of boxLow: largest scale of worldFromLocal.
    glm::vec4 shape[7];               ///< TorusMugShape, field after field.
    glm::vec4 wipe{0};                ///< x: pixels from the left edge at which the marched half ends.
};

/// `box` is what the rays are marched in. A singular transform is the caller's fault.
[[nodiscard]] SdfObject sdfObject(const SdfMoment&, const render::Box& box, const glm::dmat4& worldFromLocal);

/// A triangle mesh of the object: surface nets (Gibson 1998) on a grid of `cells` along the longest side of
/// its box, vertices drawn onto the surface, normals from the field. Closed as far as the grid resolves.
[[nodiscard]] std::shared_ptr<const render::Mesh> meshOf(const SdfMoment&, int cells);

}  // namespace vitrine

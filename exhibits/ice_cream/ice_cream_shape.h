#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/ice_cream/ice_cream_table.h"
#include "render/glsl/std140.h"
#include "render/scene/mesh.h"

#include <type_traits>

namespace vitrine::ice_cream {

#include "shaders/ice_cream/ice_cream_block.glsl"

/// Size of the plinth in the shape's own space, meters.
inline constexpr double iceCreamPlinthRadius = 0.28, iceCreamPlinthHeight = 0.26;

/// Returns the shape at `time` seconds, without the grid of the sprinkles.
[[nodiscard]] IceCreamShape iceCreamShape(const IceCreamParameters&, const ParameterValues&, double time);

/// Returns the stage of the build-up that is shown `time` seconds after it began.
[[nodiscard]] IceCreamStage stageAt(const IceCreamParameters&, const ParameterValues&, double time);

/// Returns the bounding box in the shape's own space, without sprinkles.
[[nodiscard]] render::Box boxOf(const IceCreamShape&);
/// Returns the bounding box over all times and stages, with floating candies.
[[nodiscard]] render::Box boxOverTime(const IceCreamParameters&, const ParameterValues&);

/// Returns the angle that the reference adds to a candy after `time` seconds, radians.
[[nodiscard]] double candySpin(double time);

/// Copies a shape into another precision: C++ at float64 or float32 (ice_cream_cpu.h), or the uniform block.
template <typename To, typename From> void copyShape(To& to, const From& from)
{
#define COPY_FIELD(type, name) to.name = std::remove_cvref_t<decltype(to.name)>(from.name);
#define COPY_ARRAY(type, name, count)                                                                                  \
    for (std::size_t i = 0; i < (count); ++i) copyShape(to.name[i], from.name[i]);
    if constexpr (requires { from.layers; }) {
        ICE_CREAM_FIELDS(COPY_FIELD, COPY_ARRAY)
    } else if constexpr (requires { from.lobes; }) {
        CREAM_LAYER_FIELDS(COPY_FIELD, COPY_ARRAY)
    } else {
        CANDY_FIELDS(COPY_FIELD, COPY_ARRAY)
    }
#undef COPY_ARRAY
#undef COPY_FIELD
}

}  // namespace vitrine::ice_cream

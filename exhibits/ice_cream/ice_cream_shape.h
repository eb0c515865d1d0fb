#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/ice_cream/ice_cream_table.h"
#include "render/glsl/std140.h"
#include "render/scene/mesh.h"

#include <type_traits>

namespace vitrine {

#include "shaders/ice_cream/ice_cream_block.glsl"

/// The ice cream's numbers at one moment, `time` in seconds. Without the grid of the sprinkles.
[[nodiscard]] IceCreamShape iceCreamShape(const IceCreamRows&, const ParameterValues&, double time);

/// Which stage of the build-up is shown, `time` seconds after it began.
[[nodiscard]] IceCreamStage stageAt(const IceCreamRows&, const ParameterValues&, double time);

/// A box that holds it, in its own space; sprinkles are left out.
[[nodiscard]] render::Box boxOf(const IceCreamShape&);
/// The same at any time and stage, with candies floating.
[[nodiscard]] render::Box boxOverTime(const IceCreamRows&, const ParameterValues&);

/// What the source adds to a candy's angle after `time` seconds, radians.
[[nodiscard]] double candySpin(double time);

/// The same shape in another precision: of C++ at float64 and float32 (ice_cream_cpu.h), or of the uniform block.
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

}  // namespace vitrine

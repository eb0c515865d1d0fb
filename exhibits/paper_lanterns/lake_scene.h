#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/paper_lanterns/paper_lanterns_table.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

#include <type_traits>

namespace vitrine {

#include "shaders/paper_lanterns/lake_block.glsl"

/// How long a lantern that was set free is to be seen, seconds.
inline constexpr double releasedFor = 60;

/// Where the lake lies behind the frame: y up, the frame's middle over the origin, +x and -z half to the right and half
/// to the left of straight ahead. So the lanes between the cells of the lattice, which begins behind the visitor with a
/// corner, run out of the picture.
[[nodiscard]] Portal lakePortal(const PaperLanternsTable&, const ParameterValues&);

/// Seconds that the lake has moved at `time` of the exhibit's clock.
[[nodiscard]] double lakeTime(const PaperLanternsTable&, const ParameterValues&, double time);

/// The lake at that moment; `sinceRelease` in seconds, infinity: no lantern was set free. All that moves is wrapped
/// here, at float64, within its own period.
[[nodiscard]] LakeBlock lakeBlock(const PaperLanternsTable&, const ParameterValues&, double seconds,
                                  double sinceRelease);

/// Whether any lantern is afloat with these values.
[[nodiscard]] bool anyAfloat(const PaperLanternsTable&, const ParameterValues&);

/// Whether the mist is so thick that the lanterns' light in it is seen.
[[nodiscard]] bool lightsTheAir(const PaperLanternsTable&, const ParameterValues&);

/// The same block in another precision: of C++ at float64 and float32 (paper_lanterns_cpu.h).
template <typename To> void copyLake(To& to, const LakeBlock& from)
{
#define COPY_LAKE_FIELD(type, name) to.name = std::remove_cvref_t<decltype(to.name)>(from.name);
#define COPY_LAKE_ARRAY(type, name, count)                                                                             \
    for (std::size_t i = 0; i < (count); ++i) to.name[i] = std::remove_cvref_t<decltype(to.name[i])>(from.name[i]);
    LAKE_FIELDS(COPY_LAKE_FIELD, COPY_LAKE_ARRAY)
#undef COPY_LAKE_ARRAY
#undef COPY_LAKE_FIELD
}

}  // namespace vitrine

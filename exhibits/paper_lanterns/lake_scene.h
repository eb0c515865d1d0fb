#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/paper_lanterns/paper_lanterns_table.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

#include <limits>
#include <type_traits>

namespace vitrine {

#include "shaders/paper_lanterns/lake_block.glsl"

/// How long a lantern that was set free is to be seen, seconds.
inline constexpr double releasedFor = 60;

/// Where the lake lies behind the frame: y up, the frame's middle over the origin, +x and -z half to the right and half
/// to the left of straight ahead. So the lanes between the cells of the lattice, which begins behind the visitor with a
/// corner, run out of the picture.
[[nodiscard]] Portal lakePortal(const PaperLanternsTable&, const ParameterValues&);

/// In the plane (x, z), unit: straight ahead through the frame, and where the wind blows to.
[[nodiscard]] glm::dvec2 straightAhead();
[[nodiscard]] glm::dvec2 windOf(const PaperLanternsTable&, const ParameterValues&);

/// Where the cell number (0, 0) begins before anything has drifted, in the plane (x, z), for cells of this width.
[[nodiscard]] glm::dvec2 latticeCorner(const PaperLanternsTable&, const ParameterValues&, double cell);

/// The number of the cell in the corner of the lattice, when all has drifted by that in the plane (x, z): who drifts
/// keeps its number.
[[nodiscard]] glm::ivec2 firstCellAt(const glm::dvec2& drifted, double cell);

/// Sine of the angle by which the water makes lanterns lean at most.
[[nodiscard]] float mostLean(const LakeBlock&);

/// How far the tube of a lantern is from its axis at most, leaning as far as the water may make it.
[[nodiscard]] float tubeReach(const LakeBlock&);

/// Seconds that the lake has moved at `time` of the exhibit's clock.
[[nodiscard]] double lakeTime(const PaperLanternsTable&, const ParameterValues&, double time);

/// When the button was pressed that sets a lantern free.
struct LakePress {
    double since = std::numeric_limits<double>::infinity();  ///< Seconds that have passed; infinity: never.
    double at = 0;                                           ///< Seconds that the lake had moved then.
};

/// The press so many seconds ago. It makes time run: what `animate` became afterwards does not change where it began.
[[nodiscard]] LakePress lakePress(const PaperLanternsTable&, const ParameterValues&, double time, double since);

/// The lake at that moment. All that moves is wrapped here, at float64, within its own period.
[[nodiscard]] LakeBlock lakeBlock(const PaperLanternsTable&, const ParameterValues&, double seconds,
                                  const LakePress& = {});

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

#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/kit/sky_view.h"
#include "exhibits/paper_lanterns/paper_lanterns_table.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

#include <limits>
#include <memory>
#include <type_traits>

namespace vitrine::paper_lanterns {

#include "shaders/paper_lanterns/lake_block.glsl"

/// Seconds for which a released lantern is visible.
inline constexpr double releasedFor = 60;

/// Returns the clear sky at a dusk of strength 1: the warmer the afterglow, the higher the sun below the horizon.
[[nodiscard]] std::shared_ptr<const SkyView> lakeDusk(const PaperLanternsTable&, const ParameterValues&);

/// Returns the position of the lake behind the frame. y is up, and the center of the frame is above the origin; +x and
/// -z are 45 degrees to the right and left of straight ahead. So the lanes between the cells of the lattice, whose
/// corner is behind the user, lead out of the picture.
[[nodiscard]] Portal lakePortal(const PaperLanternsTable&, const ParameterValues&);

/// Return unit vectors in the plane (x, z): straight ahead through the frame, and where the wind blows to.
[[nodiscard]] glm::dvec2 straightAhead();
[[nodiscard]] glm::dvec2 windOf(const PaperLanternsTable&, const ParameterValues&);

/// Returns the corner of cell (0, 0) before any drift, in the plane (x, z), for cells of this width.
[[nodiscard]] glm::dvec2 latticeCorner(const PaperLanternsTable&, const ParameterValues&, double cell);

/// Returns the number of the cell in the corner of the lattice after a drift in the plane (x, z). A lantern that drifts
/// keeps its number.
[[nodiscard]] glm::ivec2 firstCellAt(const glm::dvec2& drifted, double cell);

/// Returns the sine of the largest angle by which the water tilts lanterns.
[[nodiscard]] float mostLean(const LakeBlock&);

/// Returns the largest distance of a lantern's tube from its axis, at the largest tilt.
[[nodiscard]] float tubeReach(const LakeBlock&);

/// Returns the seconds for which the lake has moved at `time` of the exhibit's clock.
[[nodiscard]] double lakeTime(const PaperLanternsTable&, const ParameterValues&, double time);

/// Time of the press of the button that releases a lantern.
struct LakePress {
    double since = std::numeric_limits<double>::infinity();  ///< Seconds since the press; infinity: never.
    double at = 0;                                           ///< Seconds for which the lake had moved at the press.
};

/// Returns the press `since` seconds ago. A press starts time, so later changes of `animate` do not affect its start.
[[nodiscard]] LakePress lakePress(const PaperLanternsTable&, const ParameterValues&, double time, double since);

/// Returns the lake after `seconds`. Everything that moves is wrapped within its own period here, at float64.
[[nodiscard]] LakeBlock lakeBlock(const PaperLanternsTable&, const ParameterValues&, double seconds,
                                  const LakePress& = {});

/// Returns whether any lantern is afloat with these values.
[[nodiscard]] bool anyAfloat(const PaperLanternsTable&, const ParameterValues&);

/// Returns whether the mist is so thick that the lanterns' light in it is visible.
[[nodiscard]] bool lightsTheAir(const PaperLanternsTable&, const ParameterValues&);

/// Copies a block into another precision: C++ at float64 and float32 (paper_lanterns_cpu.h).
template <typename To> void copyLake(To& to, const LakeBlock& from)
{
#define COPY_LAKE_FIELD(type, name) to.name = std::remove_cvref_t<decltype(to.name)>(from.name);
#define COPY_LAKE_ARRAY(type, name, count)                                                                             \
    for (std::size_t i = 0; i < (count); ++i) to.name[i] = std::remove_cvref_t<decltype(to.name[i])>(from.name[i]);
    LAKE_FIELDS(COPY_LAKE_FIELD, COPY_LAKE_ARRAY)
#undef COPY_LAKE_ARRAY
#undef COPY_LAKE_FIELD
}

}  // namespace vitrine::paper_lanterns

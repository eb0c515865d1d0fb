#pragma once

#include <array>
#include <cstdint>

namespace vitrine::scenes {

/// Topology of a surface in a cube cell whose corners are inside or outside. Corner i has the bits of i as coordinates
/// (x, y, z). Edge 4 a + j runs along the axis a; the bits of j give its position along the axes a + 1 and a + 2. On
/// every face, lines separate each run of inside corners from the rest, so that both cubes of a face agree. The lines
/// of a cube form closed loops, and each crossed edge belongs to one.
struct CellLoops {
    int loops = 0;                         ///< 0 to 4.
    std::array<std::int8_t, 12> loopOf{};  ///< Loop of each edge; -1 if it is not crossed.
};

/// Returns the loops for the corners that are inside, one bit each.
[[nodiscard]] const CellLoops& cellLoops(unsigned inside);

/// Returns the corner at the start of an edge; the edge ends at that plus 1 << axis.
[[nodiscard]] constexpr unsigned edgeStart(unsigned edge)
{
    const unsigned axis = edge / 4;
    return ((edge & 1U) << ((axis + 1) % 3)) | ((edge >> 1U & 1U) << ((axis + 2) % 3));
}

/// Returns the edge along an axis at this corner, whose bit of that axis is ignored.
[[nodiscard]] constexpr unsigned edgeAt(unsigned axis, unsigned corner)
{
    return 4 * axis + (corner >> ((axis + 1) % 3) & 1U) + 2 * (corner >> ((axis + 2) % 3) & 1U);
}

}  // namespace vitrine::scenes

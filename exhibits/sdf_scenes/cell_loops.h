#pragma once

#include <array>
#include <cstdint>

namespace vitrine::scenes {

/// How a surface passes through a cube whose corners are inside or outside. Corner i is at the bits of i (x, y, z).
/// Edge 4 a + j runs along the axis a; bits of j say where it lies along the axes a + 1 and a + 2. On every face, lines
/// separate each run of inside corners from the rest, so that both cubes of a face agree; the lines of a cube close to
/// loops, and each edge that is crossed belongs to one.
struct CellLoops {
    int loops = 0;                         ///< 0 to 4.
    std::array<std::int8_t, 12> loopOf{};  ///< By edge; -1 where it is not crossed.
};

/// By the corners that are inside, a bit for each.
[[nodiscard]] const CellLoops& cellLoops(unsigned inside);

/// The corner where an edge begins; it ends at that plus 1 << axis.
[[nodiscard]] constexpr unsigned edgeStart(unsigned edge)
{
    const unsigned axis = edge / 4;
    return ((edge & 1U) << ((axis + 1) % 3)) | ((edge >> 1U & 1U) << ((axis + 2) % 3));
}

/// The edge along an axis from this corner, whose bit of that axis does not count.
[[nodiscard]] constexpr unsigned edgeAt(unsigned axis, unsigned corner)
{
    return 4 * axis + (corner >> ((axis + 1) % 3) & 1U) + 2 * (corner >> ((axis + 2) % 3) & 1U);
}

}  // namespace vitrine::scenes

#include "exhibits/sdf_scenes/cell_loops.h"

namespace vitrine::scenes {
namespace {

/// Returns the corners around a face, in order.
std::array<unsigned, 4> cornersOfFace(unsigned axis, unsigned side)
{
    const unsigned u = 1U << ((axis + 1) % 3), v = 1U << ((axis + 2) % 3), at = side << axis;
    return {at, at | u, at | u | v, at | v};
}

/// Returns the edge between two corners that differ in one bit.
unsigned edgeBetween(unsigned a, unsigned b)
{
    const unsigned along = a ^ b;
    return edgeAt(along == 1 ? 0 : along == 2 ? 1 : 2, a);
}

/// Union-find: edges of one loop have the same root.
struct Roots {
    std::array<unsigned, 12> parent{};

    unsigned rootOf(unsigned edge) const
    {
        while (parent[edge] != edge) edge = parent[edge];
        return edge;
    }
};

CellLoops loopsOf(unsigned inside)
{
    Roots roots;
    for (unsigned e = 0; e < 12; ++e) roots.parent[e] = e;
    const auto isIn = [inside](unsigned corner) { return (inside >> corner & 1U) != 0; };
    for (unsigned face = 0; face < 6; ++face) {
        const auto corners = cornersOfFace(face / 2, face % 2);
        for (unsigned i = 0; i < 4; ++i) {
            if (isIn(corners[i]) || !isIn(corners[(i + 1) % 4])) continue;
            unsigned end = i + 1;  // A run of inside corners begins here; it ends at an outside one.
            while (isIn(corners[(end + 1) % 4])) ++end;
            const unsigned a = roots.rootOf(edgeBetween(corners[i], corners[(i + 1) % 4]));
            roots.parent[roots.rootOf(edgeBetween(corners[end % 4], corners[(end + 1) % 4]))] = a;
        }
    }
    CellLoops found;
    std::array<int, 12> number{};
    number.fill(-1);
    for (unsigned e = 0; e < 12; ++e) {
        found.loopOf[e] = -1;
        const unsigned start = edgeStart(e);
        if (isIn(start) == isIn(start | 1U << (e / 4))) continue;
        int& loop = number[roots.rootOf(e)];
        if (loop < 0) loop = found.loops++;
        found.loopOf[e] = static_cast<std::int8_t>(loop);
    }
    return found;
}

}  // namespace

const CellLoops& cellLoops(unsigned inside)
{
    static const auto all = [] {
        std::array<CellLoops, 256> made;
        for (unsigned i = 0; i < 256; ++i) made[i] = loopsOf(i);
        return made;
    }();
    return all[inside];
}

}  // namespace vitrine::scenes

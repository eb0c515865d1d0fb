#pragma once

#include "exhibits/ice_cream/ice_cream_shape.h"
#include "render/plan/frame_plan.h"

#include <memory>
#include <vector>

namespace vitrine {

struct SprinkleSettings {
    int count = 0;
    int seed = 1;
    double length = 0.034;  ///< Meters, round ends included.
};

/// Capsules strewn over the cream of a shape, in a grid that tells each point which of them are near.
struct Sprinkles {
    struct One {
        glm::vec3 start, finish;  ///< Of its middle line; meters.
        int color = 0;            ///< 0 to 4.
    };
    struct Cell {
        std::int32_t first = 0, end = 0;  ///< Of its list.
        float clear = 0;  ///< Meters: whatever is not in the list is farther from any point of the cell.
        std::int32_t unused = 0;
    };

    std::vector<One> all;
    glm::vec3 low{0};  ///< Of the grid.
    float cell = 0;    ///< Width of its cells.
    glm::ivec3 cells{0};
    std::vector<Cell> grid;
    std::vector<glm::vec4> ends;  ///< Of the lists: start with color, finish, for each entry.

    std::shared_ptr<const render::Bytes> cellBytes, endBytes;  ///< The last two as std430.
};

/// Each sprinkle has random numbers of its own, from `seed` and its number: one more moves none of the others. Fewer
/// than asked for where the cream is too small to be hit.
[[nodiscard]] Sprinkles strewn(const IceCreamShape&, const SprinkleSettings&);

}  // namespace vitrine

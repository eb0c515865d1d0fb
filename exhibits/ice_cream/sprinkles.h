#pragma once

#include "exhibits/ice_cream/ice_cream_shape.h"
#include "render/plan/frame_plan.h"

#include <memory>
#include <vector>

namespace vitrine::ice_cream {

struct SprinkleSettings {
    int count = 0;
    int seed = 1;
    double length = 0.034;  ///< Meters, including the round ends.
};

/// Capsules on the cream of a shape, in a grid that lists which of them are near each point.
struct Sprinkles {
    struct One {
        glm::vec3 start, finish;  ///< Ends of the center line, meters.
        int color = 0;            ///< 0 to 4.
    };
    struct Cell {
        std::int32_t first = 0, end = 0;  ///< Range of its list.
        float clear = 0;  ///< Meters; sprinkles that are not in the list are farther from any point of the cell.
        std::int32_t unused = 0;
    };

    std::vector<One> all;
    glm::vec3 low{0};  ///< Lower corner of the grid, meters.
    float cell = 0;    ///< Width of its cells, meters.
    glm::ivec3 cells{0};
    std::vector<Cell> grid;
    std::vector<glm::vec4> ends;  ///< Contents of the lists: for each entry the start with the color, and the finish.

    std::shared_ptr<const render::Bytes> cellBytes, endBytes;  ///< `grid` and `ends` as texels.
};

/// Returns sprinkles on the cream. The random numbers of each depend on `seed` and on its index only, so one more moves
/// none of the others. There are fewer than `count` if the cream is too small to be hit.
[[nodiscard]] Sprinkles strewn(const IceCreamShape&, const SprinkleSettings&);

}  // namespace vitrine::ice_cream

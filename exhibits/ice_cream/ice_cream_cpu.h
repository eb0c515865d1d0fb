#pragma once

#include "render/glsl/cpu.h"

#include <vector>

/// shaders/ice_cream/solids.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/ice_cream/ice_cream_block.glsl"

/// Sprinkles in their grid, as shaders/ice_cream/field.glsl reads them.
struct SprinkleLists {
    struct Cell {
        int first = 0, end = 0;
        float clear = 1e9;
    };
    std::vector<Cell> cells;
    std::vector<vec4> ends;  ///< Two for each list entry.
};

/// The solids around one shape. `solids` counts evaluations; `fieldPart` is the part found last.
struct IceCream {
    IceCreamShape shape = {};
    SprinkleLists sprinkles = {};
    int solids = 0;
    int fieldPart = 0;
    float levelHere = 0;
    float unlisted = 0;

    float sprinkleClear(int cell) const { return sprinkles.cells[static_cast<std::size_t>(cell)].clear; }
    int sprinkleFirst(int cell) const { return sprinkles.cells[static_cast<std::size_t>(cell)].first; }
    int sprinkleEnd(int cell) const { return sprinkles.cells[static_cast<std::size_t>(cell)].end; }
    vec4 sprinkleStart(int i) const { return sprinkles.ends[static_cast<std::size_t>(2 * i)]; }
    vec4 sprinkleFinish(int i) const { return sprinkles.ends[static_cast<std::size_t>(2 * i + 1)]; }

#include "shaders/ice_cream/solids.glsl"
};

#include "render/glsl/end_cpu.h"

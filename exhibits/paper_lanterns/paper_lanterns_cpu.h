#pragma once

#include "render/glsl/cpu.h"

/// shaders/paper_lanterns as C++: the lake, its lanterns, and the traversal of a ray.

#include "render/glsl/begin_cpu.h"

#include "shaders/paper_lanterns/lake_block.glsl"

#include "shaders/paper_lanterns/paper.glsl"

#include "shaders/paper_lanterns/fibers.glsl"

/// Lanterns of one block. `evaluations` counts evaluations of the field.
struct Lake {
    LakeBlock lake = {};
    int evaluations = 0;
    const unsigned char* blueNoise = nullptr;  ///< 64 x 64 levels.

    float blueNoiseAt(ivec2 texel) const
    {
        return (float(blueNoise[(texel.y & 63) * 64 + (texel.x & 63)]) + float(0.5)) / float(256.0);
    }

#include "shaders/paper_lanterns/water.glsl"

#include "shaders/paper_lanterns/lantern.glsl"

    Lantern lanternAt(ivec2 cell)
    {
        return lanternOfCell(cell);
    }

#include "shaders/paper_lanterns/walk.glsl"

    /// Points leave solids unchanged; tests and counts are about solids.
    LanternWalk withPoint(LanternWalk walk, LanternRay, Lantern, float)
    {
        return walk;
    }
    LanternWalk withAir(LanternWalk walk, LanternRay, Lantern, float)
    {
        return walk;
    }
};

#include "render/glsl/end_cpu.h"

#pragma once

#include "render/glsl/cpu.h"

#include <functional>

/// shaders/pixel_art/normals.glsl and upscale.glsl as C++ at float64; after render/glsl/cpu.h.

#include "render/glsl/begin_cpu.h"

#include "shaders/pixel_art/upscale.glsl"

/// The methods over any depth buffer: `texelDepth` is anything callable with a texel.
template <typename Depth> struct NormalsFromDepth {
    Depth texelDepth;

    float depthAt(ivec2 p) { return texelDepth(p); }

#include "shaders/pixel_art/normals.glsl"
};
template <typename Depth> NormalsFromDepth(Depth) -> NormalsFromDepth<Depth>;

#include "render/glsl/end_cpu.h"

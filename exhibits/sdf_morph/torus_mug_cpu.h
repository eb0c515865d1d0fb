#pragma once

#include "render/glsl/cpu.h"

/// shaders/sdf_morph/torus_mug.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/sdf_morph/torus_mug_shape_block.glsl"

#include "shaders/sdf_morph/torus_mug.glsl"

#include "render/glsl/end_cpu.h"

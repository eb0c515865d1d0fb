#pragma once

#include "render/glsl/cpu.h"

/// shaders/sdf_scenes/*.glsl compiled as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/sdf_scenes/shapes.glsl"

#include "shaders/sdf_scenes/operators.glsl"

#include "shaders/sdf_scenes/noise.glsl"

#include "shaders/sdf_scenes/material.glsl"

#include "render/glsl/end_cpu.h"

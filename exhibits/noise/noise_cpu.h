#pragma once

#include "render/glsl/cpu.h"

/// shaders/noise/cloud_medium.glsl and cloud_noise.glsl as C++; after render/glsl/cpu.h.

#include "render/glsl/begin_cpu.h"

#include "shaders/noise/cloud_medium.glsl"

#include "shaders/noise/cloud_noise.glsl"

#include "render/glsl/end_cpu.h"

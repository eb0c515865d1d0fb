#pragma once

#include "render/glsl/cpu.h"

/// shaders/noise/cloud_medium.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/noise/cloud_medium.glsl"

#include "render/glsl/end_cpu.h"

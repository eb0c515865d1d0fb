#pragma once

#include "render/glsl/cpu.h"

/// shaders/printing/lens.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/printing/lens.glsl"

#include "render/glsl/end_cpu.h"

#pragma once

#include "render/glsl/cpu.h"

/// shaders/fur/strand.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/fur/strand.glsl"

#include "render/glsl/end_cpu.h"

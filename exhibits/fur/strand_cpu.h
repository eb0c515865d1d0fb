#pragma once

#include "render/glsl/cpu.h"

/// shaders/fur/strand.glsl, walk.glsl and hair.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/fur/strand.glsl"

#include "shaders/fur/walk.glsl"

#include "shaders/fur/hair.glsl"

#include "render/glsl/end_cpu.h"

#pragma once

#include "render/glsl/cpu.h"

/// shaders/crepuscular_rays/light_shafts.glsl and participating_media.glsl as C++.

#include "render/glsl/begin_cpu.h"

#include "shaders/crepuscular_rays/light_shafts.glsl"

#include "shaders/crepuscular_rays/participating_media.glsl"

#include "render/glsl/end_cpu.h"

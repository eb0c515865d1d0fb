#pragma once

#include <glm/glm.hpp>

/// shaders/lib as C++ at float64: the very source that the GPU compiles, called by tests, tools and the
/// engine. GLM gives types and functions the names that GLSL has for them, `float` means double.
///
///     double d = vitrine::glsl::sdfTorus(dvec3(0.5, 0, 0), 0.35, 0.12);
///
/// Definitions have internal linkage: include this in source files, and keep shader structs out of the
/// members of classes that headers declare. lib/sphere_tracing.glsl needs a field: see `Tracer`. An exhibit's own
/// GLSL becomes C++ in a header of its folder: see render/glsl/begin_cpu.h.
///
/// The same at float32, as the GPU rounds: render/glsl/cpu32.h (tests only; the build makes it).

#include "render/glsl/begin_cpu.h"

#include "shaders/lib/numerics.glsl"

#include "shaders/lib/hash.glsl"

#include "shaders/lib/noise.glsl"

#include "shaders/lib/noise_simplex.glsl"

#include "shaders/lib/noise_cellular.glsl"

#include "shaders/lib/noise_sums.glsl"

#include "shaders/lib/local_lights_block.glsl"

#include "shaders/lib/local_light.glsl"

#include "shaders/lib/standing_block.glsl"

#include "shaders/lib/contact.glsl"

#include "shaders/lib/standing.glsl"

#include "shaders/lib/sdf.glsl"

#include "shaders/lib/sdf_operators.glsl"

/// lib/sphere_tracing.glsl around one field. GLSL finds `fieldDistance` because the shader defines it
/// first; here the file is the body of a class, and `Field` is anything callable with a point:
///
///     Tracer tracer{[](const dvec3& p) { return glsl::sdfSphere(p, 1); }};
///     auto hit = tracer.sphereTrace(origin, direction, tracer.marchSettings(0, 10, pixelCone));
template <typename Field> struct Tracer {
    Field field;

    float fieldDistance(vec3 p) { return field(p); }

#include "shaders/lib/sphere_tracing.glsl"
};
template <typename Field> Tracer(Field) -> Tracer<Field>;

#include "render/glsl/end_cpu.h"

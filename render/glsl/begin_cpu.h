// Opens the namespace in which GLSL is compiled as C++ at float64; render/glsl/end_cpu.h closes it. Between the two, a
// header includes the GLSL of its own folder:
//
//     #include "render/glsl/cpu.h"
//
//     #include "render/glsl/begin_cpu.h"
//     #include "shaders/fur/strand.glsl"
//     #include "render/glsl/end_cpu.h"
//
// For tests, the build makes the same header at float32, as the GPU rounds: *_cpu32.h for *_cpu.h, with an `f` after
// each literal.

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace vitrine::glsl {
namespace {

using namespace glm;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat2 = glm::dmat2;
using mat3 = glm::dmat3;
using mat4 = glm::dmat4;

// Content of uniform blocks, at this precision.
#pragma push_macro("BLOCK_STRUCT")
#undef BLOCK_STRUCT
#define BLOCK_STRUCT(name, FIELDS)                                                                                     \
    struct name {                                                                                                      \
        FIELDS(VITRINE_GLSL_FIELD, VITRINE_GLSL_ARRAY)                                                                 \
    };
#define VITRINE_GLSL_FIELD(type, name) type name;
#define VITRINE_GLSL_ARRAY(type, name, count) type name[count];

#define float double

// One case per row from the bottom up, one input per column. x: result of the library; y: of the naive form.
#include "lib/bindings.glsl"
#include "lib/hash.glsl"
#include "lib/numerics.glsl"
#include "lib/sdf.glsl"
#include "lib/sdf_operators.glsl"
#include "lib/hard_cases.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    vec4 inputs[INPUTS * CASES];
} object;

layout(location = 0) out vec4 found;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 a = object.inputs[pixel.y * INPUTS + pixel.x];
    found = vec4(hardCase(pixel.y, a), naiveCase(pixel.y, a), 0.0, 0.0);
}

// One field per row from the bottom up, one point per column.
#include "lib/hash.glsl"
#include "lib/numerics.glsl"
#include "lib/sdf.glsl"
#include "lib/sdf_operators.glsl"
#include "lib/hard_cases.glsl"

layout(location = 0) out vec4 found;

void main()
{
    found = vec4(libraryField(int(gl_FragCoord.y), libraryPoint(int(gl_FragCoord.x))), 0.0, 0.0, 0.0);
}

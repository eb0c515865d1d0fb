// Traces one cone for each block of CONE_PREPASS x CONE_PREPASS pixels, to find where the rays of the block may start.
// x: local distance, beyond everything for an empty block; y: evaluations used.
#include "kit/sdf/ray.glsl"

layout(location = 0) out vec4 start;

void main()
{
    vec2 corner = floor(gl_FragCoord.xy) * BLOCK - tileInBlock();
    LocalRay axis = localRay(corner + 0.5 * BLOCK);
    float chord = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 offset = vec2(i == 1 || i == 3 ? BLOCK : 0.0, i >= 2 ? BLOCK : 0.0);
        vec3 d = mat3(object.localFromWorld) * frameRay(corner + offset);
        chord = max(chord, coneChord(axis.direction, normalize(d)));
    }
    vec2 span = coneBox(axis.origin, axis.direction, chord, object.boxLow, object.boxHigh);
    start = vec4(1.0e30, 0.0, 0.0, 0.0);
    if (span.x > span.y) return;
    ConeMarch cone = coneMarch(axis.origin, axis.direction, chord, tableSettings(span.x, span.y, axis.halfPixel));
    start.x = cone.empty ? 1.0e30 : cone.t;
    start.y = float(cone.evaluations);
}

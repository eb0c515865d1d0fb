// The object in the sun's depth map, by the sun's own parallel rays; depth is where they hit, not where
// the bounding mesh is.
#include "kit/sdf/object.glsl"

layout(depth_any) out float gl_FragDepth;

void main()
{
    vec2 ndc = framePixel(gl_FragCoord.xy) * frame.inverseSize * 2.0 - 1.0;
    // The view is orthographic: undo scale and shift of each axis; start where depth is 1.
    vec3 view = (vec3(ndc, 1.0) - frame.clipFromView[3].xyz) / vec3(frame.clipFromView[0][0], frame.clipFromView[1][1], frame.clipFromView[2][2]);
    vec3 origin = (object.localFromWorld * (frame.worldFromView * vec4(view, 1.0))).xyz;
    vec3 d = mat3(object.localFromWorld) * (mat3(frame.worldFromView) * vec3(0.0, 0.0, -1.0));
    float perMeter = length(d);
    vec2 span = rayBox(origin, d / perMeter, object.boxLow, object.boxHigh);
    if (span.x > span.y) discard;
    MarchSettings s = tableSettings(span.x, span.y, 0.0);
    // Parallel rays: half a texel is as wide everywhere.
    s.toleranceFloor = 0.25 / (frame.clipFromView[0][0] * frame.size.x * object.largestScale);
    March march = sphereTrace(origin, d / perMeter, s);
    if (!march.hit) discard;
    float z = view.z - march.t / perMeter;
    gl_FragDepth = frame.clipFromView[2][2] * z + frame.clipFromView[3][2];
}

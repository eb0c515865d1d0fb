// Parallel rays of the sun in the object's own space, for its shadow.
#include "kit/sdf/object.glsl"

struct SunRay {
    vec3 origin;
    vec3 direction;  // unit length
    float perMeter;  // local length per meter of the world
    float viewZ;     // view-space z of its start
    vec2 span;       // interval inside the box
};

SunRay sunRay(vec2 fragCoord)
{
    vec2 ndc = framePixel(fragCoord) * frame.inverseSize * 2.0 - 1.0;
    // The view is orthographic: undo scale and translation of each axis; start where depth is 1.
    vec3 view = (vec3(ndc, 1.0) - frame.clipFromView[3].xyz) / vec3(frame.clipFromView[0][0], frame.clipFromView[1][1], frame.clipFromView[2][2]);
    SunRay ray;
    ray.origin = (object.localFromWorld * (frame.worldFromView * vec4(view, 1.0))).xyz;
    vec3 d = mat3(object.localFromWorld) * (mat3(frame.worldFromView) * vec3(0.0, 0.0, -1.0));
    ray.perMeter = length(d);
    ray.direction = d / ray.perMeter;
    ray.viewZ = view.z;
    ray.span = rayBox(ray.origin, ray.direction, object.boxLow, object.boxHigh);
    return ray;
}

MarchSettings sunSettings(SunRay ray)
{
    MarchSettings s = tableSettings(ray.span.x, ray.span.y, 0.0);
    // Parallel rays: half a texel has the same width everywhere.
    s.toleranceFloor = 0.25 / (frame.clipFromView[0][0] * frame.size.x * object.largestScale);
    return s;
}

// Depth in the shadow map at `t` (local) along the ray.
float sunDepth(SunRay ray, float t)
{
    return frame.clipFromView[2][2] * (ray.viewZ - t / ray.perMeter) + frame.clipFromView[3][2];
}

// Draws the object into the sun's shadow map, by the sun's parallel rays. The depth is that of the hit, not of the
// bounding mesh.
#include "kit/sdf/sun_ray.glsl"

layout(depth_any) out float gl_FragDepth;

void main()
{
    SunRay ray = sunRay(gl_FragCoord.xy);
    if (ray.span.x > ray.span.y) discard;
    March march = sphereTrace(ray.origin, ray.direction, sunSettings(ray));
    if (!march.hit) discard;
    gl_FragDepth = sunDepth(ray, march.t);
}

// The object in the sun's depth map, by the sun's own parallel rays; depth is where they hit, not where
// the bounding mesh is.
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

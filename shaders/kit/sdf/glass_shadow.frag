// What the object, where it is glass, leaves of the sun's light, by the sun's own parallel rays: color, and the depth
// from which on it does. Light that the glass bends away is lost to its shadow; where it gathers is not known.
#include "kit/sdf/sun_ray.glsl"
#include "kit/sdf/glass_path.glsl"

layout(location = 0) out vec4 transmitted;

// Cosines of the angles from the sun's own direction: bent by less, light falls where the shadow is, and by more, it
// falls elsewhere.
const float BENT_LITTLE = 0.97;
const float BENT_FAR = 0.80;

void main()
{
    SunRay ray = sunRay(gl_FragCoord.xy);
    if (ray.span.x > ray.span.y) discard;
    MarchSettings settings = sunSettings(ray);
    March march = sphereTrace(ray.origin, ray.direction, settings);
    if (!march.hit) discard;
    Hit hit = findHit(ray.origin, ray.direction, march, settings);
    vec3 direction = normalize(mat3(object.worldFromLocal) * ray.direction);
    GlassPath path = throughGlass(direction, hit, settings);
    float kept = smoothStep(BENT_FAR, BENT_LITTLE, dot(direction, path.direction));
    transmitted = vec4(path.throughput * kept, sunDepth(ray, march.t));
}

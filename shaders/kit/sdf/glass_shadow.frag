// Shadow of a glass object in the sun's light, by the sun's parallel rays: transmitted color, and the depth from which
// it applies. Light that the glass refracts strongly is missing in its shadow; caustics are not computed.
#include "kit/sdf/sun_ray.glsl"
#include "kit/sdf/glass_path.glsl"

layout(location = 0) out vec4 transmitted;

// Cosines of the deflection of sunlight. With a smaller angle, light still falls into the shadow; with a larger angle,
// it falls elsewhere.
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

// Computes the running sum on a log-polar grid around the sun; each invocation processes one line outwards. The weight
// is a power of the radius, so the mean C inside a radius obeys C' = q C + (1 - q) M. q depends only on the ratio of
// the radii. C stays between the smallest and the largest M and cannot overflow.
#include "crepuscular_rays/gather.glsl"

layout(local_size_x = 32) in;
layout(rgba16f, binding = 0) uniform writeonly image2D within;

// Radius at which a line from the sun leaves the mask.
float exitRadius(vec2 direction)
{
    vec2 size = vec2(textureSize(mask, 0));
    vec2 safe = mix(direction, vec2(1e-6), lessThan(abs(direction), vec2(1e-6)));
    vec2 far = max((vec2(0.5) - rays.sun) / safe, (size - 0.5 - rays.sun) / safe);
    return min(far.x, far.y);
}

void main()
{
    int line = int(gl_GlobalInvocationID.x);
    int radii = rays.radii;
    if (line >= rays.angles) return;
    float angle = rays.firstAngle + rays.angleSpan * (float(line) + 0.5) / float(rays.angles);
    vec2 direction = vec2(cos(angle), sin(angle));
    float ratio = exp(rays.logRadiusSpan / float(rays.radii));
    float keep = rays.keep;
    float middle = shaftTapPlace(1.0 / ratio, rays.exponent, 0.5);
    // Inside the first radius, and where the mask is unknown, the first value is used.
    float radius = exp(rays.logFirstRadius);
    // A cell that extends beyond the edge uses the value at the edge, because its pixels lie inside.
    float exit = exitRadius(direction);
    vec3 mean = maskAt(rays.sun + direction * radius);
    for (int i = 0; i < radii; ++i) {
        mean = mean * keep + maskAt(rays.sun + direction * min(radius * middle, max(exit, 0.0))) * (1.0 - keep);
        imageStore(within, ivec2(i, line), vec4(mean, 1.0));
        radius *= ratio;
    }
}

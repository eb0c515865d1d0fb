// Screen-space rays (McGuire and Mara 2014, "Efficient GPU Screen-Space Ray Tracing"): marches a ray in the depth buffer
// of the picture of everything opaque.
layout(binding = UNIT_BACKDROP) uniform sampler2D backdrop;
layout(binding = UNIT_BACKDROP_DEPTH) uniform sampler2D backdropDepth;

const int BACKDROP_STEPS = 40;
const int BACKDROP_HALVINGS = 5;

// Ray in the picture. Position and reciprocal of the depth are linear along it.
struct ScreenRay {
    vec2 uv, uvStep;
    float inverseDepth, inverseDepthStep;  // 1/m
};

vec2 onScreen(vec4 clip)
{
    return clip.xy / clip.w * 0.5 + 0.5;
}

// Returns the ray from `world` to where it leaves the picture, or comes as close to the eye's plane as can be drawn. A
// ray that goes away from the eye ends at infinity.
ScreenRay screenRay(vec3 world, vec3 direction)
{
    vec4 start = frame.clipFromWorld * vec4(world, 1.0);
    vec4 onward = frame.clipFromWorld * vec4(direction, 0.0);
    ScreenRay ray;
    ray.uv = onScreen(start);
    ray.inverseDepth = 1.0 / start.w;
    vec4 end = onward;
    ray.inverseDepthStep = -ray.inverseDepth;
    if (onward.w < 1e-4) {
        float reach = onward.w > -1e-4 ? 20.0 : min(20.0, 0.98 * (start.w - frame.nearPlane) / -onward.w);
        end = start + onward * max(reach, 0.0);
        ray.inverseDepthStep = 1.0 / end.w - ray.inverseDepth;
    }
    ray.uvStep = onScreen(end) - ray.uv;
    vec2 wall = mix(vec2(0.0), vec2(1.0), greaterThan(ray.uvStep, vec2(0.0)));
    vec2 leaves = mix(vec2(1.0), (wall - ray.uv) / ray.uvStep, greaterThan(abs(ray.uvStep), vec2(1e-7)));
    float shortened = clamp(min(leaves.x, leaves.y), 0.0, 1.0);
    ray.uvStep *= shortened;
    ray.inverseDepthStep *= shortened;
    return ray;
}

// Distance of the ray behind the surface drawn there, meters; negative in front of it.
float depthBehind(ScreenRay ray, float t)
{
    float drawn = frameViewDepth(textureLod(backdropDepth, ray.uv + t * ray.uvStep, 0.0).r);
    float inverse = ray.inverseDepth + t * ray.inverseDepthStep;
    return inverse > 0.0 ? 1.0 / inverse - drawn : (isinf(drawn) ? -1.0 : 1e9);
}

// Parameter (0 to 1) at which the ray hits the drawn surfaces; negative if it hits none.
float screenHit(ScreenRay ray)
{
    if (any(lessThan(ray.uv, vec2(0.0))) || any(greaterThan(ray.uv, vec2(1.0))) || !(ray.inverseDepth > 0.0)) return -1.0;
    // A ray that moves by less than a pixel can only see what is drawn in its pixel.
    vec2 pixels = ray.uvStep * vec2(textureSize(backdrop, 0));
    if (dot(pixels, pixels) < 1.0) return 0.0;
    bool before = depthBehind(ray, 0.0) <= 0.0;
    for (int i = 1; i <= BACKDROP_STEPS; ++i) {
        float far = float(i) / float(BACKDROP_STEPS);
        bool behind = depthBehind(ray, far) > 0.0;
        if (before && behind) {
            float near = far - 1.0 / float(BACKDROP_STEPS);
            for (int k = 0; k < BACKDROP_HALVINGS; ++k) {
                float middle = 0.5 * (near + far);
                if (depthBehind(ray, middle) > 0.0) far = middle;
                else near = middle;
            }
            float inverse = ray.inverseDepth + far * ray.inverseDepthStep;
            // A ray that passes behind an edge has not hit the surface.
            if (depthBehind(ray, far) * inverse < 0.06) return far;
        }
        before = !behind;
    }
    return before && ray.inverseDepth + ray.inverseDepthStep <= 1e-6 ? 1.0 : -1.0;
}

// Part of the way from the eye to the hit, 0 to 1, that lies behind the start of the ray.
float wayBehind(ScreenRay ray, float t)
{
    float inverse = ray.inverseDepth + t * ray.inverseDepthStep;
    return max(1.0 - inverse / ray.inverseDepth, 0.0);
}

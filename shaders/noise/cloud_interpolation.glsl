// Clouds between the rays of noise/clouds_half.frag. Permutation: WITH_DISTANCE.
layout(binding = UNIT_EXHIBIT_C) uniform sampler2D halfLight;
#ifdef WITH_DISTANCE
layout(binding = UNIT_SOURCE) uniform sampler2D halfDistance;
#endif

// Position in the picture of half the size, pixels.
vec2 halfPixel()
{
    return 0.5 * (gl_FragCoord.xy - work.halfOrigin);
}

// Interpolates the clouds of the four nearest rays before `behind`. Returns whether that may be shown: whether all four
// meet the opening, and what they show differs by at most the tolerance.
bool interpolatedClouds(vec3 behind, out CloudLight clouds)
{
    vec2 at = halfPixel() - 0.5;
    ivec2 first = ivec2(floor(at));
    vec2 share = at - floor(at);
    vec4 light = vec4(0.0);
    vec2 distance = vec2(0.0);
    vec3 low = vec3(1.0);
    vec3 high = vec3(0.0);
    bool all = true;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i % 2, i / 2);
        vec2 near = mix(1.0 - share, share, vec2(corner));
        float weight = near.x * near.y;
        vec4 texel = texelFetch(halfLight, first + corner, 0);
        all = all && texel.a >= 0.0;
        light += weight * texel;
        // As a share of white: whatever is brighter than white saturates.
        vec3 shown = texel.rgb + texel.a * behind;
        shown /= 1.0 + shown;
        low = min(low, shown);
        high = max(high, shown);
#ifdef WITH_DISTANCE
        float cover = weight * (1.0 - texel.a);
        distance += cover * vec2(texelFetch(halfDistance, first + corner, 0).r, 1.0);
#endif
    }
    clouds = CloudLight(light.rgb, light.a, distance.x / max(distance.y, 1e-6));
    vec3 difference = high - low;
    return all && max(max(difference.r, difference.g), difference.b) <= parameters.cloudTolerance;
}

// Lookups of the ray of this pixel's block in the picture of half the size.
float evaluationsOfHalf()
{
#ifdef WITH_DISTANCE
    return texelFetch(halfDistance, ivec2(halfPixel()), 0).g;
#else
    return 0.0;
#endif
}

// Smooths faceted normals: the mean over nearby texels on nearly the same plane with nearly the same normal.
#include "pixel_art/picture.glsl"
#include "pixel_art/surface.glsl"

layout(binding = UNIT_NORMAL) uniform sampler2D facets;
layout(location = 0) out vec4 surfaceOut;

// Weight of a texel: by its distance, if its plane and that of the middle texel belong to one curved surface.
float weightOf(DepthLens lens, ivec2 q, Surface there, vec3 middle, vec3 place, float width)
{
    if (there.id < 0.5) return 0.0;
    vec3 away = positionAt(lens, q, there.depth) - place;
    float off = abs(dot(away, unitOrFacing(middle + there.normal)));
    float texels = length(away) / width;
    float flatness = 1.0 - smoothstep(0.15, 0.4, off / (width * max(texels, 1.0)));
    float alike = smoothstep(0.6, 0.85, dot(middle, there.normal));
    float radius = float(parameters.smoothing);
    return flatness * alike * exp(-texels * texels / (radius * radius));
}

void main()
{
    DepthLens lens = pictureLens();
    ivec2 p = ivec2(gl_FragCoord.xy);
    surfaceOut = texelFetch(facets, p, 0);
    Surface middle = surfaceOf(surfaceOut);
    if (middle.id < 0.5) return;
    vec3 place = positionAt(lens, p, middle.depth);
    float width = texelWidth(lens, middle.depth);
    int radius = parameters.smoothing;
    vec3 sum = middle.normal;
    // Opposite texels are used in pairs only: at a border, texels of one side alone would turn the mean.
    for (int y = 0; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            if (y == 0 && x <= 0) continue;
            ivec2 away = ivec2(x, y);
            ivec2 one = p + away;
            ivec2 other = p - away;
            if (!isInside(lens, one) || !isInside(lens, other)) continue;
            Surface there = surfaceOf(texelFetch(facets, one, 0));
            Surface opposite = surfaceOf(texelFetch(facets, other, 0));
            float weight = min(weightOf(lens, one, there, middle.normal, place, width),
                               weightOf(lens, other, opposite, middle.normal, place, width));
            sum += weight * (there.normal + opposite.normal);
        }
    }
    surfaceOut = packedSurface(unitOrFacing(sum), middle.id, middle.depth);
}

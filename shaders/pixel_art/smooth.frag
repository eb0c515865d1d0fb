// Faceted normals made smooth: the mean of those around that lie on nearly the same plane and look nearly the same way.
#include "pixel_art/picture.glsl"

layout(binding = UNIT_NORMAL) uniform sampler2D normals;
layout(location = 0) out vec4 normalOut;

// How much a texel counts: by its distance, where its plane and that of the middle are of one curve.
float weightOf(DepthLens lens, ivec2 q, vec4 middle, vec3 place, float width)
{
    vec4 n = texelFetch(normals, q, 0);
    if (n.a < 0.5) return 0.0;
    vec3 away = positionAt(lens, q, depthAt(q)) - place;
    float off = abs(dot(away, unitOrFacing(middle.xyz + n.xyz)));
    float texels = length(away) / width;
    float flatness = 1.0 - smoothstep(0.15, 0.4, off / (width * max(texels, 1.0)));
    float alike = smoothstep(0.6, 0.85, dot(middle.xyz, n.xyz));
    float radius = float(parameters.smoothing);
    return flatness * alike * exp(-texels * texels / (radius * radius));
}

void main()
{
    DepthLens lens = pictureLens();
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec4 middle = texelFetch(normals, p, 0);
    normalOut = middle;
    if (middle.a < 0.5) return;
    float depth = depthAt(p);
    vec3 place = positionAt(lens, p, depth);
    float width = texelWidth(lens, depth);
    int radius = parameters.smoothing;
    vec3 sum = middle.xyz;
    // Opposite texels count together or not at all: at a border, those of one side alone would turn the mean.
    for (int y = 0; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            if (y == 0 && x <= 0) continue;
            ivec2 away = ivec2(x, y);
            ivec2 one = p + away;
            ivec2 other = p - away;
            if (!isInside(lens, one) || !isInside(lens, other)) continue;
            float weight = min(weightOf(lens, one, middle, place, width), weightOf(lens, other, middle, place, width));
            sum += weight * (texelFetch(normals, one, 0).xyz + texelFetch(normals, other, 0).xyz);
        }
    }
    normalOut = vec4(unitOrFacing(sum), middle.a);
}

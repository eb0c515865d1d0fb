// Painted patterns of the small world's surfaces: flat tones and a few marks, each at least as large as a texel.
#define PATTERN_PLAIN 0
#define PATTERN_CHECKER 1
#define PATTERN_GRASS 2
#define PATTERN_WATER 3
#define PATTERN_BRICKS 4
#define PATTERN_LEAVES 5
#define PATTERN_PLANKS 6
#define PATTERN_ROCK 7

struct PatternedColor {
    vec3 color;
    float glow;
};

float cellHash(ivec3 cell)
{
    return float(pcg(uint(cell.x) * 73856093u ^ uint(cell.y) * 19349663u ^ uint(cell.z) * 83492791u) & 0xFFFFu) / 65535.0;
}

// Smooth noise between cells of size 1, 0 to 1.
float patchNoise(vec2 p)
{
    vec2 c = floor(p);
    vec2 f = p - c;
    f = f * f * (3.0 - 2.0 * f);
    ivec3 i = ivec3(ivec2(c), 7);
    float low = mix(cellHash(i), cellHash(i + ivec3(1, 0, 0)), f.x);
    float high = mix(cellHash(i + ivec3(0, 1, 0)), cellHash(i + ivec3(1, 1, 0)), f.x);
    return mix(low, high, f.y);
}

vec3 grassColor(vec3 color, vec3 p)
{
    float meadow = patchNoise(p.xz * 0.9) * 0.6 + patchNoise(p.xz * 2.3 + 9.0) * 0.4;
    color *= meadow > 0.56 ? vec3(1.16, 1.12, 0.9) : meadow < 0.38 ? vec3(0.78, 0.87, 0.96) : vec3(1.0);
    // Tufts: two texels wide, in loose rows.
    ivec3 cell = ivec3(floor(vec3(p.x * 6.0, p.y, p.z * 6.0)));
    float h = cellHash(cell);
    if (h > 0.93) return color * vec3(0.62, 0.78, 0.8);
    if (h < 0.012) return vec3(0.9, 0.72, 0.2);
    if (h < 0.022) return vec3(0.85, 0.8, 0.78);
    return color;
}

// Water: shallow near the shore, deep farther out, with pulsing lines of foam and rows of glints.
PatternedColor waterColor(vec3 color, vec3 p, vec2 shore, float time)
{
    PatternedColor made;
    float away = shore.x;
    float around = shore.y;
    float wave = 0.07 * sin(6.2832 * (time / 4.0) + around * 9.0) + 0.05 * sin(around * 31.0 - 6.2832 * time / 2.0);
    float depth = smoothstep(0.0, 2.4, away + 0.5 * (patchNoise(p.xz * 0.8) - 0.5));
    made.color = mix(vec3(0.075, 0.36, 0.36), color, floor(depth * 4.0 + 0.5) / 4.0);
    made.glow = 0.0;
    float line = abs(away - 0.42 - 1.3 * wave);
    float broken = patchNoise(vec2(around * 26.0, time * 0.5));
    if (away < 0.14 + wave || (line < 0.035 && broken > 0.42)) made.color = vec3(0.78, 0.92, 0.88);
    // Glints: short dashes across the view, which blink periodically.
    ivec3 cell = ivec3(floor(vec3((p.x - p.z) * 1.9, 0.0, (p.x + p.z) * 5.0)));
    float h = cellHash(cell);
    float beat = fract(h * 61.0 + time / 4.0);
    if (away > 0.75 && h > 0.968 && beat < 0.55) made.color = mix(made.color, vec3(0.3, 0.62, 0.66), 0.4);
    return made;
}

vec3 bricks(vec3 color, vec2 uv, vec2 size, float tint)
{
    vec2 at = uv / size;
    float row = floor(at.y);
    at.x += 0.5 * mod(row, 2.0);
    vec2 within = fract(at);
    float h = cellHash(ivec3(int(floor(at.x)), int(row), 3));
    color *= 1.0 + tint * (floor(h * 3.0) - 1.0);
    return within.y > 0.8 || within.x > 0.9 ? color * vec3(0.74, 0.72, 0.82) : color;
}

PatternedColor patterned(int pattern, vec3 color, vec3 p, vec2 uv, float time)
{
    PatternedColor made = PatternedColor(color, 0.0);
    if (pattern == PATTERN_CHECKER) {
        ivec2 cell = ivec2(floor(uv));
        bool light = ((cell.x + cell.y) & 1) == 0;
        float worn = cellHash(ivec3(cell, 11));
        made.color *= light ? vec3(1.0) : vec3(0.66, 0.64, 0.72);
        if (worn > 0.85) made.color *= 0.9;
        vec2 within = fract(uv);
        if (worn < 0.1 && within.x + within.y > 1.55) made.color *= vec3(0.6, 0.8, 0.45);
    } else if (pattern == PATTERN_GRASS) {
        made.color = grassColor(color, p);
    } else if (pattern == PATTERN_WATER) {
        made = waterColor(color, p, uv, time);
    } else if (pattern == PATTERN_BRICKS) {
        made.color = bricks(color, uv, vec2(0.44, 0.26), 0.09);
    } else if (pattern == PATTERN_LEAVES) {
        float h = cellHash(ivec3(floor(p * 7.0)));
        made.color *= h > 0.8 ? vec3(1.28, 1.22, 0.95) : h < 0.2 ? vec3(0.72, 0.82, 0.95) : vec3(1.0);
    } else if (pattern == PATTERN_PLANKS) {
        float h = cellHash(ivec3(int(floor(uv.x / 0.26)), 5, 2));
        made.color *= 1.0 + 0.12 * (floor(h * 3.0) - 1.0);
        if (fract(uv.x / 0.26) > 0.78) made.color *= 0.6;
    } else if (pattern == PATTERN_ROCK) {
        float strata = patchNoise(vec2(uv.x * 1.7, uv.y * 4.0));
        made.color *= strata > 0.6 ? vec3(1.15, 1.1, 1.0) : strata < 0.35 ? vec3(0.8, 0.8, 0.9) : vec3(1.0);
    }
    return made;
}

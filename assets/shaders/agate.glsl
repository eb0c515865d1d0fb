// Agate: bands of a stone, cut and polished. Code for Shadertoy. Sliders stand in #iUniform lines, as some editors have
// them.
#iUniform float bands = 11.0 in {2.0, 40.0}
#iUniform float folds = 1.15 in {0.0, 3.0}
#iUniform float growth = 0.05 in {0.0, 0.5}
#iUniform color3 core = color3(0.96, 0.86, 0.72)
#iUniform color3 rind = color3(0.45, 0.13, 0.09)
#iUniform int octaves = 5 in {1, 8}

float random(ivec2 cell)
{
    uint h = uint(cell.x) * 0x9E3779B9u ^ uint(cell.y) * 0x85EBCA6Bu;
    h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12u)) * 0x297A2D39u;
    return float((h ^ (h >> 15u)) >> 8u) / 16777216.0;
}

float noise(vec2 p)
{
    ivec2 c = ivec2(floor(p));
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(random(c), random(c + ivec2(1, 0)), f.x), mix(random(c + ivec2(0, 1)), random(c + ivec2(1, 1)), f.x), f.y);
}

float layered(vec2 p)
{
    float sum = 0.0, share = 0.5;
    for (int i = 0; i < octaves; ++i) {
        sum += share * noise(p);
        p = mat2(1.6, 1.2, -1.2, 1.6) * p + 3.7;
        share *= 0.5;
    }
    return sum;
}

// Distance from the core of the stone, folded.
float depth(vec2 p)
{
    vec2 q = vec2(layered(p * 1.3 + 1.0), layered(p * 1.3 + 8.2));
    return length(p * vec2(0.8, 1.05)) + folds * (layered(p * 1.1 + 1.8 * q) - 0.5) + growth * iTime;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 p = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    // While the button is held, the mouse moves the core.
    if (iMouse.z > 0.0) p -= (2.0 * iMouse.xy - iResolution.xy) / iResolution.y;
    float d = depth(p);
    float at = d * bands;
    float band = floor(at), inBand = fract(at);
    float tone = 0.5 + 0.5 * sin(band * 2.4) * random(ivec2(int(band), 7));
    vec3 color = mix(core, rind, clamp(0.75 * tone + 0.32 * d, 0.0, 1.0));
    color = mix(color, vec3(0.93, 0.94, 0.95), 0.75 * step(0.82, random(ivec2(int(band), 31))));
    // Each band is darker at its border, and the polish mirrors a window.
    color *= 0.8 + 0.2 * smoothstep(0.0, 0.16, inBand) * smoothstep(1.0, 0.7, inBand);
    vec2 slope = vec2(depth(p + vec2(0.01, 0.0)) - d, depth(p + vec2(0.0, 0.01)) - d) / 0.01;
    float gloss = pow(clamp(dot(normalize(vec3(-0.25 * slope, 1.0)), normalize(vec3(-0.3, 0.45, 0.85))), 0.0, 1.0), 60.0);
    color += 0.22 * gloss;
    color *= 1.0 - 0.16 * dot(p, p) * 0.5;
    fragColor = vec4(clamp(color, 0.0, 1.0), 1.0);
}

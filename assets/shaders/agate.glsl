// Agate: a slab of stone, cut, polished and lit from behind, with crystals in its hollow. Code for Shadertoy. Sliders
// stand in #iUniform lines, as some editors have them. While the button is held, the mouse moves the hollow.
#iUniform float bands = 9.0 in {2.0, 24.0} // 2 .. 24, default 9, "Number of bands"
#iUniform float folds = 0.85 in {0.0, 1.6} // 0 .. 1.6, default 0.85, "Folds"
#iUniform float growth = 0.04 in {0.0, 0.3} // 0 .. 0.3, default 0.04, "Speed of growth"
#iUniform float hollow = 0.27 in {0.0, 0.6} // 0 .. 0.6, default 0.27, "Size of the hollow"
#iUniform color3 rind = color3(0.55, 0.20, 0.07)
#iUniform color3 body = color3(0.17, 0.36, 0.52)
#iUniform color3 crystal = color3(0.58, 0.36, 0.80)
#iUniform int octaves = 4 in {1, 8} // 1 .. 8, default 4, exact 8, "Octaves of the folds"

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
    f = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    return mix(mix(random(c), random(c + ivec2(1, 0)), f.x), mix(random(c + ivec2(0, 1)), random(c + ivec2(1, 1)), f.x), f.y);
}

float layered(vec2 p, float gain)
{
    float sum = 0.0, share = 0.5;
    for (int i = 0; i < octaves; ++i) {
        sum += share * noise(p);
        p = mat2(1.6, 1.2, -1.2, 1.6) * p + 3.7;
        share *= gain;
    }
    return sum;
}

// Depth below the rind: about 1 at the edge of the slab, 0 in the middle.
float depth(vec2 p)
{
    vec2 q = p * vec2(0.66, 0.98) + 0.05 * vec2(p.y, -p.x);
    vec2 warp = vec2(noise(p * 1.3 + 1.0), noise(p * 1.3 + 8.2)) - 0.5;
    // A norm between circle and diamond has the blunt corners of such stones.
    float r = mix(length(q), (abs(q.x) + abs(q.y)) * 0.78, 0.35);
    return r + folds * (layered(p * 1.5 + 1.4 * warp + 2.0, 0.34) - 0.38);
}

// Noise along a line, without what is finer than `width`.
float layer(float at, int row, float width)
{
    int cell = int(floor(at));
    float f = fract(at);
    f = smoothstep(0.5 - max(0.22, width), 0.5 + max(0.22, width), f);
    float value = mix(random(ivec2(cell, row)), random(ivec2(cell + 1, row)), f);
    return mix(value, 0.5, smoothstep(0.45, 1.2, width));
}

// Color of the bands at a depth; `width` is the depth that a pixel spans.
vec3 banded(float d, float width)
{
    float at = d * bands + growth * iTime * bands;
    width *= bands;
    float wide = layer(at, 1, width), middle = layer(3.1 * at, 2, 3.1 * width), fine = layer(9.7 * at, 3, 9.7 * width);
    float hair = layer(27.0 * at, 4, 27.0 * width);
    float tone = 0.50 * wide + 0.28 * middle + 0.15 * fine + 0.07 * hair;
    vec3 milk = vec3(0.93, 0.94, 0.92);
    vec3 stone = mix(body * body, milk, smoothstep(0.32, 0.78, tone));
    // Iron has stained some layers, and most of those near the rind.
    float iron = smoothstep(0.62, 0.80, 0.6 * layer(at + 40.0, 5, width) + 0.5 * fine + 0.55 * smoothstep(0.55, 1.0, d) - 0.12);
    stone = mix(stone, rind * (0.35 + 1.1 * tone), iron);
    return stone * (0.72 + 0.5 * middle);
}

// Crystals that point into the hollow: the nearest of scattered points has a facet with a tilt of its own.
vec3 crystals(vec2 p, float d, vec2 inward)
{
    vec2 at = p * 21.0;
    ivec2 cell = ivec2(floor(at));
    float nearest = 9.0, second = 9.0;
    ivec2 mine = cell;
    for (int i = 0; i < 9; ++i) {
        ivec2 c = cell + ivec2(i % 3 - 1, i / 3 - 1);
        vec2 away = at - vec2(c) - 0.15 - 0.7 * vec2(random(c), random(c + 71));
        float distance = dot(away, away);
        if (distance < nearest) {
            second = nearest;
            nearest = distance;
            mine = c;
        } else {
            second = min(second, distance);
        }
    }
    float turn = 6.2832 * random(mine + 13);
    vec3 n = normalize(vec3(0.75 * vec2(cos(turn), sin(turn)) - 0.55 * inward, 1.0));
    // The light wanders, so that facets flash one after another.
    vec3 lamp = normalize(vec3(0.8 * cos(0.35 * iTime), 0.6 + 0.4 * sin(0.27 * iTime), 0.9));
    float facet = max(dot(n, lamp), 0.0);
    float edge = smoothstep(0.0, 0.22, sqrt(second) - sqrt(nearest));
    float inside = smoothstep(0.0, 1.0, d / max(hollow, 1e-3));
    vec3 color = crystal * crystal * (0.12 + 0.95 * facet) * mix(0.10, 1.0, inside * inside);
    color += vec3(1.0, 0.96, 1.0) * (0.9 * pow(facet, 24.0) + 0.10 * (1.0 - edge) * inside) * (0.25 + 0.75 * inside);
    return color;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 p = 1.2 * (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    if (iMouse.z > 0.0) p -= 1.2 * (2.0 * iMouse.xy - iResolution.xy) / iResolution.y;
    const float e = 0.004;
    float d = depth(p);
    vec2 slope = vec2(depth(p + vec2(e, 0.0)) - d, depth(p + vec2(0.0, e)) - d) / e;
    float pixel = 2.4 / iResolution.y, steep = max(length(slope), 0.15), width = pixel * steep;

    // The stone, its crystals, and the line of quartz where they grow.
    float light = 0.80 + 0.45 * noise(2.3 * p + 5.0) - 0.18 * d;
    vec3 stone = banded(d, width) * light;
    float quartz = smoothstep(0.085, 0.0, d - hollow);
    stone = mix(stone, vec3(0.90, 0.90, 0.94) * (0.62 + 0.5 * layer(60.0 * d, 6, 60.0 * width)), 0.75 * quartz);
    if (d < hollow + width) stone = mix(crystals(p, d, slope / steep), stone, smoothstep(hollow - width, hollow + width, d));
    // The polished face mirrors a window, softly.
    vec2 pane = p - vec2(-0.75, 0.62) - 0.05 * slope;
    pane = mat2(0.92, -0.38, 0.38, 0.92) * pane;
    float window = smoothstep(0.30, 0.16, abs(pane.x)) * smoothstep(0.34, 0.20, abs(pane.y)) * smoothstep(0.006, 0.03, abs(pane.x));
    stone += 0.085 * window * smoothstep(hollow, hollow + 0.02, d);

    // Rough rind, and the dark cloth with the glow of the slab on it.
    float edge = 1.0 + 0.03 * (0.6 * noise(17.0 * p) + 0.4 * noise(43.0 * p) - 0.5);
    stone = mix(stone, 0.30 * rind * rind * (0.15 + 0.8 * noise(31.0 * p) + 0.7 * noise(67.0 * p)), smoothstep(edge - 0.05, edge - 0.03, d));
    vec3 cloth = vec3(0.0050, 0.0052, 0.0062) * (0.6 + 0.8 * noise(p * 150.0)) + 0.030 * body * body * exp(-7.0 * (d - edge));
    vec3 color = mix(stone, cloth, smoothstep(edge - 0.5 * width, edge + 1.5 * width, d));
    color = pow(clamp(1.0 - exp(-1.55 * color), 0.0, 1.0), vec3(1.0 / 2.2));
    fragColor = vec4(color + (random(ivec2(fragCoord)) - 0.5) / 255.0, 1.0);
}

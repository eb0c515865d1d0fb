// Rose window: stained glass in stone, with the sun behind it. Code for Shadertoy. While the button is held, the mouse
// moves the sun.
#iUniform int petals = 12 in {8, 24} // 8 .. 24, default 12, "Number of petals"
#iUniform float lead = 1.0 in {0.3, 3.0} // 0.3 .. 3, default 1, "Width of the lead"
#iUniform float panes = 1.0 in {0.5, 2.0} // 0.5 .. 2, default 1, "Fineness of the panes"
#iUniform float hue = 0.0 in {0.0, 1.0} // 0 .. 1, default 0, "Shift of the colors"
#iUniform float sun = 1.0 in {0.0, 2.0} // 0 .. 2, default 1, "Strength of the sun"
#iUniform float wander = 0.25 in {0.0, 1.0} // 0 .. 1, default 0.25, "Speed of the sun"
#iUniform int beams = 16 in {0, 128} // 0 .. 128, default 16, exact 128, "Samples along a beam"

const float tau = 6.2831853;

float random(vec2 p)
{
    vec3 q = fract(vec3(p.xyx) * vec3(0.1031, 0.1030, 0.0973));
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}

float noise(vec2 p)
{
    vec2 c = floor(p), f = p - c;
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(random(c), random(c + vec2(1.0, 0.0)), f.x), mix(random(c + vec2(0.0, 1.0)), random(c + vec2(1.0)), f.x), f.y);
}

// A sector of a wheel of `count` parts: coordinates along and across its middle, and its number.
vec3 sector(vec2 p, float count, float turn)
{
    float angle = atan(p.y, p.x) / tau + turn, number = floor(angle * count + 0.5);
    float off = (angle * count - number) / count * tau;
    return vec3(length(p) * vec2(cos(off), sin(off)), mod(number, count));
}

float circle(vec2 p, float r) { return length(p) - r; }

// A petal of a rose: two arcs that meet in a point at the rim and in the middle.
float petal(vec2 p, float from, float to, float wide)
{
    float middle = 0.5 * (from + to), half_ = 0.5 * (to - from);
    vec2 q = vec2(abs(p.y), p.x - middle);
    float r = (half_ * half_ + wide * wide) / (2.0 * wide);
    return length(q + vec2(r - wide, 0.0)) - r;
}

vec3 glassColor(float kind, float number)
{
    // Cobalt, ruby, gold and green, as medieval workshops had them.
    float pick = fract(0.618034 * number + 0.31 * kind + hue);
    vec3 color = mix(vec3(0.02, 0.07, 0.62), vec3(0.72, 0.015, 0.03), smoothstep(0.36, 0.40, pick));
    color = mix(color, vec3(0.95, 0.52, 0.05), smoothstep(0.68, 0.72, pick));
    color = mix(color, vec3(0.03, 0.40, 0.16), smoothstep(0.88, 0.92, pick));
    return color;
}

// Light that the window lets through at a point: the color of the glass, black where lead and stone are. `stone` is the
// distance into the stone, positive outside of every opening.
vec3 window(vec2 p, float pixel, out float stone)
{
    float r = length(p), count = float(petals);
    // Openings in the stone: the eye, the petals, and two rings of circles.
    vec3 s = sector(p, count, 0.0), between = sector(p, count, 0.5 / count), outer = sector(p, 2.0 * count, 0.25 / count);
    float step_ = tau / count;
    float eye = circle(p, 0.165), leaf = petal(s.xy, 0.185, 0.69, min(0.47 * step_ * 0.48, 0.14));
    float rose = circle(between.xy - vec2(0.635, 0.0), min(0.42 * step_ * 0.60, 0.095) * 0.70);
    float pearl = circle(outer.xy - vec2(0.772, 0.0), min(0.40 * step_ * 0.772 * 0.5, 0.06));
    float hem = abs(r - 0.895) - 0.045;
    stone = min(min(min(eye, leaf), min(rose, pearl)), hem);

    // Panes of glass between lead: each opening has its own pattern.
    float kind, number, lines;
    if (stone == eye) {
        vec3 inner = sector(p, 8.0, 0.0);
        float flower = circle(inner.xy - vec2(0.085, 0.0), 0.042);
        lines = min(abs(flower), abs(circle(p, 0.045)));
        kind = r < 0.045 ? 2.2 : flower < 0.0 ? 1.0 : 0.0;
        number = flower < 0.0 ? 2.0 : 0.0;
        if (flower > 0.0 && r > 0.045) lines = min(lines, abs(sector(p, 8.0, 0.0625).y));
    } else if (stone == leaf) {
        float rows = 9.0 * panes, row = s.x * rows + 2.2 * abs(s.y) * panes * 3.0;
        number = floor(row) + 3.0 * mod(s.z, 2.0);
        lines = min(abs(fract(row + 0.5) - 0.5) / rows * 0.8, abs(s.y));
        float heart = petal(s.xy, 0.36, 0.60, 0.055);
        if (heart < 0.0) {
            number = 1.0 + mod(s.z, 2.0);
            lines = -heart;
        }
        lines = min(lines, abs(heart));
        kind = heart < 0.0 ? 1.9 : 0.0;
    } else if (stone == rose) {
        vec2 q = between.xy - vec2(0.635, 0.0);
        vec3 four = sector(q, 4.0, 0.0);
        lines = min(abs(sector(q, 4.0, 0.125).y), abs(length(q) - 0.018));
        kind = length(q) < 0.018 ? 2.15 : 1.0;
        number = 1.0 + mod(four.z, 2.0);
    } else if (stone == pearl) {
        vec2 q = outer.xy - vec2(0.772, 0.0);
        lines = abs(length(q) - 0.022);
        kind = length(q) < 0.022 ? 2.15 : 0.0;
        number = mod(outer.z, 2.0) * 2.0 + 1.0;
    } else {
        float cells = 4.0 * count * panes, at = (atan(p.y, p.x) / tau + 0.5) * floor(cells);
        float ring = step(0.895, r);
        lines = min(abs(fract(at + 0.5 * ring + 0.5) - 0.5) / cells * tau * 0.895, abs(r - 0.895));
        number = floor(at + 0.5 * ring) * 2.0 + ring;
        kind = 0.5;
    }
    float tone = random(vec2(number, kind * 7.0) + floor(s.z) * 0.37);
    vec3 color = glassColor(kind, number) * (0.55 + 0.75 * tone);
    // Glass of uneven thickness, with streaks and bubbles.
    float thick = 0.6 * noise(p * 26.0 + 9.0 * tone) + 0.4 * noise(p * vec2(90.0, 55.0));
    color = mix(color, sqrt(color) * 0.9, 0.35 * thick * thick) * (0.72 + 0.5 * thick);
    float width = 0.0042 * lead;
    float open = smoothstep(width - pixel, width + pixel, lines) * smoothstep(0.004 + pixel, 0.004 - pixel, stone + 0.008);
    return color * open;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    float pixel = 1.06 / iResolution.y;
    vec2 p = 1.06 * (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec2 at = 0.62 * vec2(cos(wander * iTime + 0.9), 0.75 * sin(0.8 * wander * iTime + 1.0));
    if (iMouse.z > 0.0) at = 1.06 * (2.0 * iMouse.xy - iResolution.xy) / iResolution.y;
    float stone, unused;
    vec3 glass = window(p, pixel, stone);

    // The sky behind the glass: blue, and bright towards the sun.
    float away = length(p - at);
    vec3 sky = vec3(0.60, 0.76, 1.05) * (0.62 + 0.25 * p.y) + sun * vec3(1.0, 0.84, 0.58) * (3.4 * exp(-7.0 * away * away) + 0.8 * exp(-1.5 * away));
    vec3 color = 1.15 * glass * sky;

    // Stone: blocks of the wall, a molded ring around the window, and mullions with a rounded face.
    float r = length(p), relief = smoothstep(0.0, 0.022, stone);
    vec2 slope = vec2(0.0);
    float here, there;
    const float e = 0.004;
    window(p + vec2(e, 0.0), pixel, here);
    window(p + vec2(0.0, e), pixel, there);
    slope = vec2(here - stone, there - stone) / e * (1.0 - relief);
    if (r > 0.955) slope = 0.9 * p / r * sin(clamp((r - 0.955) / 0.085, 0.0, 1.0) * tau * 1.5) * step(r, 1.04);
    vec2 block = vec2(p.x * 3.1, p.y * 4.6);
    block.x += 0.5 * mod(floor(block.y), 2.0);
    vec2 joint = min(fract(block), 1.0 - fract(block));
    float mortar = r > 1.04 ? 0.45 + 0.55 * smoothstep(0.0, 0.045, joint.x) * smoothstep(0.0, 0.06, joint.y) : 1.0;
    float rough = 0.7 + 0.35 * noise(p * 38.0) + 0.25 * noise(p * 130.0) + (r > 1.04 ? 0.35 * random(floor(block)) - 0.15 : 0.0);
    vec3 n = normalize(vec3(-1.6 * slope, 1.0));
    // Light of candles from below, and what the glass throws onto the stone beside it.
    vec3 candles = vec3(0.060, 0.031, 0.014) * (0.15 + 1.1 * max(dot(n, normalize(vec3(-0.3, -0.8, 0.6))), 0.0));
    float spill = exp(-14.0 * max(stone, 0.0));
    vec3 wall = rough * mortar * (candles + vec3(0.006, 0.009, 0.020) + 0.035 * spill * sky * vec3(0.6, 0.5, 0.75));
    color += wall * smoothstep(-0.004, 0.006, stone + 0.004);

    // Beams: what the glass lets through towards the sun, smeared away from it.
    if (beams > 0) {
        float shift = fract(52.9829189 * fract(dot(floor(fragCoord), vec2(0.06711056, 0.00583715))));
        vec3 sum = vec3(0.0);
        for (int i = 0; i < beams; ++i) {
            float back = (float(i) + shift) / float(beams);
            vec2 q = mix(p, at, 0.62 * back);
            if (length(q) < 0.94) sum += window(q, 0.012, unused) * exp(-1.6 * back) * (0.35 + exp(-3.0 * dot(q - at, q - at)));
        }
        color += sun * 0.34 * sum / float(beams);
    }
    color = 1.0 - exp(-1.35 * color);
    color = pow(color, vec3(1.0 / 2.2));
    color = mix(color, color * color * (3.0 - 2.0 * color), 0.35) * (1.0 - 0.10 * dot(p, p));
    fragColor = vec4(color + (random(fragCoord) - 0.5) / 255.0, 1.0);
}

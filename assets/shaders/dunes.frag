// Dunes before sunset: a landscape that is marched by rays, with long shadows and sand that the wind carries. A plain
// fragment shader for glslViewer, in two passes: the first draws into a buffer, the second smooths its edges.
#ifdef GL_ES
precision highp float;
#endif

uniform vec2 u_resolution;
uniform float u_time;
uniform sampler2D u_buffer0;

uniform float u_sun_height; // 1 .. 60, default 12, deg, "Height of the sun"
uniform float u_sun_side;   // -180 .. 180, default 34, deg, "Direction of the sun"
uniform float u_height;     // 0 .. 20, default 11, m, "Height of the dunes"
uniform float u_ripples;    // 0 .. 2, default 1, "Ripples"
uniform float u_wind;       // 0 .. 2, default 0.6, "Sand in the wind"
uniform float u_haze;       // 0 .. 3, default 1, "Haze"
uniform float u_place;      // -500 .. 500, default 360, m, "Where the walk begins"
uniform float u_walk;       // 0 .. 8, default 1.2, "Speed of the walk"
uniform vec3 u_sand;        // 0 .. 1, default 0.90 0.62 0.38, "Sand"
uniform vec2 u_view;        // -1 .. 1, default 0 0, "View"

const int steps = 88; // 10 .. 400, default 88, exact 400, "Steps of a ray"
const int shadowSteps = 24; // 0 .. 200, default 24, exact 200, "Steps of a shadow"

const float farthest = 420.0;

float random(vec2 cell)
{
    vec3 p = fract(vec3(cell.xyx) * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yzx + 33.33);
    return fract((p.x + p.y) * p.z);
}

// The four corners of a cell share the parts of their hash that belong to its rows and columns.
float noise(vec2 p)
{
    vec2 c = floor(p), f = p - c;
    f = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    vec2 x = 50.0 * fract(0.3183099 * vec2(c.x, c.x + 1.0) + 0.113), y = 50.0 * fract(0.3678794 * vec2(c.y, c.y + 1.0) + 0.417);
    vec4 xs = x.xyxy, ys = y.xxyy, corners = fract(xs * ys * (xs + ys));
    vec2 rows = mix(corners.xz, corners.yw, f.x);
    return mix(rows.x, rows.y, f.y);
}

// One range of dunes: gentle towards the wind, steep behind the crest, flat between.
float range(vec2 p)
{
    float side = 2.0 * noise(p) - 1.0;
    float rise = side < 0.0 ? 1.0 + 0.95 * side : 1.0 - 2.1 * side;
    rise = max(rise, 0.0);
    return rise * sqrt(rise);
}

// Height of the ground in meters.
float ground(vec2 p)
{
    vec2 q = p * 0.021;
    float bend = sin(3.1 * q.y + 1.6 * q.x + 0.4), swing = sin(2.7 * q.x - 1.1 * q.y + 1.9);
    q += vec2(0.18 * bend, 0.19 * swing);
    float large = range(q * vec2(1.15, 0.72) + 4.5);
    float small = range(q * vec2(2.9, 2.1) + 17.0);
    return u_height * (large + 0.22 * small * (1.0 - 0.6 * large) + 0.12 * bend * swing);
}

vec3 sunDirection()
{
    float up = radians(u_sun_height), side = radians(u_sun_side);
    return vec3(sin(side) * cos(up), sin(up), cos(side) * cos(up));
}

vec3 sunColor()
{
    return mix(vec3(1.55, 0.62, 0.24), vec3(1.45, 1.22, 0.98), smoothstep(0.0, 40.0, u_sun_height));
}

// The sky without clouds and sun: what haze looks like.
vec3 dome(vec3 ray, vec3 sun)
{
    float low = smoothstep(30.0, 3.0, u_sun_height), up = max(ray.y, 0.03), near = max(dot(ray, sun), 0.0);
    vec3 zenith = mix(vec3(0.10, 0.25, 0.56), vec3(0.045, 0.10, 0.26), low);
    vec3 horizon = mix(vec3(0.60, 0.66, 0.72), vec3(0.62, 0.36, 0.27), low);
    vec3 color = mix(horizon, zenith, pow(up, 0.45));
    // Opposite of the sun lies the pink belt above the shadow of the earth.
    color = mix(color, vec3(0.46, 0.30, 0.42), 0.5 * low * smoothstep(0.2, -0.9, dot(ray.xz, sun.xz)) * exp(-14.0 * (up - 0.10) * (up - 0.10)));
    return color + sunColor() * (0.22 * pow(near, 9.0) + 0.45 * pow(near, 120.0)) * (0.4 + 0.6 * low);
}

vec3 sky(vec3 ray, vec3 sun)
{
    vec3 color = dome(ray, sun);
    // Thin clouds, drawn out by the wind.
    float up = max(ray.y, 0.0), near = max(dot(ray, sun), 0.0);
    vec2 at = ray.xz / (up + 0.11) * vec2(0.5, 1.7) + vec2(0.012 * u_time, 0.0);
    float cloud = noise(at) * 0.55 + noise(2.7 * at + 5.0) * 0.3 + noise(6.1 * at) * 0.15;
    color += (0.07 + 0.40 * pow(near, 4.0)) * sunColor() * smoothstep(0.45, 0.95, cloud) * smoothstep(0.0, 0.14, up) * 0.55;
    return color + 9.0 * sunColor() * smoothstep(0.99989, 0.99994, dot(ray, sun));
}

// Distance along a ray to the ground; `farthest` if there is none.
float hit(vec3 eye, vec3 ray)
{
    float t = 0.5, before = 0.5, freeBefore = 1.0;
    for (int i = 0; i < steps; ++i) {
        vec3 p = eye + t * ray;
        float free = p.y - ground(p.xz);
        if (free < 0.0) {
            // The crossing lies between the last two points: the line through both finds it, twice.
            for (int k = 0; k < 2; ++k) {
                float middle = before + (t - before) * freeBefore / (freeBefore - free);
                vec3 m = eye + middle * ray;
                float there = m.y - ground(m.xz);
                if (there < 0.0) { t = middle; free = there; } else { before = middle; freeBefore = there; }
            }
            return before + (t - before) * freeBefore / (freeBefore - free);
        }
        if (free < 0.0004 * t) return t;
        if (t > farthest || (ray.y > 0.0 && p.y > 1.3 * u_height)) break;
        before = t;
        freeBefore = free;
        t += max(0.65 * free, (0.004 + 0.0001 * float(i)) * t);
    }
    // A ray that is out of steps has nearly arrived, except in the sky.
    return t < farthest && (ray.y < 0.0 || freeBefore < 0.012 * t) ? t : farthest;
}

// Share of the sun that a point of the ground sees.
float sunlight(vec3 p, vec3 sun)
{
    float share = 1.0, t = 0.35;
    for (int i = 0; i < shadowSteps; ++i) {
        vec3 q = p + t * sun;
        float free = q.y - ground(q.xz);
        share = min(share, 0.5 + 0.5 * free / (0.022 * t + 0.02));
        if (share < 0.0 || q.y > 1.3 * u_height) break;
        t += clamp(0.7 * free, 0.25 + 0.04 * t, 14.0);
    }
    share = clamp(share, 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}

// Slope of the ripples, which lie across the wind and bend with the ground. They fade where a pixel is wider.
vec2 rippled(vec2 p, vec3 n, float width)
{
    float bend = 1.6 * noise(0.35 * p) + 0.9 * noise(1.1 * p + 7.0) + 2.5 * n.x;
    float phase = 10.5 * (p.x + 0.22 * p.y) + 3.2 * bend - 0.25 * u_time * u_wind;
    float visible = exp(-60.0 * width) * u_ripples * smoothstep(0.78, 0.95, n.y);
    float wave = cos(phase) + 0.45 * cos(2.0 * phase + 0.9);
    return 0.17 * visible * wave * vec2(1.0, 0.22 + 0.25 * (noise(0.9 * p) - 0.5));
}

vec3 sandColor(vec3 p, vec3 ray, float t, vec3 sun)
{
    float e = 0.02 + 1.7 * t / u_resolution.y;
    float here = ground(p.xz);
    vec3 n = normalize(vec3(here - ground(p.xz + vec2(e, 0.0)), e, here - ground(p.xz + vec2(0.0, e))));
    float smoothLight = dot(n, sun);
    vec2 waves = rippled(p.xz, n, t / u_resolution.y);
    vec3 fine = normalize(n + vec3(waves.x, 0.0, waves.y));
    float seesSun = smoothLight > -0.15 ? sunlight(p + 0.02 * n, sun) : 0.0;
    // Grains are rough: they throw light back more evenly than a matt wall does.
    float direct = pow(clamp(dot(fine, sun), 0.0, 1.0), 0.8) * seesSun;
    vec3 albedo = pow(u_sand, vec3(2.2));
    albedo *= 0.86 + 0.28 * noise(0.05 * p.xz + 3.0);
    vec3 fromSky = mix(vec3(0.12, 0.14, 0.26), vec3(0.20, 0.27, 0.50), fine.y) + 0.10 * sunColor() * max(0.0, 0.6 - 0.5 * n.y + 0.3 * dot(n.xz, -sun.xz));
    vec3 color = albedo * (2.15 * sunColor() * direct + 0.95 * fromSky);
    // Single grains mirror the sun, each in its own direction.
    vec2 grain = floor(p.xz * 90.0);
    vec3 mirror = normalize(fine + 0.9 * (vec3(random(grain), random(grain + 37.0), random(grain + 91.0)) - 0.5));
    float glint = pow(clamp(dot(reflect(ray, mirror), sun), 0.0, 1.0), 42.0);
    return color + 1.5 * glint * sunColor() * direct * exp(-300.0 * t / u_resolution.y);
}

// Sand that the wind carries off the crests: how much of it lies before a point at a distance.
float blown(vec3 eye, vec3 ray, float t)
{
    float sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        float at = t * (float(i) + 0.5) / 3.0;
        vec3 p = eye + at * ray;
        float above = p.y - ground(p.xz);
        vec2 q = p.xz * vec2(0.10, 0.55) - vec2(0.9 * u_time, 0.0);
        sum += exp(-1.1 * max(above, 0.0)) * smoothstep(0.35, 0.9, 0.6 * noise(q) + 0.4 * noise(3.1 * q));
    }
    return 1.0 - exp(-0.012 * u_wind * sum * min(t, 70.0) / 3.0);
}

// The place of the visitor, who walks on the ground and looks over the next crest.
vec3 standing()
{
    vec2 foot = vec2(u_place, u_walk * u_time - 20.0);
    float under = max(ground(foot + vec2(0.0, 4.0)), ground(foot + vec2(0.0, 15.0)) - 0.9);
    return vec3(foot.x, under + 3.6, foot.y);
}

vec3 landscape()
{
    vec2 at = (2.0 * gl_FragCoord.xy - u_resolution) / u_resolution.y;
    vec3 sun = sunDirection(), eye = standing();
    float turn = 0.9 * u_view.x, tilt = u_view.y - 0.11;
    vec3 ray = normalize(vec3(at.x, at.y + 1.75 * tilt, 1.75));
    ray.xz = mat2(cos(turn), -sin(turn), sin(turn), cos(turn)) * ray.xz;

    float t = hit(eye, ray);
    vec3 color = t < farthest ? sandColor(eye + t * ray, ray, t, sun) : sky(ray, sun);
    if (t < farthest) {
        // Haze takes the color of the sky just above the horizon.
        vec3 air = dome(normalize(vec3(ray.x, 0.035, ray.z)), sun);
        color = mix(air, color, exp(-0.0052 * u_haze * t) * smoothstep(farthest, 0.7 * farthest, t));
    }
    color = mix(color, 0.55 * sunColor() + 0.25, blown(eye, ray, min(t, 120.0)));
    // A film's curve, and a little noise against steps in the sky.
    color *= 0.68;
    color = color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14);
    return pow(clamp(color, 0.0, 1.0), vec3(1.0 / 2.2)) + (random(gl_FragCoord.xy) - 0.5) / 255.0;
}

vec3 drawn(vec2 pixel) { return texture2D(u_buffer0, pixel / u_resolution).rgb; }

float luma(vec3 color) { return dot(color, vec3(0.3, 0.59, 0.11)); }

// The picture with its stairs smoothed: where brightness jumps, colors are mixed along the edge.
vec3 smoothed()
{
    vec2 at = gl_FragCoord.xy;
    vec3 here = drawn(at);
    float nw = luma(drawn(at + vec2(-1.0, 1.0))), ne = luma(drawn(at + vec2(1.0)));
    float sw = luma(drawn(at - vec2(1.0))), se = luma(drawn(at + vec2(1.0, -1.0))), m = luma(here);
    float low = min(m, min(min(nw, ne), min(sw, se))), high = max(m, max(max(nw, ne), max(sw, se)));
    if (high - low < max(0.03, 0.08 * high)) return here;
    vec2 along = vec2(sw + se - nw - ne, nw + sw - ne - se);
    along /= max(min(abs(along.x), abs(along.y)), 0.02);
    along = clamp(along, -6.0, 6.0);
    vec3 near = 0.5 * (drawn(at - along / 6.0) + drawn(at + along / 6.0));
    vec3 wide = 0.5 * near + 0.25 * (drawn(at - 0.5 * along) + drawn(at + 0.5 * along));
    float brightness = luma(wide);
    return brightness < low || brightness > high ? near : wide;
}

void main()
{
#ifdef BUFFER_0
    gl_FragColor = vec4(landscape(), 1.0);
#else
    gl_FragColor = vec4(smoothed(), 1.0);
#endif
}

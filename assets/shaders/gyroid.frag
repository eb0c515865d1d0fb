// Gyroid lantern: a brass shell, pierced by a gyroid, with a bulb inside that throws its pattern into dusty air, on a
// floor and on a wall. A plain fragment shader in the dialect of The Book of Shaders. The mouse turns the shell. A
// comment behind a uniform gives its range; "exact" marks a setting of accuracy.
#ifdef GL_ES
precision highp float;
#endif

uniform vec2 u_resolution;
uniform vec2 u_mouse;
uniform float u_time;

uniform float u_cells;   // 3 .. 14, default 9, "Fineness of the pattern"
uniform float u_wall;    // 0.1 .. 0.8, default 0.6, "Width of the bars"
uniform float u_turning; // -1 .. 1, default 0.16, "Speed of turning"
uniform float u_dust;    // 0 .. 2, default 1, "Dust in the air"
uniform float u_shine;   // 0.2 .. 3, default 1, "Brightness of the bulb"
uniform float u_warmth;  // 0 .. 1, default 0.85, "Warmth of the bulb"

const int steps = 64; // 8 .. 256, default 64, exact 256, "Steps of a ray"
const int beamSteps = 28; // 2 .. 200, default 28, exact 200, "Steps through the dust"
const int samples = 2; // 1 .. 4, default 2, exact 4, "Samples"

const float bulb = 0.13;
const float ground = -1.42;
const float back = -3.4;

mat2 turned(float angle)
{
    return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

// Orientation of the shell: its axis leans, and the mouse turns it.
mat3 posture()
{
    vec2 mouse = u_mouse / u_resolution - 0.5;
    mat2 a = turned(1.8 * mouse.y + 0.35), b = turned(3.6 * mouse.x + u_turning * u_time);
    mat3 lean = mat3(1.0, 0.0, 0.0, 0.0, a[0][0], a[0][1], 0.0, a[1][0], a[1][1]);
    mat3 turn = mat3(b[0][0], 0.0, b[0][1], 0.0, 1.0, 0.0, b[1][0], 0.0, b[1][1]);
    return turn * lean;
}

float pattern(vec3 p)
{
    return abs(dot(sin(u_cells * p), cos(u_cells * p.zxy)));
}

// Distance to the shell: between two spheres, where the gyroid is near 0. The factor keeps steps from passing it.
float lantern(vec3 p, mat3 pose)
{
    float ball = abs(length(p) - 0.94) - 0.06;
    return max(ball, 0.62 * (pattern(pose * p) - u_wall) / u_cells - 0.012);
}

// Share of the bulb that a point outside sees through the shell. The half-shadow grows with the distance.
float light(vec3 p, mat3 pose)
{
    float r = length(p);
    if (r < 0.94) return 1.0;
    float soft = 0.05 + u_cells * bulb * (r - 0.94) / r * 0.55;
    return smoothstep(-soft, soft, pattern(pose * p * (0.95 / r)) - u_wall - 0.02);
}

vec3 normalAt(vec3 p, mat3 pose)
{
    vec2 e = vec2(0.0012, -0.0012);
    return normalize(e.xyy * lantern(p + e.xyy, pose) + e.yyx * lantern(p + e.yyx, pose) +
                     e.yxy * lantern(p + e.yxy, pose) + e.xxx * lantern(p + e.xxx, pose));
}

// Light that a matt surface receives from the bulb.
float received(vec3 p, vec3 n, mat3 pose)
{
    return light(p, pose) * max(dot(n, -normalize(p)), 0.0) / (0.15 + dot(p, p));
}

// Floor and wall, joined by a hollow.
vec3 room(vec3 eye, vec3 ray, mat3 pose, vec3 glow, out float along)
{
    float down = (ground - eye.y) / min(ray.y, -1e-4);
    float far = (back - eye.z) / min(ray.z, -1e-4);
    along = min(ray.y < 0.0 ? down : 1e3, ray.z < 0.0 ? far : 1e3);
    along = min(along, 20.0);
    vec3 p = eye + along * ray;
    vec3 n = mix(vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0), smoothstep(0.0, 0.5, 0.25 + 0.5 * (p.y - ground) - 0.5 * (p.z - back)));
    n = normalize(n);
    // The lantern hides the ambient light near its foot.
    float shade = 1.0 - 0.6 * exp(-0.8 * dot(p.xz, p.xz)) * step(p.y, ground + 0.4);
    vec3 dusk = vec3(0.012, 0.016, 0.030) * shade;
    return vec3(0.62, 0.50, 0.44) * (dusk + 3.4 * glow * received(p, n, pose));
}

// Share of a pixel that the cord covers, on which the lantern hangs.
float cord(vec3 eye, vec3 ray, float along)
{
    float t = -dot(eye.xz, ray.xz) / dot(ray.xz, ray.xz);
    vec3 p = eye + t * ray;
    return t < along ? smoothstep(0.99, 1.0, p.y) * smoothstep(0.018, 0.010, length(p.xz)) : 0.0;
}

vec3 shell(vec3 p, vec3 ray, mat3 pose, vec3 glow)
{
    vec3 n = normalAt(p, pose);
    float facing = clamp(dot(n, -ray), 0.0, 1.0);
    float lit = max(dot(n, -normalize(p)), 0.0) / (0.12 + dot(p, p));
    // Brass: what it mirrors is a dark room above and the lit floor below.
    vec3 mirrored = reflect(ray, n);
    vec3 around = mix(0.10 * glow, vec3(0.020, 0.030, 0.055), smoothstep(-0.7, 0.4, mirrored.y));
    around += vec3(0.50, 0.62, 0.85) * pow(clamp(dot(mirrored, normalize(vec3(-0.6, 0.7, 0.5))), 0.0, 1.0), 24.0) * 0.9;
    vec3 brass = mix(vec3(0.70, 0.46, 0.22), vec3(1.0), pow(1.0 - facing, 5.0));
    // Light that bars on the other side throw back.
    float within = smoothstep(1.02, 0.86, length(p));
    return brass * (around + glow * (1.7 * lit + 0.22 * within));
}

vec3 seen(vec2 pixel, mat3 pose, vec3 glow, vec3 eye, out vec3 ray, out float along)
{
    vec2 at = (2.0 * pixel - u_resolution) / u_resolution.y;
    ray = normalize(vec3(0.62 * at + vec2(0.0, -0.045), -1.9));
    vec3 color = room(eye, ray, pose, glow, along);
    color *= 1.0 - cord(eye, ray, along);
    // Only between the ends of the outer sphere there is something to hit.
    float b = dot(eye, ray), inside = b * b - dot(eye, eye) + 1.0;
    if (inside < 0.0) return color;
    float t = -b - sqrt(inside), end = -b + sqrt(inside);
    float bulbInside = b * b - dot(eye, eye) + bulb * bulb;
    float bulbAt = bulbInside > 0.0 ? -b - sqrt(bulbInside) : 1e3;
    end = min(end, bulbAt);
    for (int i = 0; i < steps; ++i) {
        float free = lantern(eye + t * ray, pose);
        if (free < 0.0008) {
            along = t;
            return shell(eye + t * ray, ray, pose, glow);
        }
        t += max(free, 0.003);
        if (t > end) break;
    }
    if (t < end || bulbAt > 100.0) return color;
    along = bulbAt;
    return glow * 9.0;
}

// Light that dust scatters towards the eye up to a distance, and the glare around the bulb.
float dust(vec3 eye, vec3 ray, float along, mat3 pose, float shift)
{
    float b = dot(eye, ray), inside = b * b - dot(eye, eye) + 6.5;
    if (inside < 0.0) return 0.0;
    float begin = max(-b - sqrt(inside), 0.0), end = min(-b + sqrt(inside), along);
    float stride = max(end - begin, 0.0) / float(beamSteps), sum = 0.0;
    for (int i = 0; i < beamSteps; ++i) {
        vec3 p = eye + (begin + (float(i) + shift) * stride) * ray;
        float r2 = dot(p, p);
        sum += light(p, pose) * smoothstep(6.5, 2.0, r2) / (0.35 + r2);
    }
    return sum * stride;
}

void main()
{
    mat3 pose = posture();
    vec3 glow = u_shine * mix(vec3(0.62, 0.80, 1.10), vec3(1.08, 0.52, 0.17), u_warmth);
    vec3 eye = vec3(0.0, 0.22, 4.9);
    vec3 color = vec3(0.0), ray;
    float along, reach = 0.0;
    for (int i = 0; i < samples * samples; ++i) {
        vec2 part = (vec2(i % samples, i / samples) + 0.5) / float(samples) - 0.5;
        vec3 light = seen(gl_FragCoord.xy + part, pose, glow, eye, ray, along);
        color += 1.0 - exp(-1.4 * light);
        reach += along;
    }
    color /= float(samples * samples);
    reach /= float(samples * samples);
    // A fixed pattern of shifts, so that nothing flickers.
    float shift = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
    vec3 veil = 1.0 - exp(-0.19 * u_dust * glow * dust(eye, ray, reach, pose, shift));
    color = 1.0 - (1.0 - color) * (1.0 - veil);
    color = pow(color, vec3(1.0 / 2.2));
    color = mix(color, color * color * (3.0 - 2.0 * color), 0.55) + (shift - 0.5) / 255.0;
    gl_FragColor = vec4(color, 1.0);
}

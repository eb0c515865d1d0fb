// Gyroid lantern: a ball whose wall is a gyroid, with a lamp inside. A plain fragment shader in the dialect of The Book
// of Shaders. The mouse turns the ball. A comment behind a uniform gives its range.
#ifdef GL_ES
precision highp float;
#endif

uniform vec2 u_resolution;
uniform vec2 u_mouse;
uniform float u_time;

uniform float u_cells;   // 2 .. 14, default 6.5, "Cells"
uniform float u_wall;    // 0.05 .. 0.8, default 0.28, "Thickness of the wall"
uniform float u_turning; // -1 .. 1, default 0.2, "Turns"
uniform vec3 u_glow;     // color

#define STEPS 72 // 8 .. 256, default 72, exact 256, "Steps of a ray"

mat2 turned(float angle)
{
    return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

vec3 inBall(vec3 p)
{
    vec2 mouse = u_mouse / u_resolution - 0.5;
    p.yz = turned(1.8 * mouse.y + 0.35) * p.yz;
    p.xz = turned(3.6 * mouse.x + u_turning * u_time) * p.xz;
    return p;
}

float gyroid(vec3 p)
{
    p *= u_cells;
    return (abs(dot(sin(p), cos(p.zxy))) - u_wall) / u_cells;
}

float lantern(vec3 p)
{
    float ball = abs(length(p) - 0.93) - 0.07;
    return max(ball, 0.7 * gyroid(inBall(p)));
}

vec3 normalAt(vec3 p)
{
    vec2 e = vec2(0.0008, 0.0);
    return normalize(vec3(lantern(p + e.xyy) - lantern(p - e.xyy), lantern(p + e.yxy) - lantern(p - e.yxy),
                          lantern(p + e.yyx) - lantern(p - e.yyx)));
}

void main()
{
    vec2 at = (2.0 * gl_FragCoord.xy - u_resolution) / u_resolution.y;
    vec3 eye = vec3(0.0, 0.0, 3.4);
    vec3 ray = normalize(vec3(0.75 * at, -1.9));

    float along = 2.0;
    float haze = 0.0;
    bool isHit = false;
    for (int i = 0; i < STEPS; ++i) {
        vec3 p = eye + along * ray;
        float free = lantern(p);
        // Light between the walls, brighter near the lamp in the middle.
        haze += 0.018 / (0.12 + dot(p, p)) * clamp(free * 12.0, 0.0, 1.0);
        isHit = free < 0.001;
        if (isHit || along > 4.8) break;
        along += max(free, 0.004);
    }

    vec3 glow = u_glow * vec3(1.0, 0.62, 0.26);
    vec3 color = mix(vec3(0.018, 0.022, 0.04), vec3(0.05, 0.03, 0.035), exp(-dot(at, at)));
    if (isHit) {
        vec3 p = eye + along * ray;
        vec3 n = normalAt(p);
        float fromInside = clamp(dot(n, -normalize(p)), 0.0, 1.0) / (0.3 + dot(p, p));
        float rim = pow(1.0 - clamp(dot(n, -ray), 0.0, 1.0), 3.0);
        float sky = 0.5 + 0.5 * n.y;
        color = glow * (1.9 * fromInside + 0.05) + vec3(0.10, 0.14, 0.22) * sky * 0.5 + vec3(0.4, 0.5, 0.7) * rim * 0.25;
    }
    color += glow * haze * 0.55;
    color = 1.0 - exp(-1.5 * color);
    gl_FragColor = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}

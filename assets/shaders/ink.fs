/*{
    "ISFVSN": "2",
    "DESCRIPTION": "Ink in water: drops fall in, and a slow flow carries them. The picture is made of the one before.",
    "CREDIT": "The developers of Vitrine",
    "CATEGORIES": ["Generator", "Feedback"],
    "INPUTS": [
        {"NAME": "flow", "LABEL": "Speed of the flow", "TYPE": "float", "MIN": 0.0, "MAX": 3.0, "DEFAULT": 1.2},
        {"NAME": "swirl_size", "LABEL": "Size of swirls", "TYPE": "float", "MIN": 0.1, "MAX": 1.0, "DEFAULT": 0.42},
        {"NAME": "fading", "LABEL": "Fading", "TYPE": "float", "MIN": 0.0, "MAX": 0.1, "DEFAULT": 0.006},
        {"NAME": "drops", "LABEL": "Drops", "TYPE": "long", "VALUES": [1, 2, 3, 5], "LABELS": ["one", "two", "three", "five"], "DEFAULT": 3},
        {"NAME": "first_ink", "LABEL": "First ink", "TYPE": "color", "DEFAULT": [0.06, 0.19, 0.42, 1.0]},
        {"NAME": "last_ink", "LABEL": "Last ink", "TYPE": "color", "DEFAULT": [0.80, 0.17, 0.13, 1.0]},
        {"NAME": "place", "LABEL": "Place of the drops", "TYPE": "point2D", "MIN": [0.0, 0.0], "MAX": [1.0, 1.0], "DEFAULT": [0.5, 0.5]},
        {"NAME": "on_black", "LABEL": "Black ground", "TYPE": "bool", "DEFAULT": false},
        {"NAME": "clear", "LABEL": "Fresh water", "TYPE": "event"}
    ],
    "PASSES": [
        {"TARGET": "water", "PERSISTENT": true, "FLOAT": true, "WIDTH": "floor($WIDTH / 2)", "HEIGHT": "floor($HEIGHT / 2)"},
        {}
    ]
}*/

// Height of a landscape of waves that wander. The water flows along its level lines.
float stream(vec2 p)
{
    p *= 3.0 / swirl_size;
    return sin(1.3 * p.x + 0.7 * p.y + 0.6 * TIME) + sin(1.7 * p.y - 0.8 * p.x - 0.5 * TIME) +
           0.55 * sin(2.9 * p.x - 2.3 * p.y + 0.9 * TIME) + 0.3 * sin(4.7 * p.x + 5.3 * p.y - 1.3 * TIME);
}

// The flow along the level lines of the stream function: it neither gathers nor thins what it carries.
vec2 velocity(vec2 p)
{
    const float e = 0.004;
    return vec2(stream(p + vec2(0.0, e)) - stream(p - vec2(0.0, e)), stream(p - vec2(e, 0.0)) - stream(p + vec2(e, 0.0))) /
           (2.0 * e) * swirl_size / 3.0;
}

vec3 inkOf(int drop, int count)
{
    float share = count > 1 ? float(drop) / float(count - 1) : 0.0;
    return mix(first_ink.rgb, last_ink.rgb, share);
}

float random(vec2 cell)
{
    vec3 q = fract(vec3(cell.xyx) * vec3(0.1031, 0.1030, 0.0973));
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}

float noise(vec2 p)
{
    vec2 c = floor(p), f = p - c;
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(random(c), random(c + vec2(1.0, 0.0)), f.x), mix(random(c + vec2(0.0, 1.0)), random(c + vec2(1.0)), f.x), f.y);
}

// The ink as it dries on paper: pigment gathers along its edges and in the hollows of the grain.
vec3 onPaper(vec2 at, vec2 p)
{
    vec3 taken = IMG_NORM_PIXEL(water, at).rgb;
    vec2 e = vec2(0.0025 * RENDERSIZE.y / RENDERSIZE.x, 0.0025);
    vec3 across = IMG_NORM_PIXEL(water, at + vec2(e.x, 0.0)).rgb - IMG_NORM_PIXEL(water, at - vec2(e.x, 0.0)).rgb;
    vec3 up = IMG_NORM_PIXEL(water, at + vec2(0.0, e.y)).rgb - IMG_NORM_PIXEL(water, at - vec2(0.0, e.y)).rgb;
    vec3 edges = sqrt(across * across + up * up);
    float grain = 0.55 * noise(p * 150.0) + 0.30 * noise(p * 330.0) + 0.15 * noise(p * vec2(40.0, 700.0));
    taken = taken * (1.0 + 0.35 * (grain - 0.5) * exp(-0.6 * taken)) + 0.9 * edges * exp(-1.5 * taken);
    vec3 paper = vec3(0.965, 0.95, 0.915) * (1.0 - 0.12 * dot(at - 0.5, at - 0.5)) * (0.985 + 0.03 * grain);
    // On black, the ink is light.
    return on_black ? (1.0 - exp(-1.6 * taken)) * (0.9 + 0.2 * grain) + 0.012 : paper * exp(-taken);
}

void main()
{
    vec2 at = isf_FragNormCoord;
    float aspect = RENDERSIZE.x / RENDERSIZE.y;
    vec2 p = vec2(at.x * aspect, at.y);
    if (PASSINDEX == 0) {
        // What light the ink takes away, carried along.
        vec2 from = p - flow * velocity(p) * 0.0022;
        vec3 taken = IMG_NORM_PIXEL(water, vec2(from.x / aspect, from.y)).rgb * (1.0 - fading);
        for (int i = 0; i < drops; ++i) {
            float angle = 6.2832 * (float(i) + 0.25) / float(drops) + 0.35 * TIME;
            vec2 drop = vec2(place.x * aspect, place.y) + 0.24 * vec2(cos(angle), sin(angle));
            float near = exp(-dot(p - drop, p - drop) / 0.0009);
            taken += 0.22 * near * -log(clamp(inkOf(i, drops), 0.02, 1.0)) * 0.5;
        }
        gl_FragColor = vec4(clear ? vec3(0.0) : taken, 1.0);
        return;
    }
    gl_FragColor = vec4(onPaper(at, p), 1.0);
}

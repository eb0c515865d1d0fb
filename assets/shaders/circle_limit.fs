/*{
    "ISFVSN": "2",
    "DESCRIPTION": "Circle limit: a tiling of the hyperbolic plane in enamel and gold. All tiles have the same size there.",
    "CREDIT": "The developers of Vitrine",
    "CATEGORIES": ["Generator", "Geometry"],
    "INPUTS": [
        {"NAME": "corners", "LABEL": "Corners of a tile", "TYPE": "long", "VALUES": [3, 4, 5, 6, 7, 8], "LABELS": ["3", "4", "5", "6", "7", "8"], "DEFAULT": 6},
        {"NAME": "meeting", "LABEL": "Tiles that meet at a corner", "TYPE": "long", "VALUES": [3, 4, 5, 6, 7, 8], "LABELS": ["3", "4", "5", "6", "7", "8"], "DEFAULT": 4},
        {"NAME": "place", "LABEL": "Place in the plane", "TYPE": "point2D", "MIN": [-0.95, -0.95], "MAX": [0.95, 0.95], "DEFAULT": [0.0, 0.0]},
        {"NAME": "drift", "LABEL": "Speed of the journey", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.25},
        {"NAME": "bloom", "LABEL": "Size of the petals", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.78},
        {"NAME": "wire", "LABEL": "Width of the gold", "TYPE": "float", "MIN": 0.2, "MAX": 3.0, "DEFAULT": 1.0},
        {"NAME": "first_enamel", "LABEL": "First enamel", "TYPE": "color", "DEFAULT": [0.07, 0.22, 0.52, 1.0]},
        {"NAME": "second_enamel", "LABEL": "Second enamel", "TYPE": "color", "DEFAULT": [0.72, 0.13, 0.20, 1.0]},
        {"NAME": "ground", "LABEL": "Ground", "TYPE": "color", "DEFAULT": [0.93, 0.90, 0.80, 1.0]},
        {"NAME": "folds", "LABEL": "Mirror images", "TYPE": "float", "MIN": 1.0, "MAX": 64.0, "DEFAULT": 20.0, "EXACT": 64.0}
    ]
}*/

const float pi = 3.14159265;

struct Tile {
    vec2 at;        // Place in the tile around the middle, within one corner's sector.
    float scale;    // Size of the tile in the picture, against that of the tile in the middle.
    float parity;   // 0 or 1, different for neighbors.
    float inner;    // Radius of the circle inside the tile.
    float edge;     // Distance to the edge of the tile.
};

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

// A shift of the hyperbolic plane that takes `to` to the middle; `scale` is its derivative.
vec2 shifted(vec2 z, vec2 to, inout float scale)
{
    vec2 below = vec2(1.0, 0.0) - times(vec2(to.x, -to.y), z);
    float size2 = dot(below, below);
    scale *= (1.0 - dot(to, to)) / size2;
    return times(z - to, vec2(below.x, -below.y)) / size2;
}

Tile tileAt(vec2 z)
{
    float p = float(corners), q = float(meeting);
    // Fewer would tile a plane or a ball.
    q = max(q, floor(4.0 / (p - 2.0)) + 3.0);
    float c2 = cos(pi / q) * cos(pi / q), s2 = sin(pi / p) * sin(pi / p), root = sqrt(c2 - s2);
    float middle = cos(pi / q) / root, radius = sin(pi / p) / root;
    Tile tile;
    tile.scale = 1.0;
    // The journey is a closed curve, and the picture turns with it.
    float t = drift * TIME;
    vec2 to = clamp(length(place), 0.0, 0.95) * (length(place) > 0.0 ? normalize(place) : vec2(0.0));
    z = shifted(z, to, tile.scale);
    z = shifted(z, 0.55 * vec2(cos(t), sin(0.77 * t)) * min(1.0, 8.0 * drift), tile.scale);
    z = times(z, vec2(cos(0.3 * t), sin(0.3 * t)));
    tile.parity = 0.0;
    float sectorWidth = 2.0 * pi / p;
    for (int i = 0; i < int(folds); ++i) {
        // Turn the point into the sector of the first edge, then mirror it in that edge if it lies beyond.
        float angle = atan(z.y, z.x), turn = floor(angle / sectorWidth + 0.5) * sectorWidth;
        z = times(z, vec2(cos(turn), -sin(turn)));
        vec2 away = z - vec2(middle, 0.0);
        float d2 = dot(away, away);
        if (d2 > radius * radius) break;
        float grow = radius * radius / d2;
        z = vec2(middle, 0.0) + away * grow;
        tile.scale *= grow;
        tile.parity = 1.0 - tile.parity;
    }
    tile.at = z;
    tile.inner = middle - radius;
    tile.edge = length(z - vec2(middle, 0.0)) - radius;
    return tile;
}

// Distance to the nearest wire in a tile, and which of four fields the point lies in.
float wires(Tile tile, out float field)
{
    float p = float(corners), r = length(tile.at), angle = atan(tile.at.y, tile.at.x), inner = tile.inner;
    float eye = r - 0.17 * inner;
    // Petals point to the corners, a second ring of them to the edges.
    float wave = 0.5 - 0.5 * cos(p * angle), thin = wave * wave;
    float outerPetal = r - inner * (0.40 + (0.15 + 0.55 * bloom) * thin);
    float innerPetal = r - inner * (0.28 + 0.30 * (1.0 - wave) * (1.0 - wave));
    field = eye < 0.0 ? 3.0 : innerPetal < 0.0 ? 2.0 : outerPetal < 0.0 ? 1.0 : 0.0;
    return min(min(abs(eye), 0.75 * abs(innerPetal)), min(0.65 * abs(outerPetal), tile.edge));
}

// Height of the work: enamel is filled in between wires and bulges a little.
float relief(vec2 z, out Tile tile, out float field, out float wire_)
{
    tile = tileAt(z);
    float line = wires(tile, field);
    wire_ = line - 0.011 * wire * tile.inner / 0.6;
    float round_ = clamp(-wire_ / 0.012, 0.0, 1.0);
    return (0.016 * sqrt(round_) - 0.020 * exp(-14.0 * max(wire_, 0.0))) / tile.scale;
}

vec3 linear(vec3 color) { return pow(color, vec3(2.2)); }

void main()
{
    float pixel = 2.0 / RENDERSIZE.y * 1.08;
    vec2 z = 1.08 * (2.0 * gl_FragCoord.xy - RENDERSIZE) / RENDERSIZE.y;
    float r = length(z), rim = smoothstep(0.5 * pixel, -0.5 * pixel, r - 0.985);
    vec3 lamp = normalize(vec3(-0.45, 0.65, 0.75));
    vec3 goldColor = vec3(0.95, 0.66, 0.25);
    vec3 color = vec3(0.0);

    if (r < 0.99) {
        vec2 inDisk = r > 0.984 ? z * 0.984 / r : z;
        Tile tile, other;
        float field, line, unused, unused2;
        float e = max(0.35 * pixel, 0.0006);
        float here = relief(inDisk, tile, field, line);
        float right = relief(inDisk + vec2(e, 0.0), other, unused, unused2);
        float up = relief(inDisk + vec2(0.0, e), other, unused, unused2);
        float width = pixel * tile.scale;
        vec2 slope = clamp(vec2(right - here, up - here) / e, -1.2, 1.2) * smoothstep(0.35, 0.03, width);
        vec3 n = normalize(vec3(-slope, 1.0));
        vec3 mirrored = reflect(vec3(0.0, 0.0, -1.0), n);

        vec3 a = linear(tile.parity > 0.5 ? first_enamel.rgb : second_enamel.rgb);
        vec3 b = linear(tile.parity > 0.5 ? second_enamel.rgb : first_enamel.rgb);
        vec3 enamel = field > 2.5 ? 0.9 * linear(ground.rgb) : field > 1.5 ? b : field > 0.5 ? linear(ground.rgb) : a;
        // Deeper enamel is darker; light gathers along the wires.
        enamel *= 0.70 + 0.45 * exp(-22.0 * max(line, 0.0)) + 0.10 * sin(40.0 * tile.at.x) * sin(40.0 * tile.at.y) * smoothstep(0.05, 0.01, width);
        float diffuse = 0.35 + 0.75 * max(dot(n, lamp), 0.0);
        float gloss = pow(max(dot(mirrored, lamp), 0.0), 60.0);
        vec3 glazed = enamel * diffuse + 0.35 * gloss + 0.035 * smoothstep(0.3, 0.9, mirrored.y);
        vec3 metal = goldColor * (0.20 + 0.75 * max(dot(n, lamp), 0.0) * max(dot(n, lamp), 0.0) + 1.6 * pow(max(dot(mirrored, lamp), 0.0), 14.0));
        float isWire = smoothstep(0.5 * width, -0.5 * width, line);
        color = mix(glazed, metal, isWire);
        // Where tiles are smaller than a pixel, their mean is what is seen.
        vec3 mean = 0.34 * linear(first_enamel.rgb) + 0.34 * linear(second_enamel.rgb) + 0.16 * linear(ground.rgb) + 0.16 * goldColor * 0.5;
        color = mix(color, mean, smoothstep(0.10, 0.45, width));
        // The disk bulges like a shield.
        color *= 0.82 + 0.30 * dot(normalize(vec3(0.55 * z, 1.0)), lamp);
    }
    // A rim of gold on dark velvet.
    float band = abs(r - 1.0075) - 0.0225;
    vec2 rimSlope = z / max(r, 1e-3) * clamp((r - 1.0075) / 0.0225, -1.0, 1.0);
    vec3 rn = normalize(vec3(rimSlope, 0.9));
    vec3 rimGold = goldColor * (0.10 + 0.8 * pow(max(dot(rn, lamp), 0.0), 2.0) + 1.5 * pow(max(dot(reflect(vec3(0.0, 0.0, -1.0), rn), lamp), 0.0), 18.0));
    vec3 velvet = vec3(0.0036, 0.0030, 0.0056) * (1.0 + 1.2 * exp(-3.0 * max(r - 1.03, 0.0))) * smoothstep(1.02, 1.16, length(z - vec2(0.02, -0.03)));
    vec3 outside = mix(velvet, rimGold, smoothstep(0.5 * pixel, -0.5 * pixel, band));
    color = mix(outside, color, rim);
    color = 1.0 - exp(-1.7 * color);
    gl_FragColor = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}

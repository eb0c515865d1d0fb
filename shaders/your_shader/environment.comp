// Built-in cube map of visitors' shaders: a sky with a sun above a floor of tiles, in display values.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba8, binding = 0) uniform writeonly imageCube environment;

const vec3 SUN = vec3(0.48, 0.6, 0.64);  // Unit vector.

// Direction of a point of a face, from -1 to 1 in both coordinates.
vec3 directionOf(int face, vec2 p)
{
    if (face == 0) return vec3(1.0, -p.y, -p.x);
    if (face == 1) return vec3(-1.0, -p.y, p.x);
    if (face == 2) return vec3(p.x, 1.0, p.y);
    if (face == 3) return vec3(p.x, -1.0, -p.y);
    return face == 4 ? vec3(p.x, -p.y, 1.0) : vec3(-p.x, -p.y, -1.0);
}

vec3 seen(vec3 way)
{
    vec3 haze = vec3(0.86, 0.89, 0.92);
    if (way.y >= 0.0) {
        vec3 sky = mix(haze, vec3(0.2, 0.4, 0.8), sqrt(way.y));
        return mix(sky, vec3(1.0, 0.97, 0.88), smoothstep(0.996, 0.998, dot(way, SUN)));
    }
    ivec2 tile = ivec2(floor(way.xz / max(-way.y, 1e-3)));
    vec3 tiles = (tile.x + tile.y) % 2 == 0 ? vec3(0.55, 0.5, 0.44) : vec3(0.3, 0.28, 0.26);
    return mix(haze, tiles, smoothstep(0.0, 0.25, -way.y));
}

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec2 size = imageSize(environment);
    if (any(greaterThanEqual(texel.xy, size))) return;
    // Four samples smooth the edges of tiles and sun.
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 p = 2.0 * (vec2(texel.xy) + vec2(0.25 + 0.5 * float(i % 2), 0.25 + 0.5 * float(i / 2))) / vec2(size) - 1.0;
        sum += seen(normalize(directionOf(texel.z, p)));
    }
    imageStore(environment, texel, vec4(0.25 * sum, 1.0));
}

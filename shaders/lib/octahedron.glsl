// Unit vectors as points of an unfolded octahedron (Meyer et al. 2010, "On Floating-Point Normal Vectors").

// Reflects a point over the edge between the halves of the octahedron.
vec2 octahedronFolded(vec2 p)
{
    return vec2((1.0 - abs(p.y)) * (p.x >= 0.0 ? 1.0 : -1.0), (1.0 - abs(p.x)) * (p.y >= 0.0 ? 1.0 : -1.0));
}

// Coordinates from -1 to 1.
vec2 octahedronPoint(vec3 n)
{
    vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
    return n.z < 0.0 ? octahedronFolded(p) : p;
}

vec3 octahedronDirection(vec2 p)
{
    float z = 1.0 - abs(p.x) - abs(p.y);
    vec2 n = z < 0.0 ? octahedronFolded(p) : p;
    return normalize(vec3(n.x, n.y, z));
}

// Intersection of lines and rays with an axis-aligned box. GLSL 4.50 and C++ (render/glsl/cpu.h).

// Entry and exit of a line in the box, as distances along `direction` from `origin`; exit < entry if it misses. The
// faces are inside. Kay and Kajiya 1986, slabs; parallel to a slab, there is no division, which would be 0 / 0 on a
// face. Without branches, because software renderers execute both sides.
vec2 lineBox(vec3 origin, vec3 direction, vec3 low, vec3 high)
{
    bvec3 parallel = lessThan(abs(direction), vec3(1.0e-12));
    vec3 inverse = 1.0 / mix(direction, vec3(1.0), parallel);
    vec3 a = (low - origin) * inverse;
    vec3 b = (high - origin) * inverse;
    vec3 beside = mix(vec3(-1.0e30), vec3(1.0e30), lessThan(min(origin - low, high - origin), vec3(0.0)));
    vec3 entry = mix(min(a, b), beside, parallel);
    vec3 exit = mix(max(a, b), -beside, parallel);
    return vec2(max(entry.x, max(entry.y, entry.z)), min(exit.x, min(exit.y, exit.z)));
}

// The same for a ray, whose interval starts at 0 for an origin inside: the camera or the near plane may be inside.
vec2 rayBox(vec3 origin, vec3 direction, vec3 low, vec3 high)
{
    vec2 line = lineBox(origin, direction, low, high);
    return vec2(max(line.x, 0.0), line.y);
}

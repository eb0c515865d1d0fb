// Intersection of a ray with an axis-aligned box. GLSL 4.50 and C++ (render/glsl/cpu.h).

// Interval of a ray inside a box: (entry, exit), entry >= 0; entry > exit if it misses the box. The interval starts at
// 0 for an origin inside, so that the camera or the near plane may be inside the box. Kay and Kajiya 1986, slabs; a
// direction parallel to a slab avoids 0 * inf = NaN.
vec2 rayBox(vec3 origin, vec3 direction, vec3 low, vec3 high)
{
    vec3 inverse = vec3(1.0e20, 1.0e20, 1.0e20);
    if (abs(direction.x) > 1.0e-20) inverse.x = 1.0 / direction.x;
    if (abs(direction.y) > 1.0e-20) inverse.y = 1.0 / direction.y;
    if (abs(direction.z) > 1.0e-20) inverse.z = 1.0 / direction.z;
    vec3 a = (low - origin) * inverse;
    vec3 b = (high - origin) * inverse;
    vec3 enter = min(a, b);
    vec3 leave = max(a, b);
    return vec2(max(max(enter.x, max(enter.y, enter.z)), 0.0), min(leave.x, min(leave.y, leave.z)));
}

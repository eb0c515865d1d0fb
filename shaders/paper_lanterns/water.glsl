// Heights and slopes of the lake: a sum of sines. GLSL 4.50 and C++ (exhibits/paper_lanterns/paper_lanterns_cpu.h). The
// including file provides `lake`, a LakeBlock.

struct LakePoint {
    float height;
    vec2 slope;  // along x and z
};

// Height and slope of a point on the water, by the waves that lift it.
LakePoint lakeAt(vec2 p)
{
    LakePoint found;
    found.height = 0.0;
    found.slope = vec2(0.0);
    for (int i = 0; i < lake.tallWaves; ++i) {
        vec4 w = lake.wave[i];
        vec2 k = vec2(w.x, w.y);
        float phase = dot(k, p) + w.w;
        found.height += w.z * sin(phase);
        found.slope += k * (w.z * cos(phase));
    }
    return found;
}

// Height and slope of the plane that best fits the water under a lantern's base.
LakePoint rideAt(vec2 p)
{
    LakePoint found;
    found.height = 0.0;
    found.slope = vec2(0.0);
    for (int i = 0; i < lake.rideWaves; ++i) {
        vec4 w = lake.ride[i];
        vec2 k = vec2(w.x, w.y);
        float phase = dot(k, p) + w.w;
        found.height += w.z * sin(phase);
        found.slope += k * (lake.rideTilt[i].x * cos(phase));
    }
    return found;
}

// Distance along a ray (unit direction) to the water, between `from` and `to`; -1 if there is no hit. The step is
// bounded by the largest height and slope that the water can have. `width` of a pixel at distance 1.
float waterDistance(vec3 origin, vec3 direction, float from, float to, float width, float tolerance, int steps)
{
    vec3 d = direction;
    bool inside = origin.y + d.y * from < lakeAt(vec2(origin.x + d.x * from, origin.z + d.z * from)).height;
    // Seen from below, the water is mirrored vertically.
    float up = inside ? -1.0 : 1.0;
    float falling = -d.y * up;
    float along = length(vec2(d.x, d.z));
    float t = from;
    float height = origin.y * up + falling * -t;
    if (height > lake.waveTop) {
        if (falling <= 0.0) return -1.0;
        t += (height - lake.waveTop) / falling;
    }
    float gap = 0.0;
    for (int i = 0; i < steps; ++i) {
        if (t > to) return -1.0;
        vec3 p = origin + d * t;
        gap = (p.y - lakeAt(vec2(p.x, p.z)).height) * up;
        if (gap < tolerance * width * t + 1.0e-5) return t;
        if (falling <= 0.0 && p.y * up > lake.waveTop) return -1.0;
        float closing = lake.waveSlope * along + falling;
        if (closing <= 1.0e-7) return -1.0;
        t += gap / closing;
    }
    // At the step limit: intersect a plane at that height.
    if (falling <= 0.0) return -1.0;
    t += gap / falling;
    return t > to ? -1.0 : t;
}

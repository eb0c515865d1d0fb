// Markings of a coat: strands of another color in bands, stripes or spots.

// Smooth vector field without repetition within a body, about -1 to 1; bends the outlines of markings.
vec3 markingWarp(vec3 p)
{
    return vec3(sin(p.y * 2.3 + 1.7 * sin(p.z * 1.9 + 0.3)), sin(p.z * 2.9 + 1.9 * sin(p.x * 1.7 + 1.1)), sin(p.x * 2.1 + 1.3 * sin(p.y * 2.7 + 2.3)));
}

// Share of the marking's color at the root `p` (meters, body space) of a strand, at the height `h` along it. `size`:
// distance between two markings, meters.
float markingShare(int kind, vec3 p, float h, float size)
{
    // A ticked coat has a light band below each dark tip.
    if (kind == MARKING_TICKED) return smoothStep(0.36, 0.5, h) * (1.0 - smoothStep(0.62, 0.76, h));
    vec3 q = p * (6.2831853 / max(size, 1.0e-4));
    // The color reaches the tips of marked strands, not their roots.
    float shown = smoothStep(0.05, 0.4, h);
    if (kind == MARKING_STRIPES) {
        vec3 warp = markingWarp(q * 0.4);
        float wave = sin(q.x + 1.4 * warp.x + 0.5 * warp.z);
        // Stripes thin out and end at different places around the body.
        return shown * smoothStep(0.0, 0.35, wave - 0.15 + 0.55 * markingWarp(q * 0.31 + vec3(4.0)).y);
    }
    if (kind == MARKING_SPOTS) {
        q += 0.9 * markingWarp(q * 0.45);
        // Rings around the minima of a lattice of balls, open on one side, with a darker ground inside.
        float balls = cos(q.x) + cos(q.y) + cos(q.z);
        float ring = smoothStep(0.75, 0.95, balls) * (1.0 - smoothStep(1.6, 1.85, balls));
        float inside = 0.35 * smoothStep(1.6, 1.85, balls);
        return shown * max(ring * smoothStep(-0.9, -0.4, markingWarp(q * 0.8).y), inside);
    }
    return 0.0;
}

// Braided round rug on the floor of the pit: a braid of three strands, coiled from the center outwards.

// Point of the rug: color (linear), normal in the pit's space, and share of the ambient light between the strands.
struct RugPoint {
    vec3 color;
    vec3 normal;
    float open;
};

// `p`: place on the floor, meters from the center; `pixel`: width of a pixel there, meters. Details smaller than a pixel
// fade into their mean.
RugPoint rugPoint(vec2 p, float pixel, float radius, vec3 dye)
{
    const float braid = 0.05;  // width of the braid, meters
    const float stitch = 0.047; // length of a strand's lump along it, meters
    float r = length(p);
    vec2 outwards = safeNormalize(vec3(p, 0.0), vec3(1.0, 0.0, 0.0)).xy;
    float coil = r / braid;
    float ring = floor(coil);
    float across = coil - ring - 0.5;
    // A whole number of lumps fits around each ring.
    float lumps = max(floor(6.2831853 * (ring + 0.5) * braid / stitch + 0.5), 3.0);
    float along = angleOf(p.y, p.x) / 6.2831853 * lumps + (mod(ring, 2.0) < 0.5 ? 0.9 : -0.9) * abs(across) + 0.37 * ring;
    float lump = floor(along);
    float in_ = along - lump - 0.5;
    vec3 bits = vec3(pcg3d(uvec3(uint(int(mod(lump, lumps)) + 7), uint(int(ring) + 1), 11u))) * (1.0 / 4294967296.0);

    float sharp = 1.0 - smoothStep(0.25 * stitch, 0.9 * stitch, pixel);
    float fine = 1.0 - smoothStep(0.003, 0.012, pixel);
    // Both ways a strand is round; fibers run along it.
    float height = (1.0 - 4.0 * across * across) * (1.0 - 4.0 * in_ * in_);
    float fiber = sin((in_ * 9.0 + across * 21.0) + 6.0 * bits.x) * 0.12 * fine;
    vec2 round_ = sharp * (outwards * (across * 1.1) + vec2(-outwards.y, outwards.x) * (in_ * 1.3 + fiber));

    // Three colors: bands of undyed wool and of dyed wool, with dark strands between.
    vec3 wool = vec3(0.42, 0.35, 0.26);
    vec3 dark = vec3(0.10, 0.062, 0.04);
    float band = mod(ring + 4.0, 9.0);
    float dyed = band >= 6.0 ? 1.0 : band >= 5.0 ? 0.4 : 0.0;
    float isDyed = bits.y < dyed ? 1.0 : 0.0;
    float isDark = band == 3.0 && bits.z < 0.6 ? 1.0 : 0.0;
    vec3 color = mix(wool, dye, mix(dyed, isDyed, sharp));
    color = mix(color, dark, band == 3.0 ? mix(0.6, isDark, sharp) : 0.0);

    RugPoint rug;
    rug.color = color * (1.0 + 0.22 * sharp * (bits.x - 0.5) + fiber);
    // The rim is rounded off.
    vec2 rim = outwards * smoothStep(radius - 0.03, radius, r) * 0.8;
    rug.normal = normalize(vec3(round_.x + rim.x, 1.0, round_.y + rim.y));
    rug.open = mix(0.8, mix(0.4, 1.0, smoothStep(0.0, 0.5, height)), sharp);
    return rug;
}

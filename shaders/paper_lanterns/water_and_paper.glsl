// Physically based light of lanterns and water.

// Light towards the eye: without the moon, and added if the moon is visible from there.
struct Lit {
    vec3 radiance;
    vec3 byMoon;
};

// Irradiance of the surrounding lanterns at a place, on a plane with normal `n`, the released lantern included. The
// lantern at `own` is excluded.
vec3 lanternLight(vec3 p, vec3 n, vec3 own)
{
    vec3 sum = vec3(0.0);
#ifdef LANTERNS
    vec2 g = vec2(p.x - lake.corner.x, lake.corner.y - p.z) / lake.cell;
    vec2 base = floor(clamp(g, vec2(-1e6), vec2(1e6)));
    ivec2 towards = ivec2(g.x - base.x < 0.5 ? -1 : 1, g.y - base.y < 0.5 ? -1 : 1);
    float range = lake.cell * (parameters.lightCells > 4 ? 1.3 : (parameters.lightCells > 1 ? 0.9 : 0.5));
    float area = 2.0 * lake.paperRadius * lake.paperHeight;
    for (int i = lake.released.w > 0.0 && parameters.lightCells > 0 ? -1 : 0; i < parameters.lightCells; ++i) {
        // The four nearest cells, then the other five.
        ivec2 off = i < 4 ? ivec2(i & 1, i >> 1) : (i < 7 ? ivec2(-1, i - 5) : ivec2(i - 7, -1));
        ivec2 cell = ivec2(base) + off * towards;
        Lantern l = releasedLantern();
        if (i >= 0) {
            if (!inLattice(cell)) continue;
            l = lanternAt(cell);
        }
        if (l.light < 0.0 || distance(l.place, own) < 0.01) continue;
        vec3 to = l.place + vec3(0.0, 0.5 * lake.paperHeight, 0.0) - p;
        float squared = dot(to, to);
        float inside = max(1.0 - squared / (range * range), 0.0);
        float spread = squared + 0.5 * lake.paperRadius * lake.paperRadius;
        sum += l.glow * (area * inside * inside * max(dot(n, to), 0.0) * inversesqrt(squared) / spread);
    }
#endif
    return sum;
}

// Irradiance of a wide lit tube on a plane next to it, relative to the tube's radiant exitance: that of a strip,
// reduced for the curvature.
float tubeFactor(float r, float up)
{
    float x = max(r - lake.paperRadius, 0.0);
    float h = max(lake.paperHeight - up, 0.0);
    return 0.5 * (1.0 - x / sqrt(x * x + h * h + 1e-6)) * sqrt(lake.paperRadius / max(r, lake.paperRadius));
}

Lit litPaper(LanternWalk walk, vec3 n, vec3 d, vec3 outer, vec3 moon, float width)
{
    vec3 p = walk.local;
    vec2 radial = normalize(vec2(p.x, p.z) + vec2(1e-6, 0.0));
    bool outside = dot(n.xz, radial) >= 0.0;
    vec3 fiber = parameters.fibers * paperFibers(p, lake.paperRadius, width);
    float more = clamp(1.0 + 1.3 * fiber.x, 0.25, 2.5);
    vec3 absorb = paperAbsorbOf(walk.lantern.hue) * more;
    vec3 reflected, transmitted, within;
    // Measured from the middle of the sheet, which has no thickness in this model.
    vec3 toFlame = vec3(-radial.x * lake.paperRadius, lake.flameHeight - p.y, -radial.y * lake.paperRadius);
    float squared = max(dot(toFlame, toFlame), 0.01);
    vec3 bumped = paperNormal(p, 0.02 * fiber);
    float direct = max(-dot(bumped, toFlame), 0.0) * inversesqrt(squared) / squared;
    for (int i = 0; i < 3; ++i) {
        Sheet sheet = sheetOf(lake.paperScatter * more, absorb[i]);
        reflected[i] = sheet.reflected;
        transmitted[i] = sheet.transmitted;
        within[i] = direct + wallIndirect(sheet.reflected);
    }
    vec3 candle = lake.candle * walk.lantern.light;
    vec3 fromOuter = outside ? reflected : transmitted;
    vec3 fromWithin = outside ? transmitted * (1.0 - lake.paperForward) : reflected;
    Lit lit;
    lit.radiance = (fromWithin * within * candle + fromOuter * outer) / PI;
    // The flame seen through the paper, blurred by its fibers.
    float lobe = forwardLobe(dot(toFlame, d) * inversesqrt(squared)) / squared;
    if (outside) lit.radiance += transmitted * candle * (lake.paperForward * lobe);
    // Moonlight reflected on the visible side, or transmitted through the paper.
    float facing = dot(outside ? bumped : -bumped, moon);
    lit.byMoon = (facing > 0.0 ? reflected : transmitted) * abs(facing) * lake.moonLight / PI;
    return lit;
}

// Light of the flame itself along a ray in the lantern's space, before the distance `end`; a soft ellipsoid. `width`
// of the ray's cone there. Seen from the side, it has the flame's intensity.
vec3 flameLight(vec3 o, vec3 d, float end, float width, float strength)
{
    const float radius = 0.07;
    const float slender = 2.5;  // its height over its width
    vec3 stretch = vec3(1.0, 1.0 / slender, 1.0);
    vec3 to = (vec3(0.0, lake.flameHeight, 0.0) - o) * stretch;
    vec3 e = d * stretch;
    float along = dot(to, e) / dot(e, e);
    vec3 off = to - e * along;
    float squared = radius * radius + 0.25 * width * width;
    float share = along > 0.0 && along < end ? exp(-dot(off, off) / squared) : 0.0;
    return lake.candle * (max(strength, 0.0) * share / (PI * squared * slender));
}

Lit litFrame(LanternWalk walk, vec3 n, vec3 d, vec3 outer, vec3 moon, float width)
{
    vec3 p = walk.local;
    float r = length(p.xz);
    bool wood = walk.part == PART_WOOD;
    vec3 albedo = wood ? vec3(0.30, 0.17, 0.085) : vec3(0.12, 0.085, 0.055);
    if (wood) {
        // Boards along x, with grain.
        float fade = noiseFootprintFade(width * 26.0);
        vec2 q = vec2(p.x * 1.6, p.z * 26.0);
        Noise2 grain = gradientNoise(ivec2(floor(q)) + 4096, q - floor(q), ivec2(1 << 20), 3u);
        float gap = smoothstep(0.012, 0.03, abs(abs(p.z / lake.baseHalfWidth * 2.0 - floor(p.z / lake.baseHalfWidth * 2.0 + 0.5)) * 0.5 * lake.baseHalfWidth) + width);
        albedo *= (1.0 + 0.45 * grain.value * fade) * mix(0.45, 1.0, gap);
    }
    vec3 candle = lake.candle * max(walk.lantern.light, 0.0);
    vec3 arriving;
    vec3 mirrored = vec3(0.0);
    if (r < lake.paperRadius && p.y > 0.0) {
        vec3 to = vec3(0.0, lake.flameHeight, 0.0) - p;
        float squared = max(dot(to, to), 0.01);
        vec3 l = to * inversesqrt(squared);
        arriving = candle * (max(dot(n, l), 0.0) / squared + wallIndirect(0.5));
        vec3 h = safeNormalize(l - d, n);
        mirrored = candle * (wood ? 0.02 : 0.5) * pow(max(dot(n, h), 0.0), 60.0) / squared;
    } else {
        // Irradiance from the glowing paper next to the shaded point.
        float sideways = wood ? max(n.y, 0.0) + 0.3 * max(1.0 - abs(n.y), 0.0) * step(0.0, p.y) : 1.0;
        arriving = PI * walk.lantern.glow * tubeFactor(r, max(p.y, 0.0)) * sideways;
        vec2 out2 = p.xz / max(r, 1e-4);
        float glance = max(dot(reflect(d, n), vec3(-out2.x, 0.0, -out2.y)), 0.0);
        mirrored = walk.lantern.glow * (wood ? 0.03 : 0.25) * glance * glance;
    }
    Lit lit;
    lit.radiance = albedo * (arriving + outer) / PI + mirrored;
    vec3 h = safeNormalize(moon - d, n);
    float gloss = (wood ? 0.04 : 0.4) * pow(max(dot(n, h), 0.0), 40.0);
    lit.byMoon = lake.moonLight * max(dot(n, moon), 0.0) * (albedo / PI + gloss);
    return lit;
}

struct WaterSurface {
    vec3 normal;
    vec2 hidden;  // mean square slope of waves that a pixel does not resolve: along the view and across
};

// `ahead` is the view direction in the plane, `footprint` a pixel's length along it and its width.
WaterSurface waterSurface(vec2 p, vec2 ahead, vec2 footprint)
{
    vec2 slope = vec2(0.0);
    vec2 hidden = vec2(lake.hiddenSlopes);
    for (int i = 0; i < lake.waves; ++i) {
        vec4 w = lake.wave[i];
        vec2 k = vec2(dot(w.xy, ahead), w.x * ahead.y - w.y * ahead.x);
        vec2 blurred = k * footprint;
        float fade = exp(-0.06 * dot(blurred, blurred));
        hidden += 0.5 * w.z * w.z * k * k * (1.0 - fade * fade);
        slope += w.xy * (w.z * fade * cos(dot(w.xy, p) + w.w));
    }
    return WaterSurface(normalize(vec3(-slope.x, 1.0, -slope.y)), hidden);
}

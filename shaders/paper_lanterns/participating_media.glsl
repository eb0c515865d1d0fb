// Mist over the lake, which thins with height, and the light of lanterns in it.

// Color of paper in the debug views (SHOW above 0).
const vec3 PAPER_SHOWN = vec3(0.45, 0.3, 0.1);

// Optical depth of the mist along a ray, in closed form; `t` may extend far beyond the mist.
float mistDepth(vec3 o, vec3 d, float t)
{
    float h = parameters.fogHeight;
    float begin = exp2(-1.4427 * clamp(o.y / h, -1.0, 80.0));
    float rise = d.y * t / h;
    float mean = abs(rise) < 1e-3 ? 1.0 - 0.5 * rise : (1.0 - exp(-clamp(rise, -20.0, 80.0))) / rise;
    return parameters.fog * min(begin * mean * t, 1e4);
}

float mistLeft(vec3 o, vec3 d, float t)
{
#ifdef MIST
    return exp(-mistDepth(o, d, t));
#else
    return 1.0;
#endif
}

// Light of the mist itself: its own color, and a share of the light of the lanterns inside it.
vec3 mistLight()
{
    return parameters.horizonColor + lake.candle * (lake.fill * 4e-4);
}

// In-scattered light of one lantern along the ray, up to its end: single scattering of a point light in closed form. It
// is 0 beyond 0.6 of a cell's width, so that more distant lanterns need no test.
LanternWalk withAir(LanternWalk before, LanternRay ray, Lantern l, float near)
{
    LanternWalk walk = before;
#ifdef HALO
    vec3 c = l.place + vec3(0.0, 0.5 * lake.paperHeight, 0.0);
    float along = dot(c - ray.origin, ray.direction);
    float off = length(ray.origin + ray.direction * along - c);
    float inside = 1.0 - off * off / (0.36 * lake.cell * lake.cell);
    if (inside <= 0.0) return walk;
    float h = max(off, lake.paperRadius);
    float seen = atan(max(walk.distance, ray.from) - along, h) - atan(ray.from - along, h);
    float strength = parameters.fog * exp(-max(c.y, 0.0) / parameters.fogHeight) * 0.25 / h;
    float area = 2.0 * lake.paperRadius * lake.paperHeight;
    walk.glow += walk.left * mistLeft(ray.origin, ray.direction, max(along, 0.0)) * l.glow * (area * strength * max(seen, 0.0) * inside * inside);
#endif
    return walk;
}

// Overlap of a box of half width `a` with a box of width `w` at offset `x`, divided by w.
float overlap(float x, float a, float w)
{
    float width = max(w, 1e-4);
    return clamp((a + 0.5 * width - abs(x)) / width, 0.0, min(1.0, 2.0 * a / width));
}

// Adds a lantern that is too small to be marched, or that is reflected by rough water: its paper is spread over the
// ray's cone, with the same total light.
LanternWalk withPoint(LanternWalk before, LanternRay ray, Lantern l, float near)
{
    LanternWalk walk = before;
    if (near < ray.from || near > walk.distance) return walk;
    vec2 widths = coneWidth(ray, near);
    vec2 d = vec2(ray.direction.x, ray.direction.z);
    vec2 off = vec2(l.place.x - ray.origin.x, l.place.z - ray.origin.z);
    float aside = (off.x * d.y - off.y * d.x) / max(length(d), 1e-6);
    float y = ray.origin.y + ray.direction.y * near - l.place.y;
    float middle = 0.5 * lake.paperHeight;
    float covered = overlap(aside, lake.paperRadius, widths.x) * overlap(y - middle, middle, widths.y);
    // Brighter near the flame, if the cone is narrow enough to resolve it.
    float coarse = clamp(max(widths.x, widths.y) / lake.paperRadius, 0.0, 1.0);
    float profile = mix(paperProfile(aside, clamp(y, 0.0, lake.paperHeight)), 1.0, coarse);
    float left = mistLeft(ray.origin, ray.direction, near);
#if SHOW == SHOW_PICTURE
    vec3 glow = mix(mistLight(), l.glow * profile, left);
#else
    vec3 glow = PAPER_SHOWN;
#endif
    walk.glow += walk.left * covered * glow;
    walk.left *= 1.0 - covered;
    // The base of the lantern hides the background, and is dark compared with the paper.
    float base = overlap(aside, 1.2 * lake.baseHalfWidth, widths.x);
    base *= overlap(y, lake.baseHalfHeight + lake.baseHalfWidth * abs(ray.direction.y), widths.y);
    walk.glow += walk.left * base * 0.06 * glow;
    walk.left *= 1.0 - base;
    return walk;
}

// Lanterns beyond the traversed rows: their mean, for the part of the ray's cone inside their layer. Returns light and
// transmittance. Samples a few places along the ray with geometric spacing.
vec4 farLanterns(LanternRay ray, float end)
{
    float farthest = lake.farRow > 0.0 ? lake.farRow : float(lake.cells.y) * lake.cell;
    vec2 x = slabSpan(ray.origin.x, ray.direction.x, lake.corner.x, lake.corner.x + farthest);
    vec2 z = slabSpan(ray.origin.z, ray.direction.z, lake.corner.y - farthest, lake.corner.y);
    float from = max(max(end, 1.0), max(x.x, z.x));
    float to = min(ray.to, min(x.y, z.y));
    vec4 seen = vec4(vec3(0.0), 1.0);
    if (!(from < to)) return seen;
    const int places = 6;
    float ratio = exp2(log2(to / from) / float(places));
    float middle = 0.5 * lake.paperHeight;
    float density = lake.fill * 2.0 * lake.paperRadius / (lake.cell * lake.cell) * length(vec2(ray.direction.x, ray.direction.z));
#if SHOW == SHOW_PICTURE
    vec3 glow = lake.farGlow;
#else
    vec3 glow = PAPER_SHOWN;
#endif
    float t = from;
    for (int i = 0; i < places; ++i) {
        float next = t * ratio;
        // Mean over the segment, for the width of the cone there and the height that the ray gains or loses.
        float at = 0.5 * (t + next);
        float tall = coneWidth(ray, at).y + abs(ray.direction.y) * (next - t);
        float y = ray.origin.y + ray.direction.y * at;
        float covered = 1.0 - exp(-density * (next - t) * overlap(y - middle, middle, tall));
        vec3 arriving = glow;
#if SHOW == SHOW_PICTURE
        arriving = mix(mistLight(), glow, mistLeft(ray.origin, ray.direction, at));
#endif
        seen.rgb += seen.a * covered * arriving;
        seen.a *= 1.0 - covered;
        t = next;
    }
    return seen;
}

// The sea: gravity waves in the light of the sky. Permutations: REFERENCE; HEIGHT_STEPS, step length equal to the height
// above the water; COUNT_MARCH, counts only the march, not the lighting.
#include "noise/work.glsl"

float evaluations = 0.0;

// Weight of a wave for a pixel that covers `footprint` meters, by its wavelength; see lib/noise_sums.glsl.
float waveFade(vec2 k, float footprint)
{
    return noiseFootprintFade(footprint * length(k) / (2.0 * PI));
}

// Number of standard deviations that serve as bound of slopes and curvatures. Random phases do not exceed it in
// practice.
const float SEA_BOUND = 5.5;

// Tall waves at a place, with the horizontal displacement of Gerstner waves (1809).
struct TallWater {
    float height;
    vec2 slope;
    vec2 moved;       // displacement from the water's rest position
    float top;        // SEA_HIGHEST
    float steepest;   // bound of the slope along any direction, ...
    float curvature;  // ... and of its change per meter
};

// One evaluation. The rest position of the water is improved by one Newton step from `moved`.
TallWater tallWaterAt(vec2 p, vec2 moved, float footprint)
{
    vec2 q = p - moved;
    vec2 side = vec2(0.0);
    vec2 slope = vec2(0.0);
    vec3 stretch = vec3(0.0);
    float height = 0.0;
    vec3 squares = vec3(0.0);  // of amplitude, slope and curvature
    for (int i = 0; i < work.tallWaves; ++i) {
        vec4 w = work.wave[i];
        float k = length(w.xy);
        float phase = dot(w.xy, q) - w.w;
        float a = w.z * waveFade(w.xy, footprint);
        float s = a * sin(phase);
        float c = a * cos(phase);
        vec2 ahead = w.xy * (parameters.chop / k);
        side -= ahead * s;
        stretch += vec3(w.xy * ahead, w.x * ahead.y) * c;
        slope -= w.xy * s;
        height += c;
        vec3 orders = a * vec3(1.0, k, k * k);
        squares += orders * orders;
    }
    evaluations += 1.0;
    // The derivative of p by q is a symmetric matrix, close to the identity unless the water folds over.
    vec3 m = vec3(1.0, 1.0, 0.0) - stretch;
    float area = max(m.x * m.y - m.z * m.z, 0.1);
    mat2 back = mat2(m.y, -m.z, -m.z, m.x) / area;
    vec2 further = back * (moved - side);
    vec3 bounds = vec3(SEA_HIGHEST, vec2(SEA_BOUND * parameters.boundShare)) * sqrt(0.5 * squares);
    TallWater water;
    water.height = clamp(height + dot(slope, further), -bounds.x, bounds.x);
    water.slope = back * slope;
    water.moved = moved - further;
    water.top = bounds.x;
    water.steepest = max(bounds.y, 0.02);
    water.curvature = bounds.z;
    return water;
}

struct Water {
    vec3 normal;
    float folded;   // 1 where the surface is not compressed; below 0 it folds over
    float resolved; // mean square slope of resolved waves, ...
    float hidden;   // ... and of unresolved ones
    float height;
};

Water waterAt(vec2 p, vec2 moved, float footprint)
{
    vec2 q = p - moved;
    vec2 slope = vec2(0.0);
    vec3 stretch = vec3(0.0);
    float resolved = 0.0;
    float hidden = work.hiddenSlopes;
    float height = 0.0;
    for (int i = 0; i < work.waves; ++i) {
        vec4 w = work.wave[i];
        float k = length(w.xy);
        float fade = waveFade(w.xy, footprint);
        float steep = w.z * k;
        resolved += 0.5 * steep * steep * fade * fade;
        hidden += 0.5 * steep * steep * (1.0 - fade * fade);
        if (fade <= 0.0) continue;
        float phase = dot(w.xy, q) - w.w;
        float a = w.z * fade;
        float c = cos(phase);
        slope -= w.xy * (a * sin(phase));
        stretch += vec3(w.x * w.x, w.y * w.y, w.x * w.y) * (parameters.chop * a / k * c);
        height += a * c;
    }
    evaluations += 1.0;
    // Tangents of the displaced water surface, and the remaining area.
    vec3 east = vec3(1.0 - stretch.x, slope.x, -stretch.z);
    vec3 south = vec3(-stretch.z, slope.y, 1.0 - stretch.y);
    Water water;
    vec3 n = cross(south, east);
    water.normal = safeNormalize(n.y > 0.05 ? n : vec3(n.x, 0.05, n.z), vec3(0.0, 1.0, 0.0));
    water.folded = (1.0 - stretch.x) * (1.0 - stretch.y) - stretch.z * stretch.z;
    water.resolved = resolved;
    water.hidden = hidden;
    water.height = height;
    return water;
}

struct SeaHit {
    float distance;  // distance along the ray; negative: none
    vec2 moved;      // see tallWaterAt
};

SeaHit seaHit(PortalRay ray)
{
    vec3 d = ray.direction;
    float highest = (work.seaTop - ray.origin.y) / d.y;
    float bottom = (-work.seaTop - ray.origin.y) / d.y;
    float t = max(ray.start, ray.origin.y > work.seaTop ? (d.y < 0.0 ? highest : 1e20) : 0.0);
    if (t > 2e4) return SeaHit(d.y < -1e-4 ? -ray.origin.y / d.y : -1.0, vec2(0.0));
    float along = length(d.xz);
    float last = t;
    float gapBefore = 0.0;
    vec2 moved = vec2(0.0);
    bool met = false;
    for (int i = 0; i < parameters.seaSteps; ++i) {
        vec3 p = ray.origin + d * t;
        float pixel = t * ray.footprint;
        float tolerance = parameters.hitTolerance * pixel;
        TallWater water = tallWaterAt(p.xz, moved, pixel * 2.0);
        float gap = p.y - water.height;
        if (gap < 0.0 && i == 0) return SeaHit(t, water.moved);
#ifndef HEIGHT_STEPS
        // The ray certainly hits the water here. Newton steps follow, until the next one would be too short.
        float closing = dot(water.slope, d.xz) - d.y;
        float bend = max(water.curvature * along * along, 1e-6);
        met = met || (closing > 0.0 && closing * closing > 2.0 * bend * gap);
        if (met && closing > 0.0) {
            float further = clamp(gap / closing, -2.0 * abs(t - last) - tolerance, 2.0 * t + 1.0);
            if (0.5 * bend * further * further < tolerance) return SeaHit(t + further, water.moved);
            last = t;
            moved = water.moved * exp2(-abs(further));
            t += further;
            continue;
        }
#endif
        // Between the last two points, by linear interpolation.
        if (gap < 0.0) return SeaHit(mix(last, t, gapBefore / max(gapBefore - gap, 1e-6)), water.moved);
        if (d.y > 0.0 && p.y > water.top) return SeaHit(-1.0, vec2(0.0));
        if (t > 2e4) break;
        last = t;
        gapBefore = gap;
#ifdef HEIGHT_STEPS
        if (gap < tolerance) return SeaHit(t, water.moved);
        float stride = gap;
#else
        // Lower bound on the distance at which water could reach the ray, by its greatest slope or greatest curvature.
        float stride = gap / (water.steepest * along + max(-d.y, 0.0));
        stride = max(stride, (sqrt(closing * closing + 2.0 * bend * gap) - closing) / bend);
#endif
        stride = max(stride, 0.35 * tolerance);
        // The change of the displacement is less than the stride.
        moved = water.moved * exp2(-stride);
        t += stride;
#ifndef HEIGHT_STEPS
        // Skip down to the height of the crests.
        if (d.y < 0.0) t = max(t, (water.top - ray.origin.y) / d.y);
#endif
    }
    if (d.y >= 0.0) return SeaHit(-1.0, vec2(0.0));
    // At the step limit: intersect a plane at the last height.
    return SeaHit(min(last + gapBefore / -d.y, bottom), moved);
}

// Sunlight reflected by unresolved waves: Beckmann distribution of slopes.
float glitter(vec3 n, vec3 toEye, float slopes)
{
    vec3 h = safeNormalize(work.sunDirection + toEye, n);
    float c = max(dot(n, h), 1e-3);
    float c2 = c * c;
    float d = exp((c2 - 1.0) / (c2 * slopes)) / (PI * slopes * c2 * c2);
    float f = schlick(max(dot(h, toEye), 0.0), 0.02);
    return f * d / (4.0 * max(dot(n, toEye), 0.08));
}

// Ripples finer than the last wave: noise with the hidden mean square slope, as far as a pixel resolves it.
vec2 ripples(vec2 p, float footprint, float slopes)
{
    NoiseSum s = NoiseSum(NOISE_GRADIENT, NOISE_FBM, 3, 0.55, 2.0, 0.0, NOISE_PERIOD, 31u);
    Noise3 n = noiseSum(s, vec3(p.x * 3.0, work.foamTime * 4.0, p.y * 3.0), footprint * 3.0);
    evaluations += 3.0;
    // The mean square slope of this sum is 0.55 along each axis.
    return n.slope.xz * sqrt(0.5 * slopes / 0.55);
}

// Foam at compressed crests, and the lace of old foam on their windward side.
float foamAt(vec2 p, Water water, float footprint)
{
    if (parameters.foam <= 0.0) return 0.0;
    vec2 wind = vec2(sin(parameters.windDirection), -cos(parameters.windDirection));
    // Wind stretches the foam along itself.
    vec2 q = vec2(dot(p, wind) * 0.7, dot(p, vec2(-wind.y, wind.x)) * 1.5);
    NoiseSum s = NoiseSum(NOISE_GRADIENT, NOISE_BILLOW, 4, 0.62, 2.0, 0.0, NOISE_PERIOD, 77u);
    float grain = -noiseSum(s, vec3(q.x, work.foamTime, q.y), footprint * 1.5).value;
    evaluations += 4.0;
    // Octaves that have faded are replaced by their mean.
    float amplitude = 0.45;  // Amplitude of the first octave relative to the sum.
    for (int i = 0; i < 4; ++i) {
        grain += 0.5 * amplitude * (1.0 - noiseFootprintFade(footprint * 1.5 * exp2(float(i))));
        amplitude *= 0.62;
    }
    // Compression in standard deviations of the slope; stronger wind breaks more of the crests (Monahan and
    // O'Muircheartaigh 1980, "Optimal Power-Law Description of Oceanic Whitecap Coverage", gives the share).
    float together = (1.0 - water.folded) / max(sqrt(water.resolved), 0.01);
    float least = max(2.6 - 0.1 * (parameters.windSpeed - 7.5) + 2.0 * (0.5 - parameters.foam), 0.5);
    float breaking = smoothstep(least - 0.3, least + 0.9, together);
    float fresh = smoothstep(0.0, 0.3, breaking) * smoothstep(0.75 - 0.65 * breaking, 0.95 - 0.45 * breaking, grain);
    float behind = mix(0.55, 1.0, smoothstep(-0.05, 0.1, -dot(water.normal.xz, wind)));
    behind *= smoothstep(-0.15, 0.3, water.height / work.seaTop);
    float stormy = parameters.foam * smoothstep(5.0, 16.0, parameters.windSpeed);
    float lace = behind * stormy * smoothstep(0.6, 0.85, grain + 0.25 * stormy + 0.3 * breaking);
    return clamp(max(fresh, 0.8 * lace), 0.0, 1.0);
}

vec3 waterLight(PortalRay ray, SeaHit hit)
{
    float t = hit.distance;
    vec3 p = ray.origin + ray.direction * t;
    vec3 toEye = -ray.direction;
    // A pixel is stretched along the view direction at grazing angles; sampling resolves half of that.
    float footprint = t * ray.footprint * clamp(0.25 / max(toEye.y, 0.02), 1.0, 3.0);
    Water water = waterAt(p.xz, hit.moved, footprint);
    vec3 n = water.normal;
    vec2 fine = ripples(p.xz, footprint, work.hiddenSlopes);
    n = normalize(n - vec3(fine.x, 0.0, fine.y) * n.y);
    water.hidden -= work.hiddenSlopes * 0.7 * noiseFootprintFade(footprint * 6.0);
    float cosine = dot(n, toEye);
    if (cosine < 0.02) n = safeNormalize(n + toEye * (0.02 - cosine), vec3(0.0, 1.0, 0.0));
    cosine = max(dot(n, toEye), 0.02);
    // Among unresolved slopes, those that face the eye are more visible. They reflect a higher part of the sky, and
    // less of it.
    float rough = sqrt(water.hidden);
    float fresnel = schlick(clamp(cosine + 0.55 * rough, 0.0, 1.0), 0.02);
    vec3 mirrored = reflect(-toEye, n);
    mirrored.y = abs(mirrored.y) + 0.9 * rough;
    vec3 sky = skyLight(normalize(mirrored));
    vec3 sun = sunLight();
    vec3 day = skyAmbient(1.0) + sun * max(work.sunDirection.y, 0.0) * 0.35;
    // Light through a crest, seen against the sun.
    float thin = smoothstep(0.0, work.seaTop, water.height) * pow(clamp(dot(-toEye, work.sunDirection) * 0.5 + 0.5, 0.0, 1.0), 3.0);
    vec3 body = parameters.water * (day * 0.9 + sun * thin * 1.6) * (1.0 + 0.35 * clamp(water.height / work.seaTop, -1.0, 1.0));
    vec3 color = mix(body, sky, fresnel);
    color += sun * glitter(n, toEye, max(water.hidden, 0.0008)) * max(dot(n, work.sunDirection), 0.0) * 1.0;
    float foam = foamAt(p.xz, water, footprint);
    vec3 white = vec3(0.85) * (skyAmbient(n.y) + sun * max(dot(n, work.sunDirection), 0.0) * 0.32);
    color = mix(color, white, foam * 0.85);
    return throughAir(color, ray.direction, t, mix(40000.0, 1800.0, sqrt(parameters.haze)));
}

// Sky with thin high clouds.
vec3 highClouds(vec3 d, float footprint)
{
    vec3 sky = skyLight(d) + sunDisk(d);
    if (d.y < 0.004) return sky;
    vec2 p = d.xz / (d.y + 0.05) * vec2(0.55, 1.3);
    float blur = footprint / ((d.y + 0.05) * (d.y + 0.05));
    NoiseSum s = NoiseSum(NOISE_GRADIENT, NOISE_FBM, 5, 0.52, 2.0, 0.0, NOISE_PERIOD, uint(parameters.seed) + 500u);
    float n = noiseWarpedSum(s, vec3(p.x * 0.9 + 3.0, work.skyTime, p.y * 0.9), 0.5, blur).value;
    evaluations += 20.0;
    float veil = smoothstep(-0.02, 0.42, n) * smoothstep(0.0, 0.12, d.y) * 0.75;
    float cosine = dot(d, work.sunDirection);
    vec3 lit = sunLight() * (0.10 + 0.24 * pow(max(cosine, 0.0), 8.0)) + skyAmbient(-0.2) * 0.7;
    return mix(sky, lit, veil);
}

#ifdef REFERENCE
#include "noise/reference_sea.glsl"
#endif

PortalSeen portalSeen(PortalRay ray)
{
#ifdef REFERENCE
    return referenceSea(ray);
#else
    PortalSeen seen = nothingSeen();
    SeaHit hit = seaHit(ray);
#ifdef COUNT_MARCH
    seen.evaluations = evaluations;
#endif
    if (hit.distance > 0.0) {
        seen.radiance = waterLight(ray, hit);
        seen.normal = vec3(0.0, 1.0, 0.0);
        seen.distance = hit.distance;
    } else {
        seen.radiance = throughAir(highClouds(ray.direction, ray.footprint), ray.direction, max(0.03 - ray.direction.y, 0.0) * 2e4, 3000.0);
    }
#ifndef COUNT_MARCH
    seen.evaluations = evaluations;
#endif
    return seen;
#endif
}

#include "kit/portal/main.glsl"

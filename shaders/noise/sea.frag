// The sea: gravity waves in the light of the sky. Permutations: REFERENCE; HEIGHT_STEPS, step length equal to the height
// above the water; COUNT_MARCH, counts only the march, not the lighting.
#define COPY_BLOCKS
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
    float hidden;   // mean square slope of unresolved waves
    float height;
    float area;     // area of the water where waves that can break have drawn it together, 1 at rest, ...
    float areaLast; // ... the same FOAM_AGE seconds ago, ...
    float areaSeen; // ... and the share of its variance that is resolved
};

// Determinant of the identity minus a symmetric matrix (xx, yy, xy).
float areaOf(vec3 stretch)
{
    return (1.0 - stretch.x) * (1.0 - stretch.y) - stretch.z * stretch.z;
}

Water waterAt(vec2 p, vec2 moved, float footprint)
{
    vec2 q = p - moved;
    vec2 slope = vec2(0.0);
    vec3 stretch = vec3(0.0);
    vec3 breaking = vec3(0.0);
    vec3 broken = vec3(0.0);
    float seen = 0.0;
    float hidden = work.hiddenSlopes;
    float height = 0.0;
    for (int i = 0; i < work.waves; ++i) {
        vec4 w = work.wave[i];
        float k = length(w.xy);
        float fade = waveFade(w.xy, footprint);
        float steep = w.z * k;
        hidden += 0.5 * steep * steep * (1.0 - fade * fade);
        if (fade <= 0.0) continue;
        float phase = dot(w.xy, q) - w.w;
        float a = w.z * fade;
        float c = cos(phase);
        float s = sin(phase);
        slope -= w.xy * (a * s);
        vec3 drawn = vec3(w.x * w.x, w.y * w.y, w.x * w.y) * (parameters.chop * a / k);
        stretch += drawn * c;
        height += a * c;
        vec4 breaks = work.breaking[i];
        breaking += drawn * (breaks.x * c);
        broken += drawn * (breaks.y * c - breaks.z * s);
        seen += 0.5 * steep * steep * fade * fade * breaks.x * breaks.x;
    }
    evaluations += 1.0;
    // Tangents of the displaced water surface, and the remaining area.
    vec3 east = vec3(1.0 - stretch.x, slope.x, -stretch.z);
    vec3 south = vec3(-stretch.z, slope.y, 1.0 - stretch.y);
    Water water;
    vec3 n = cross(south, east);
    water.normal = safeNormalize(n.y > 0.05 ? n : vec3(n.x, 0.05, n.z), vec3(0.0, 1.0, 0.0));
    water.hidden = hidden;
    water.height = height;
    water.area = areaOf(breaking);
    water.areaLast = areaOf(broken);
    water.areaSeen = clamp(seen / max(work.foamDeviation * work.foamDeviation, 1e-9), 0.0, 1.0);
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
        // The hit lies between the last two points; linear interpolation finds it.
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

// Ripples finer than the last wave: noise with the hidden mean square slope, as far as a pixel resolves it.
vec2 ripples(vec2 p, float footprint, float slopes)
{
    NoiseSum s = NoiseSum(NOISE_GRADIENT, NOISE_FBM, 3, 0.55, 2.0, 0.0, NOISE_PERIOD, 31u);
    Noise3 n = noiseSum(s, vec3(p.x * 3.0, work.foamTime * 4.0, p.y * 3.0), footprint * 3.0);
    evaluations += 3.0;
    // The mean square slope of this sum is 0.55 along each axis.
    return n.slope.xz * sqrt(0.5 * slopes / 0.55);
}

// Probability that the water breaks: the logistic curve about the normal distribution of the unresolved part of the
// area. Near the eye it is an edge of fixed softness.
float breakingShare(float area, float seen)
{
    float deviation = parameters.chop * work.foamDeviation;
    float width = max(deviation * sqrt(1.0 - seen), 0.16 * deviation + 1e-4);
    return 1.0 / (1.0 + exp(clamp(1.702 * (area - work.foamBelow) / width, -40.0, 40.0)));
}

// Cover of foam and spray over the water, 0 to 1 each.
struct Foam {
    float cover;
    float spray;
};

// Foam where crests break, and its lace where they have broken: waves leave it behind on their windward side.
Foam foamAt(vec2 p, Water water, float footprint)
{
    Foam foam = Foam(0.0, 0.0);
    if (work.foamBelow <= 0.0) return foam;
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
    float fresh = breakingShare(water.area, water.areaSeen);
    float old = breakingShare(water.areaLast, water.areaSeen);
    float froth = smoothstep(0.9 - 0.5 * fresh, 1.1 - 0.45 * fresh, grain) * smoothstep(0.03, 0.25, fresh);
    float lace = smoothstep(0.95 - 0.4 * old, 1.1 - 0.3 * old, grain) * smoothstep(0.05, 0.5, old);
    foam.cover = clamp(max(froth, 0.7 * lace), 0.0, 1.0);
    // Droplets that the wind tears off the crest, seen as a veil.
    foam.spray = 0.35 * smoothstep(0.3, 1.0, fresh) * smoothstep(5.0, 18.0, parameters.windSpeed);
    return foam;
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
    color += sun * (sunGlitter(n, toEye, max(water.hidden, 0.0025)) * max(dot(n, work.sunDirection), 0.0));
    Foam foam = foamAt(p.xz, water, footprint);
    // Light passes through bubbles and droplets, so foam is lit from behind, too.
    float lit = mix(0.35 + 0.65 * dot(n, work.sunDirection), max(dot(n, work.sunDirection), 0.0), 0.5);
    vec3 white = 0.85 * (skyAmbient(n.y) + sun * (max(lit, 0.0) * 0.3183));
    color = mix(color, white, foam.cover * 0.92);
    float ahead = max(dot(-toEye, work.sunDirection), 0.0);
    color = mix(color, skyAmbient(0.0) + sun * (0.08 + 0.5 * pow(ahead, 12.0)), foam.spray);
    return throughAir(color, ray.direction, t, mix(40000.0, 1800.0, sqrt(parameters.haze)));
}

// Sky with thin high clouds.
vec3 highClouds(vec3 d, float footprint)
{
    vec3 sky = skyLight(d) + sunDisk(d, footprint);
    if (d.y < 0.004) return sky;
    vec2 p = d.xz / (d.y + 0.05) * vec2(0.55, 1.3);
    float blur = footprint / ((d.y + 0.05) * (d.y + 0.05));
    NoiseSum s = NoiseSum(NOISE_GRADIENT, NOISE_FBM, 5, 0.52, 2.0, 0.0, NOISE_PERIOD, uint(parameters.seed) + 500u);
    float n = noiseWarpedSum(s, vec3(p.x * 0.9 + 3.0, work.skyTime, p.y * 0.9), 0.5, blur).value;
    evaluations += 20.0;
    float veil = smoothstep(-0.02, 0.42, n) * smoothstep(0.0, 0.12, d.y) * 0.75;
    float cosine = dot(d, work.sunDirection);
    vec3 lit = work.sunOnClouds * (0.07 + 0.22 * pow(max(cosine, 0.0), 8.0)) + skyAmbient(-0.2) * 0.7;
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

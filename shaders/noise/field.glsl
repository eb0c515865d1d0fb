// The field: noise, or a sum of octaves, that is solid above a threshold. The safe step along a ray follows from bounds
// on the noise's slope and curvature, octave by octave: far from the solid, the first octaves are sufficient.

// Permutations: FIELD_KIND, a NOISE_ kind; FIELD_SUM, a NOISE_ sum; WARP; BAKED, with an octave in a volume texture.
// These are compile-time choices, because software drivers execute both sides of a branch.

float evaluations = 0.0;  // number of octaves evaluated
float lookups = 0.0;

#ifdef BAKED
layout(binding = UNIT_EXHIBIT_A) uniform sampler3D bakedNoise;
#endif

// One octave at a point of its lattice. All octaves use the same noise, with an offset and a rotation for each.
Noise3 fieldOctave(vec3 p, int octave, const bool looked)
{
    Noise3 n;
#ifdef BAKED
    if (looked) {
        n.value = textureLod(bakedNoise, (p + work.places[octave].xyz + vec3(work.cells[octave].xyz)) / float(FIELD_REPEAT), 0.0).r;
        n.slope = vec3(0.0);
        lookups += 1.0;
        return n;
    }
#endif
    evaluations += 1.0;
    return noiseNear(FIELD_KIND, p, work.cells[octave].xyz, work.places[octave].xyz, ivec3(FIELD_REPEAT), uint(parameters.seed));
}

struct FieldPoint {
    float outside;  // threshold minus noise: positive in empty space
    vec3 slope;
    float stride;   // safe step along the ray; 0 if unknown
    bool complete;  // true if all octaves were evaluated
};

// Displaces the point by up to `warp` cells of the first octave. Also returns the transposed derivative.
vec3 warpedPoint(vec3 p, out mat3 jacobian)
{
    jacobian = mat3(1.0);
    vec3 moved = p;
#ifdef WARP
    float f = parameters.frequency * 0.5;
    for (int i = 0; i < 3; ++i) {
        Noise3 n = noiseNear(NOISE_GRADIENT, p * f, work.cells[NOISE_OCTAVES - 1].xyz, work.places[NOISE_OCTAVES - 1].xyz, ivec3(0), uint(parameters.seed) + 901u + uint(i));
        moved[i] += n.value * parameters.warp / parameters.frequency;
        jacobian[i] += n.slope * (parameters.warp * 0.5);
        evaluations += 1.0;
    }
#endif
    return moved;
}

// Upper bound on the stretch of space by the domain warping.
float warpStretch()
{
#ifdef WARP
    return 1.0 + parameters.warp * 0.5 * noiseSteepest(NOISE_GRADIENT) * 1.7320508;
#else
    return 1.0;
#endif
}

// Upper bound on the error of the sum if it is looked up.
float lookedUpError()
{
    return noiseLookedUpError(FIELD_KIND) * noiseShapedSteepest(FIELD_SUM);
}

// Evaluates the field. `all`: all octaves, for value and slope; otherwise only as many as needed for the safe step.
// `clear` is added to the empty side, and falls by at most CLEARING_SLOPE per meter. `looked`: uses lookups, which give
// no slope.
const float CLEARING_SLOPE = 1.0 / 6.0;

FieldPoint fieldAt(vec3 p, vec3 direction, float footprint, float clear, bool all, const bool looked)
{
    mat3 jacobian;
    vec3 q = warpedPoint(p, jacobian);
    mat3 turn = noiseRotation(parameters.octaveRotation) * parameters.lacunarity;
    mat3 domain = mat3(parameters.frequency);
    float stretch = warpStretch();
    float curved = !looked && FIELD_SUM == NOISE_FBM && stretch == 1.0 ? noiseMostCurved(FIELD_KIND) : 0.0;
    float steepest = noiseSteepest(FIELD_KIND) * noiseShapedSteepest(FIELD_SUM) * stretch;
    float amplitude = 1.0 / work.amplitudes;
    float frequency = parameters.frequency;
    // Upper bound on octaves not evaluated yet, and on the error of the others.
    float rest = 1.0 + (looked ? lookedUpError() : 0.0);
    float fall = clear > 0.0 ? CLEARING_SLOPE : 0.0;
    float slopeBound = fall;
    float curveBound = 0.0;
    FieldPoint found;
    found.outside = parameters.threshold + clear;
    found.slope = vec3(0.0);
    found.stride = 0.0;
    found.complete = false;
    for (int i = 0; i < work.octaves; ++i) {
        found.complete = i + 1 == work.octaves;
        float fade = i == 0 ? 1.0 : noiseFootprintFade(footprint * frequency * 0.6);
        rest -= amplitude;
        if (fade > 0.0) {
            Noise3 n = noiseShaped(FIELD_SUM, fieldOctave(domain * q, i, looked));
            found.outside -= n.value * (amplitude * fade);
            found.slope -= (transpose(domain) * n.slope) * (amplitude * fade);
        }
        slopeBound += amplitude * fade * steepest * frequency;
        curveBound += amplitude * fade * curved * frequency * frequency;
        float empty = found.outside - max(rest, 0.0) * parameters.boundShare;
        if (!all && empty > 0.0) {
            float stride = empty / (slopeBound * parameters.boundShare);
            if (curveBound > 0.0) {
                // Worst case of the curvature: f + f' t - c t^2 / 2 is still positive.
                float along = dot(found.slope, direction) - fall;
                float curve = curveBound * parameters.boundShare;
                stride = max(stride, (along + sqrt(along * along + 2.0 * curve * empty)) / curve);
            }
            found.stride = max(found.stride, stride);
            if (empty > 0.3 * found.outside) break;
        }
        domain = turn * domain;
        amplitude *= parameters.gain;
        frequency *= parameters.lacunarity;
        if (fade <= 0.0) {
            found.complete = true;
            break;
        }
    }
    found.slope = jacobian * found.slope;
    return found;
}

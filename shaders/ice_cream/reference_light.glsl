// Light of the reference: one sun, a warm ambient light, five occlusion samples, fog that fades to black. All in the
// body's own space, where the sun is fixed while the camera moves.

vec3 referenceSun()
{
    return parameters.referenceSun * inversesqrt(dot(parameters.referenceSun, parameters.referenceSun));
}

// Ambient occlusion: `occlusionTaps` samples along the normal, each with half the weight of the sample a quarter of the
// way before it. Five samples are those of the reference, after Quilez 2008, "Rendering Worlds with Two Triangles";
// more samples keep the sum of weights.
float referenceOcclusion(vec3 p, vec3 n)
{
    if (!parameters.ambientOcclusion) return 1.0;
    float hidden = 0.0;
    float weights = 0.0;
    int taps = max(parameters.occlusionTaps, 2);
    for (int i = 0; i < taps; ++i) {
        float along = float(i) / float(taps - 1);
        float weight = exp2(-4.0 * along);
        float h = 1.0e-5 + 0.6 * along;
        vec3 q = p + n * h;
        float level = iceCreamLevel(q);
        if (parameters.ground) level = min(level, q.y);
        hidden += weight * (h - level);
        weights += weight;
    }
    evaluations += taps;
    return clamp(1.0 - 1.5 * hidden * 1.9375 / weights, 0.0, 1.0);
}

// Radiance of a surface towards the eye. `toEye` and `s.normal` in the body's own space; `visible` is the sun's
// visibility.
vec3 referenceReflected(Surface s, vec3 toEye, float visible)
{
    vec3 l = referenceSun();
    vec3 sunLight = parameters.referenceSunColor * parameters.referenceSunStrength;
    vec3 direct;
    if (parameters.highlight == highlight_GGX) {
        direct = lightReflected(s, toEye, l, sunLight * (PI * visible));
    } else {
        float diffuse = clamp(dot(s.normal, l), 0.0, 1.0) * visible;
        float shine = powPositive(clamp(dot(safeNormalize(l + toEye, s.normal), s.normal), 0.0, 1.0), exp2(10.0 * (1.0 - s.roughness)));
        direct = (s.baseColor + (s.specular > 0.0 ? shine : 0.0)) * sunLight * diffuse;
    }
    // More ambient light from above than from below.
    return direct + s.baseColor * parameters.referenceAmbient * (s.occlusion * clamp(0.5 + 0.5 * s.normal.y, 0.0, 1.0));
}

// Applies fog at `t` meters from the eye. Divides by the hall's exposure, because the values are those of the
// reference.
vec3 referenceFogged(vec3 color, float t)
{
    return color * exp(-parameters.referenceFog * t * t * t) / light.exposure;
}

// The light of the source: one sun, a warm ambient light, five samples of occlusion, fog that fades to black. All of it
// in the body's own space, where the sun stands still while the camera goes round.

vec3 sourceSun()
{
    return parameters.sourceSun * inversesqrt(dot(parameters.sourceSun, parameters.sourceSun));
}

// Share of the ambient light: `occlusionTaps` samples up the normal, each with half the weight of one a quarter of the way
// before it. Five are those of the source, after Quilez 2008, "Rendering Worlds with Two Triangles"; more keep their sum.
float sourceOcclusion(vec3 p, vec3 n)
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

// Light that a surface sends to the eye. `toEye` and `s.normal` in the body's own space, `visible` the sun's share there.
vec3 sourceReflected(Surface s, vec3 toEye, float visible)
{
    vec3 l = sourceSun();
    vec3 sunLight = parameters.sourceSunColor * parameters.sourceSunStrength;
    vec3 direct;
    if (parameters.highlight == highlight_GGX) {
        direct = lightReflected(s, toEye, l, sunLight * (PI * visible));
    } else {
        float diffuse = clamp(dot(s.normal, l), 0.0, 1.0) * visible;
        float shine = powPositive(clamp(dot(safeNormalize(l + toEye, s.normal), s.normal), 0.0, 1.0), exp2(10.0 * (1.0 - s.roughness)));
        direct = (s.baseColor + (s.specular > 0.0 ? shine : 0.0)) * sunLight * diffuse;
    }
    // More from above than from below.
    return direct + s.baseColor * parameters.sourceAmbient * (s.occlusion * clamp(0.5 + 0.5 * s.normal.y, 0.0, 1.0));
}

// `t` meters from the eye. The hall's exposure is taken back: the numbers are the source's.
vec3 sourceFogged(vec3 color, float t)
{
    return color * exp(-parameters.sourceFog * t * t * t) / light.exposure;
}

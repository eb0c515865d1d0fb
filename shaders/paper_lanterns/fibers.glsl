// Fibers of a lantern's paper. GLSL 4.50 and C++ (exhibits/paper_lanterns/paper_lanterns_cpu.h); include it after
// lib/noise_sums.glsl.

// Relative thickness of the paper at a place of the tube, and its change per meter around and per meter up. Noise on
// the unrolled paper repeats after whole cells, so there is no seam. Octaves finer than `width` fade out.
vec3 paperFibers(vec3 p, float radius, float width)
{
    vec3 sum = vec3(0.0);
    float turns = angleOf(p.z, p.x) / (2.0 * PI);
    int around = 18;
    float up = 5.0;
    float amplitude = 0.55;
    for (int octave = 0; octave < 3; ++octave) {
        vec2 perMeter = vec2(float(around) / (2.0 * PI * radius), up);
        float fade = noiseFootprintFade(width * max(perMeter.x, perMeter.y));
        vec2 q = vec2(turns * float(around), p.y * up);
        vec2 cell = floor(q);
        Noise2 n = gradientNoise(ivec2(int(cell.x), int(cell.y)), q - cell, ivec2(around, 0), 9u + uint(octave));
        sum += vec3(n.value, n.slope.x * perMeter.x, n.slope.y * perMeter.y) * (amplitude * fade);
        around *= 2;
        up *= 2.0;
        amplitude *= 0.57;
    }
    return sum;
}

// Outward normal of the paper in the lantern's space, tilted by the fibers. `fiber` is as above, times the height of
// the fibers in meters. The frame of the tube is around, up and outwards, all unit vectors.
vec3 paperNormal(vec3 p, vec3 fiber)
{
    float r = max(length(vec2(p.x, p.z)), 1.0e-6);
    vec3 outwards = vec3(p.x / r, 0.0, p.z / r);
    vec3 about = vec3(-outwards.z, 0.0, outwards.x);
    return normalize(outwards - about * fiber.y - vec3(0.0, fiber.z, 0.0));
}

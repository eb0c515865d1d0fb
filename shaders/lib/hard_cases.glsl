// The library's functions at inputs that break naive code, one number for each: `hardCase` by the library, `naiveCase`
// by the usual formula. exhibits/stability/stability_arithmetic.cpp compiles this file at float64 and lists the inputs
// of each case.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).

float hardCase(int which, vec4 a)
{
    if (which == 0) return schlick(a.x, a.y);
    if (which == 1) return safeAcos(a.x);
    if (which == 2) return angleOf(a.x, a.y);
    if (which == 3) return fractBelowOne(a.x);
    if (which == 4) return powPositive(a.x, a.y);
    if (which == 5) return smoothStep(a.x, a.y, a.z);
    if (which == 6) return safeNormalize(vec3(a.x, a.y, a.z), vec3(0.0, 1.0, 0.0)).y;
    if (which == 7) return fresnelDielectric(a.x, a.y);
    if (which == 8) return sdfSmoothUnion(a.x, a.y, a.z);
    if (which == 9) return sdfSmoothUnionExponential(a.x, a.y, a.z);
    if (which == 10) return sdfEllipsoid(vec3(a.x, a.y, 0.0), vec3(1.0, 2.0, a.z));
    if (which == 11) return sdfCapsule(vec3(1.0, 0.5, 0.25), vec3(0.0), vec3(a.x, 0.0, 0.0), 0.25);
    if (which == 12) return sdfCappedCone(vec3(1.0, a.y, 0.0), a.x, 0.5, 0.5);
    if (which == 13) return sdfMix(a.x, a.y, a.z);
    if (which == 14) return unitFromBits(hashCell(ivec3(int(a.x), int(a.y), -5), 1u).x);
    if (which == 15) return safeSqrt(a.x);
    return finiteOr(a.x / a.y, 7.0);
}

float naiveCase(int which, vec4 a)
{
    if (which == 0) return a.y + (1.0 - a.y) * pow(1.0 - a.x, 5.0);
    if (which == 1) return acos(a.x);
    if (which == 2) return atan(a.x, a.y);
    if (which == 3) return fract(a.x);
    if (which == 4) return pow(a.x, a.y);
    if (which == 5) return smoothstep(a.x, a.y, a.z);
    if (which == 6) return normalize(vec3(a.x, a.y, a.z)).y;
    if (which == 8) {
        float h = max(a.z - abs(a.x - a.y), 0.0) / a.z;
        return min(a.x, a.y) - h * h * a.z * 0.25;
    }
    if (which == 9) return -a.z * log2(exp2(-a.x / a.z) + exp2(-a.y / a.z));
    if (which == 10) {
        vec3 r = vec3(1.0, 2.0, a.z);
        vec3 p = vec3(a.x, a.y, 0.0);
        float k0 = length(p / r);
        return k0 * (k0 - 1.0) / length(p / (r * r));
    }
    if (which == 11) {
        vec3 b = vec3(a.x, 0.0, 0.0);
        vec3 p = vec3(1.0, 0.5, 0.25);
        return length(p - b * clamp(dot(p, b) / dot(b, b), 0.0, 1.0)) - 0.25;
    }
    if (which == 13) return a.x + (a.y - a.x) * a.z;
    if (which == 15) return sqrt(a.x);
    if (which == 16) return a.x / a.y;
    return hardCase(which, a);
}

// Evaluates a solid or operator of the library, by number, so that results on the GPU and the CPU can be compared at
// many points.
float libraryField(int which, vec3 p)
{
    if (which == 0) return sdfSphere(p, 0.75);
    if (which == 1) return sdfBox(p, vec3(0.5, 0.25, 0.75));
    if (which == 2) return sdfRoundBox(p, vec3(0.5, 0.25, 0.75), 0.125);
    if (which == 3) return sdfBoxFrame(p, vec3(0.5, 0.5, 0.75), 0.125);
    if (which == 4) return sdfTorus(p, 0.625, 0.25);
    if (which == 5) return sdfCappedTorus(p, 0.75, 0.625, 0.125);
    if (which == 6) return sdfLink(p, 0.25, 0.375, 0.125);
    if (which == 7) return sdfRoundCylinder(p, 0.5, 0.375, 0.125);
    if (which == 8) return sdfCapsule(p, vec3(-0.375, 0.125, 0.0), vec3(0.5, 0.25, -0.375), 0.25);
    if (which == 9) return sdfCappedCone(p, 0.5, 0.75, 0.25);
    if (which == 10) return sdfCone(p, 0.625, 0.875);
    if (which == 11) return sdfRoundCone(p, 0.5, 0.25, 0.75);
    if (which == 12) return sdfEllipsoidBound(p, vec3(0.75, 0.25, 0.5));
    if (which == 13) return sdfOctahedron(p, 0.75);
    if (which == 14) return sdfHexPrism(p, 0.5, 0.25);
    if (which == 15) return sdfTriangularPrism(p, 0.375, 0.25);
    if (which == 16) return sdfSolidAngle(p, 0.75, 0.875);
    if (which == 17) return sdfCutSphere(p, 0.75, 0.25);
    if (which == 18) return sdfTriangle(p, vec3(-0.5, 0.0, 0.0), vec3(0.625, 0.25, 0.125), vec3(0.0, 0.5, -0.625));
    float a = sdfBox(p - vec3(0.25, 0.0, 0.0), vec3(0.5, 0.25, 0.375));
    float b = sdfSphere(p + vec3(0.25, -0.125, 0.125), 0.5);
    if (which == 19) return sdfSmoothUnion(a, b, 0.25);
    if (which == 20) return sdfSmoothUnionCubic(a, b, 0.25);
    if (which == 21) return sdfSmoothUnionExponential(a, b, 0.125);
    if (which == 22) return sdfSmoothSubtraction(a, b, 0.25);
    return sdfMix(a, b, 1.25);
}

// Pseudo-random point of the cube from -1.5 to 1.5 on a lattice of 2^-20: exact at any precision.
vec3 libraryPoint(int index)
{
    uvec3 bits = pcg3d(uvec3(uint(index), 17u, 29u)) >> 12u;
    return vec3(float(bits.x), float(bits.y), float(bits.z)) * (3.0 / 1048576.0) - vec3(1.5);
}

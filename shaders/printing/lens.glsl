// One lens of a lenticular sheet: where a camera ray hits the print under it, by exact refraction (Snell's law on a
// conic). Also the share of a blurred piece of print before a strip's edge.
//
// x lies across the lens, 0 on its axis; z points out of the sheet, 0 at the lens's top; the print lies at z =
// -thickness. All lengths in one unit, chosen by the caller.
//
// GLSL 4.50 and C++ (exhibits/printing/lens_cpu.h).

struct LensShape {
    float pitch;
    float radius;     // radius of curvature at the top
    float thickness;  // from the top down to the print
    float conic;      // 0: a circle
    float index;      // refractive index
};

struct LensRay {
    float x;       // position on the print
    float weight;  // visible area of this part of the lens, per length across; 0 if it is hidden
    float depth;   // depth of the print below the surface
    float tanPsi;  // tangent of the ray's angle inside, in the plane across the lens
};

// Returns 1 - (1+K) x^2/r^2, the radicand of the surface's formula.
float lensUnderRoot(LensShape s, float x)
{
    return 1.0 - (1.0 + s.conic) * x * x / (s.radius * s.radius);
}

// Returns the depth of the surface below its top, at x.
float lensSag(LensShape s, float x)
{
    return x * x / (s.radius * (1.0 + safeSqrt(lensUnderRoot(s, x))));
}

// Returns the downward slope of the surface towards positive x.
float lensSlope(LensShape s, float x)
{
    return x / (s.radius * sqrt(max(lensUnderRoot(s, x), 1.0e-9)));
}

// Returns the effective index of the plane problem for a ray whose component along the lens is `along` of its length.
// Exact for cylinders, because refraction keeps that component.
float lensIndexAskew(float index, float along)
{
    return sqrt((index * index - along * along) / max(1.0 - along * along, 1.0e-6));
}

// Returns whether the neighboring lens towards the eye hides the surface at x: the ray must pass that lens at its
// tangent point. `sine` and `cosine` are of the eye's angle from the normal; cosine > 0.
bool lensHidden(LensShape s, float x, float sine, float cosine)
{
    float side = sine < 0.0 ? -1.0 : 1.0;
    float steep = abs(sine);
    float halfPitch = 0.5 * s.pitch;
    // No part of the next lens can hide a ray that is steeper than its steepest part.
    if (!(cosine < steep * lensSlope(s, halfPitch))) return false;
    float cotangent = cosine / steep;
    float touch = cotangent * s.radius / sqrt(1.0 + cotangent * cotangent * (1.0 + s.conic));
    float here = side * x * cosine + lensSag(s, x) * steep;
    float there = (s.pitch - touch) * cosine + lensSag(s, touch) * steep;
    return here > there;
}

// Traces the camera ray with direction (sine, cosine) from the normal across the lens, which hits it at x. The weight
// is 0 if there is no surface, if it faces away from the eye, or if the next lens hides it.
LensRay lensTrace(LensShape s, float x, float sine, float cosine)
{
    LensRay ray;
    ray.x = 0.0;
    ray.weight = 0.0;
    ray.depth = s.thickness;
    ray.tanPsi = 0.0;
    if (!(lensUnderRoot(s, x) > 0.0) || !(cosine > 0.0)) return ray;
    float slope = lensSlope(s, x);
    float stretch = sqrt(1.0 + slope * slope);
    float cosI = (cosine + sine * slope) / stretch;
    if (!(cosI > 0.0) || lensHidden(s, x, sine, cosine)) return ray;
    float sinInside = (sine - cosine * slope) / (stretch * s.index);
    float cosInside = safeSqrt(1.0 - sinInside * sinInside);
    ray.tanPsi = (slope * cosInside + sinInside) / (cosInside - slope * sinInside);
    ray.depth = s.thickness - lensSag(s, x);
    ray.x = x - ray.depth * ray.tanPsi;
    ray.weight = cosI * stretch;
    return ray;
}

// Returns where the undeviated ray through the center of curvature hits the print; `tangent` is of the eye's angle.
float lensChiefRay(LensShape s, float tangent)
{
    return -(s.thickness - s.radius) * tangent;
}

// First-order approximation in x and the angle `theta`: x (1 - t/f) - t/n theta, with f = n r / (n-1).
float lensParaxial(LensShape s, float x, float theta)
{
    float focus = s.index * s.radius / (s.index - 1.0);
    return x * (1.0 - s.thickness / focus) - s.thickness / s.index * theta;
}

// Returns the share before t of two boxes of widths a and b >= 0, convolved and centered on 0. The area of a trapezoid;
// of a box if one width is 0; a step if both are.
float boxesBefore(float t, float a, float b)
{
    float outer = 0.5 * (a + b);
    if (t <= -outer) return 0.0;
    if (t >= outer) return 1.0;
    float inner = 0.5 * abs(a - b);
    if (t < -inner) return (t + outer) * (t + outer) / (2.0 * a * b);
    if (t > inner) return 1.0 - (outer - t) * (outer - t) / (2.0 * a * b);
    return 0.5 + t / max(a, b);
}

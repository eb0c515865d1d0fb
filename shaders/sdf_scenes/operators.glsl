// Operators of scene files on distances and points, in addition to lib/sdf_operators.glsl. Every function keeps fields
// 1-Lipschitz: if an operation stretches space, the distance is divided by the largest stretch.
//
// A blend of two fields also has a share: the weight of the second one in the result, 0 to 1. It is the derivative of
// the blended distance with respect to the second, so that materials change where the surface does.
//
// GLSL 4.50 and C++ (exhibits/sdf_scenes/scene_functions_cpu.h).

#ifndef __cplusplus
#include "lib/numerics.glsl"
#include "lib/sdf.glsl"
#include "lib/sdf_operators.glsl"
#endif

// Profiles of a blend. All begin where the two distances differ by `k`, except the exponential one, which has no end.
const int SCENE_QUADRATIC = 0;
const int SCENE_CUBIC = 1;
const int SCENE_CIRCULAR = 2;
const int SCENE_EXPONENTIAL = 3;

// Union with a circular arc between perpendicular faces; adds at most 0.3 k. k = 0 is the hard union. Quilez 2023,
// "Smooth minimum", circular geometrical.
float sceneSmoothUnionCircular(float a, float b, float k)
{
    if (!(k > SDF_NARROWEST_BLEND)) return min(a, b);
    float width = min(k, SDF_WIDEST_BLEND);
    float h = max(width - abs(a - b), 0.0) / width;
    return min(a, b) - 0.5 * width * (1.0 + h - sqrt(1.0 + h * (2.0 - h)));
}

float sceneUnion(float a, float b, float k, int profile)
{
    if (profile == SCENE_CUBIC) return sdfSmoothUnionCubic(a, b, k);
    if (profile == SCENE_CIRCULAR) return sceneSmoothUnionCircular(a, b, k);
    if (profile == SCENE_EXPONENTIAL) return sdfSmoothUnionExponential(a, b, k);
    return sdfSmoothUnion(a, b, k);
}

float sceneIntersection(float a, float b, float k, int profile)
{
    return -sceneUnion(-a, -b, k, profile);
}

// a without b.
float sceneSubtraction(float a, float b, float k, int profile)
{
    return -sceneUnion(-a, b, k, profile);
}

// Points in exactly one of the two.
float sceneXor(float a, float b, float k, int profile)
{
    return sceneSubtraction(sceneUnion(a, b, k, profile), sceneIntersection(a, b, k, profile), k, profile);
}

float sceneUnionShare(float a, float b, float k, int profile)
{
    if (!(k > SDF_NARROWEST_BLEND)) return b < a ? 1.0 : 0.0;
    float width = min(k, SDF_WIDEST_BLEND);
    float farther;  // Weight of the greater distance.
    if (profile == SCENE_EXPONENTIAL) {
        float weight = exp2(max(-abs(a - b) / width, -126.0));
        farther = weight / (1.0 + weight);
    } else {
        float h = max(width - abs(a - b), 0.0) / width;
        farther = 0.5 * h;
        if (profile == SCENE_CUBIC) farther = 0.5 * h * h;
        else if (profile == SCENE_CIRCULAR) farther = 0.5 * (1.0 - (1.0 - h) / sqrt(1.0 + h * (2.0 - h)));
    }
    return b < a ? 1.0 - farther : farther;
}

float sceneIntersectionShare(float a, float b, float k, int profile)
{
    return sceneUnionShare(-a, -b, k, profile);
}

float sceneSubtractionShare(float a, float b, float k, int profile)
{
    return sceneUnionShare(-a, b, k, profile);
}

float sceneXorShare(float a, float b, float k, int profile)
{
    float either = sceneUnion(a, b, k, profile);
    float both = sceneIntersection(a, b, k, profile);
    float share = sceneSubtractionShare(either, both, k, profile);
    return lerpExact(sceneUnionShare(a, b, k, profile), sceneIntersectionShare(a, b, k, profile), share);
}

float sceneMixShare(float t)
{
    return clamp(t, 0.0, 1.0);
}

// ---- Places --------------------------------------------------------------------------------------

// Transforms a point to a space with these unit axes.
vec3 sceneTurned(vec3 p, vec3 x, vec3 y, vec3 z)
{
    return vec3(dot(p, x), dot(p, y), dot(p, z));
}

// Mirrors: the half with positive coordinates is kept. Axes with 0 are not mirrored.
vec3 sceneMirror(vec3 p, vec3 axes)
{
    return vec3(axes.x > 0.5 ? abs(p.x) : p.x, axes.y > 0.5 ? abs(p.y) : p.y, axes.z > 0.5 ? abs(p.z) : p.z);
}

// Extrudes the child's cross section at z = 0.
vec3 sceneFlat(vec3 p)
{
    return vec3(p.x, p.y, 0.0);
}

// Revolves the profile around the y axis, moved out by `offset`.
vec3 sceneRevolve(vec3 p, float offset)
{
    return vec3(length(vec2(p.x, p.z)) - offset, p.y, 0.0);
}

vec3 sceneTurnY(vec3 p, float angle)
{
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}

// Rotates around the y axis by `rate` radians per meter of height.
vec3 sceneTwist(vec3 p, float rate)
{
    return sceneTurnY(p, rate * p.y);
}

// Rotates around the z axis by `rate` radians per meter of x.
vec3 sceneBend(vec3 p, float rate)
{
    float c = cos(rate * p.x);
    float s = sin(rate * p.x);
    return vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

// Safe distance in a twisted or bent space. The field grows by at most 1 + rate * radius per meter at `radius` from the
// axis. Returns the largest s within which it cannot pass zero: s (1 + rate (radius + s)) = d. The result is
// 1-Lipschitz: its differential is at most (1 + rate radius + rate s) / (1 + rate radius + 2 rate s).
float sceneSheared(float d, float radius, float rate)
{
    float slope = 1.0 + abs(rate) * radius;
    float s = 2.0 * abs(d) / (slope + sqrt(slope * slope + 4.0 * abs(rate) * abs(d)));
    return d < 0.0 ? -s : s;
}

float sceneTwisted(float d, vec3 p, float rate)
{
    return sceneSheared(d, length(vec2(p.x, p.z)), rate);
}

float sceneBent(float d, vec3 p, float rate)
{
    return sceneSheared(d, length(vec2(p.x, p.y)), rate);
}

// ---- Repetition ----------------------------------------------------------------------------------
// The nearest copy is found by evaluating as many copies as the content is wide, from the first one that may be
// nearest.

// Coordinate in copy `i` along one axis. Copies are `spacing` apart: `count` of them around the origin, or infinitely
// many for 0. A spacing of 0 means a single copy. Of the `asked` copies to evaluate, copy 0 is the one whose content,
// which ends at `high`, is nearest.
float sceneCell(float x, float i, float spacing, float count, float high, float asked)
{
    if (!(spacing > 0.0)) return x;
    float shifted = count > 0.5 ? x + 0.5 * (count - 1.0) * spacing : x;
    float first = floor((shifted - high) / spacing + 0.5);
    if (count > 0.5) first = clamp(first, 0.0, max(count - asked, 0.0));
    return shifted - (first + i) * spacing;
}

vec3 sceneRepeated(vec3 p, int i, vec3 spacing, vec3 count, vec3 high, vec3 asked)
{
    // Divides floats: software renderers divide integers one pixel at a time.
    float copy = float(i);
    float row = floor((copy + 0.5) / asked.x);
    float layer = floor((row + 0.5) / asked.y);
    return vec3(sceneCell(p.x, copy - row * asked.x, spacing.x, count.x, high.x, asked.x),
                sceneCell(p.y, row - layer * asked.y, spacing.y, count.y, high.y, asked.y),
                sceneCell(p.z, layer, spacing.z, count.z, high.z, asked.z));
}

// Rotates to copy `i` of `count` around the y axis, the first towards +x; the content ends at the angle `high`.
vec3 sceneRepeatedAround(vec3 p, int i, float count, float high)
{
    float sector = 2.0 * PI / count;
    float cell = floor((angleOf(p.z, p.x) - high) / sector + 0.5) + float(i);
    return sceneTurnY(p, cell * sector);
}

// Limits the distance of a copy whose content lies in a box: at least the distance to the box, and at most `cap`, so
// that copies beyond it need no evaluation. A cap of 0 changes nothing.
float sceneCapped(float d, vec3 p, float cap, vec3 center, vec3 halfSize)
{
    if (!(cap > 0.0)) return d;
    return min(max(d, sdfBox(p - center, halfSize)), cap);
}

// Removes the cap far from all copies, which lie in a box.
float sceneBeyond(float d, vec3 p, float cap, vec3 center, vec3 halfSize)
{
    return cap > 0.0 ? max(d, sdfBox(p - center, halfSize)) : d;
}

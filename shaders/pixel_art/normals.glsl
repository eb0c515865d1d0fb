// Normals from a depth buffer. GLSL and C++ (exhibits/pixel_art/normals_cpu.h). The including file first defines `float
// depthAt(ivec2)`, which returns the stored depth of a texel inside the picture.
//
// Methods by the number of texels that they read. 3 and 4 are differences to fixed neighbors. 5 takes the nearer
// neighbor of each axis (Turanszki 2019, "Improved normal reconstruction from depth"). 9 takes the neighbor on whose
// line the texel lies (Wu 2021, "Accurate Normal Reconstruction from Depth Buffer"), in stored depth, which is affine
// on every plane. 9+ chooses before it unprojects. If a neighbor is outside the picture, the other side is used.

struct DepthLens {
    vec2 halfExtent;    // half size of the picture: meters, or tangents in perspective
    float nearPlane;    // meters
    float farPlane;
    bool orthographic;
    bool standardDepth; // near 0, far 1; else near 1, far 0
    ivec2 size;         // texels
    float quantum;      // step of stored depth; 0: floats
};

// Larger than any error between two texels.
const float DEPTH_UNKNOWN = 8.0;
// Upper bound on a line's error in reversed depth that rounding to 32-bit floats causes.
const float DEPTH_NOISE = 6e-7;

bool isSky(DepthLens lens, float depth)
{
    return lens.standardDepth ? depth >= 1.0 : depth <= 0.0;
}

float viewDistance(DepthLens lens, float depth)
{
    float d = lens.standardDepth ? 1.0 - depth : depth;
    float span = lens.farPlane - lens.nearPlane;
    return lens.orthographic ? lens.farPlane - d * span : lens.nearPlane * lens.farPlane / (lens.nearPlane + d * span);
}

// View-space position, meters. A texel's center has coordinates ending in one half.
vec3 viewPosition(DepthLens lens, vec2 texel, float depth)
{
    float z = viewDistance(lens, depth);
    vec2 at = (texel / vec2(lens.size) * 2.0 - vec2(1.0)) * lens.halfExtent;
    float wide = lens.orthographic ? 1.0 : z;
    return vec3(at.x * wide, at.y * wide, -z);
}

vec3 positionAt(DepthLens lens, ivec2 p, float depth)
{
    return viewPosition(lens, vec2(p) + vec2(0.5), depth);
}

// Width of a texel at this depth, meters.
float texelWidth(DepthLens lens, float depth)
{
    float wide = lens.orthographic ? 1.0 : viewDistance(lens, depth);
    return 2.0 * lens.halfExtent.y * wide / float(lens.size.y);
}

bool isInside(DepthLens lens, ivec2 p)
{
    return p.x >= 0 && p.y >= 0 && p.x < lens.size.x && p.y < lens.size.y;
}

vec3 unitOrFacing(vec3 n)
{
    float square = dot(n, n);
    return square > 1e-30 && square < 1e30 ? n * (1.0 / sqrt(square)) : vec3(0.0, 0.0, 1.0);
}

// Vector of a step along one axis to the side `side`, -1 or 1.
vec3 stepTo(DepthLens lens, ivec2 p, ivec2 axis, int side, float depth, vec3 center)
{
    vec3 there = positionAt(lens, p + axis * side, depth);
    return float(side) * (there - center);
}

float depthOr(DepthLens lens, ivec2 p, float otherwise)
{
    return isInside(lens, p) ? depthAt(p) : otherwise;
}

vec3 normal3Tap(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    vec3 center = positionAt(lens, p, c);
    int right = p.x + 1 < lens.size.x ? 1 : -1;
    int up = p.y + 1 < lens.size.y ? 1 : -1;
    vec3 h = stepTo(lens, p, ivec2(1, 0), right, depthOr(lens, p + ivec2(right, 0), c), center);
    vec3 v = stepTo(lens, p, ivec2(0, 1), up, depthOr(lens, p + ivec2(0, up), c), center);
    return unitOrFacing(cross(h, v));
}

// Vector between both neighbors on an axis; at the border, the texel itself replaces the missing one.
vec3 across(DepthLens lens, ivec2 p, ivec2 axis, float c)
{
    ivec2 low = isInside(lens, p - axis) ? p - axis : p;
    ivec2 high = isInside(lens, p + axis) ? p + axis : p;
    if (low == high) high = p + axis;
    return positionAt(lens, high, depthOr(lens, high, c)) - positionAt(lens, low, depthOr(lens, low, c));
}

vec3 normal4Tap(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    return unitOrFacing(cross(across(lens, p, ivec2(1, 0), c), across(lens, p, ivec2(0, 1), c)));
}

vec3 nearerStep(DepthLens lens, ivec2 p, ivec2 axis, float c, vec3 center)
{
    vec3 low = stepTo(lens, p, axis, -1, depthOr(lens, p - axis, c), center);
    vec3 high = stepTo(lens, p, axis, 1, depthOr(lens, p + axis, c), center);
    if (!isInside(lens, p - axis)) return high;
    if (!isInside(lens, p + axis)) return low;
    return abs(low.z) < abs(high.z) ? low : high;
}

vec3 normal5Tap(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    vec3 center = positionAt(lens, p, c);
    return unitOrFacing(
        cross(nearerStep(lens, p, ivec2(1, 0), c, center), nearerStep(lens, p, ivec2(0, 1), c, center)));
}

// Distance by which the line through two texels of one side misses the middle texel.
float lineError(DepthLens lens, ivec2 p, ivec2 stride, float c)
{
    ivec2 first = p + stride;
    ivec2 second = first + stride;
    if (!isInside(lens, first)) return 2.0 * DEPTH_UNKNOWN;
    if (!isInside(lens, second)) return DEPTH_UNKNOWN;
    return abs(2.0 * depthAt(first) - depthAt(second) - c);
}

// Margin by which one side must be better. Smaller differences are ignored, so that the choice on a plane is stable
// when the camera moves by whole texels and depths differ by rounding.
float certainty(DepthLens lens, float c)
{
    return DEPTH_NOISE * (lens.standardDepth ? 1.0 - c : c);
}

int lineSide(DepthLens lens, ivec2 p, ivec2 axis, float c)
{
    return lineError(lens, p, ivec2(0) - axis, c) + certainty(lens, c) < lineError(lens, p, axis, c) ? -1 : 1;
}

// Original form: computes both steps of each axis, then chooses one.
vec3 normal9Tap(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    vec3 center = positionAt(lens, p, c);
    vec3 left = stepTo(lens, p, ivec2(1, 0), -1, depthOr(lens, p - ivec2(1, 0), c), center);
    vec3 right = stepTo(lens, p, ivec2(1, 0), 1, depthOr(lens, p + ivec2(1, 0), c), center);
    vec3 down = stepTo(lens, p, ivec2(0, 1), -1, depthOr(lens, p - ivec2(0, 1), c), center);
    vec3 up = stepTo(lens, p, ivec2(0, 1), 1, depthOr(lens, p + ivec2(0, 1), c), center);
    vec3 h = lineSide(lens, p, ivec2(1, 0), c) < 0 ? left : right;
    vec3 v = lineSide(lens, p, ivec2(0, 1), c) < 0 ? down : up;
    return unitOrFacing(cross(h, v));
}

struct Side {
    int way;     // -1 or 1
    float first; // stored depth of the next texel on that side, ...
    float second; // ... and of the one after it; extrapolated by the line through middle and first if that is outside
    float error; // see `lineError`
    // stored depth of the texel on the other side; extrapolated by the parabola through these three if that is outside
    float other;
};

Side sideAt(DepthLens lens, ivec2 p, ivec2 axis, int way, float c)
{
    Side side;
    // Only the axis's own coordinate can leave the picture. Texels beyond the border are replaced by the texel itself.
    int before = p.x * axis.x + p.y * axis.y;
    int room = way < 0 ? before : (lens.size.x - 1) * axis.x + (lens.size.y - 1) * axis.y - before;
    bool one = room >= 1;
    bool two = room >= 2;
    side.way = way;
    side.first = depthAt(p + axis * (one ? way : 0));
    float beyond = depthAt(p + axis * (two ? 2 * way : 0));
    side.second = two ? beyond : 2.0 * side.first - c;
    side.error = two ? abs(2.0 * side.first - beyond - c) : one ? DEPTH_UNKNOWN : 2.0 * DEPTH_UNKNOWN;
    side.other = 3.0 * (c - side.first) + side.second;
    return side;
}

// Sets the depth on the other side, if there is such a texel.
Side withOther(Side side, Side other)
{
    if (other.error < 1.5 * DEPTH_UNKNOWN) side.other = other.first;
    return side;
}

Side betterSide(Side low, Side high, float certain)
{
    if (low.error + certain < high.error) return low;
    return high;
}

Side chosenSide(DepthLens lens, ivec2 p, ivec2 axis, float c)
{
    Side low = sideAt(lens, p, axis, -1, c);
    Side high = sideAt(lens, p, axis, 1, c);
    return betterSide(withOther(low, high), withOther(high, low), certainty(lens, c));
}

vec3 normal9TapPlus(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    Side h = chosenSide(lens, p, ivec2(1, 0), c);
    Side v = chosenSide(lens, p, ivec2(0, 1), c);
    vec3 center = positionAt(lens, p, c);
    return unitOrFacing(cross(stepTo(lens, p, ivec2(1, 0), h.way, h.first, center),
                              stepTo(lens, p, ivec2(0, 1), v.way, v.first, center)));
}

// Change of stored depth per texel towards that side at the middle, from the parabola through three texels. Its
// curvature is limited to the curvature around the middle, and is 0 if the signs differ, because an edge may lie
// between the two texels (the minmod of both: Roe 1986, "Characteristic-based schemes for the Euler equations"). A
// large correction relative to the difference indicates an edge two texels away. So it decreases above a ratio of 0.3,
// and is 0 from 0.6 on. On planes it is 0, because curvature within rounding is ignored.
float slopeAt(DepthLens lens, Side side, float c)
{
    float first = side.first - c;
    float bend = 0.5 * (c - 2.0 * side.first + side.second);
    float around = 0.5 * (side.first - 2.0 * c + side.other);
    float least = bend * around > 0.0 ? min(abs(bend), abs(around)) : 0.0;
    float certain = max(least - 1.01 * lens.quantum - 0.5 * certainty(lens, c), 0.0);
    float most = min(certain, max(0.6 * abs(first) - certain, 0.0));
    return first - (bend < 0.0 ? -most : most);
}

vec3 normalOfSides(DepthLens lens, ivec2 p, float c, Side h, Side v)
{
    vec3 center = positionAt(lens, p, c);
    return unitOrFacing(cross(stepTo(lens, p, ivec2(1, 0), h.way, c + slopeAt(lens, h, c), center),
                              stepTo(lens, p, ivec2(0, 1), v.way, c + slopeAt(lens, v, c), center)));
}

// Method 9+ with the slope of a parabola instead of a line.
vec3 normalCurved(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    return normalOfSides(lens, p, c, chosenSide(lens, p, ivec2(1, 0), c), chosenSide(lens, p, ivec2(0, 1), c));
}

// Number of the eight surrounding texels that lie on the plane of these two sides, within 0.3 % of their distance.
// `around` contains their distances, row by row, negative if there is none.
int planeVotes(DepthLens lens, float around[9], float c, Side h, Side v)
{
    int votes = 0;
    for (int i = 0; i < 9; ++i) {
        float there = around[i];
        float x = float((i % 3 - 1) * h.way);
        float y = float((i / 3 - 1) * v.way);
        float guess = c + x * (h.first - c) + y * (v.first - c);
        bool fits = there > 0.0 && abs(viewDistance(lens, guess) - there) < 0.003 * there;
        votes += fits ? 1 : 0;
    }
    return votes;
}

// Returns whether a line of three texels passes through the middle one, within 0.3 % of its distance.
bool isOnLine(DepthLens lens, Side side, float c)
{
    float there = viewDistance(lens, c);
    return side.error < DEPTH_UNKNOWN &&
           abs(viewDistance(lens, 2.0 * side.first - side.second) - there) < 0.003 * abs(there);
}

// If a texel lies on no line of three, as on bars of one and two texels, the sides of both axes are chosen together by
// a vote of the surrounding texels. Ties go to the smaller line error.
vec3 normalVoted(DepthLens lens, ivec2 p)
{
    float c = depthAt(p);
    Side left = sideAt(lens, p, ivec2(1, 0), -1, c);
    Side right = sideAt(lens, p, ivec2(1, 0), 1, c);
    Side down = sideAt(lens, p, ivec2(0, 1), -1, c);
    Side up = sideAt(lens, p, ivec2(0, 1), 1, c);
    float certain = certainty(lens, c);
    Side bestH = betterSide(withOther(left, right), withOther(right, left), certain);
    Side bestV = betterSide(withOther(down, up), withOther(up, down), certain);
    if (isOnLine(lens, bestH, c) && isOnLine(lens, bestV, c)) return normalOfSides(lens, p, c, bestH, bestV);
    float around[9];
    for (int i = 0; i < 9; ++i) {
        ivec2 q = p + ivec2(i % 3 - 1, i / 3 - 1);
        around[i] = i != 4 && isInside(lens, q) ? viewDistance(lens, depthAt(q)) : -1.0;
    }
    int most = planeVotes(lens, around, c, bestH, bestV);
    for (int i = 0; i < 4; ++i) {
        Side h = right;
        Side v = up;
        if (i % 2 == 0) h = left;
        if (i / 2 == 0) v = down;
        if (h.error > DEPTH_UNKNOWN || v.error > DEPTH_UNKNOWN) continue;
        int votes = planeVotes(lens, around, c, h, v);
        if (votes > most) {
            most = votes;
            bestH = h;
            bestV = v;
        }
    }
    // Without a continuing line of three texels, the second texel is extrapolated linearly, so that it does not change
    // the slope.
    if (!isOnLine(lens, bestH, c)) bestH.second = 2.0 * bestH.first - c;
    if (!isOnLine(lens, bestV, c)) bestV.second = 2.0 * bestV.first - c;
    return normalOfSides(lens, p, c, bestH, bestV);
}

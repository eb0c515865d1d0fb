// One lantern: position, parts and brightness. GLSL 4.50 and C++ (exhibits/paper_lanterns/paper_lanterns_cpu.h). The
// including file provides paper.glsl, `lake` (a LakeBlock), `evaluations` (a counter) and `float blueNoiseAt(ivec2
// texel)`.

struct Lantern {
    vec3 place;   // center of its base
    vec2 tilt;    // slope of its base along x and z
    float turn;   // rotation around its axis, radians
    float light;  // flame's light relative to the candle's; below 0: no lantern
    float hue;    // 0 to 1, selects the color of its paper
    vec3 glow;    // mean radiance of paper and frame, seen from outside
};

// Flicker of a flame: three cosines with offsets. 0.198 to 0.85 in all, with a period of 4 s.
float flickerSum(float seconds)
{
    return 0.15 * (cos(2.0 * PI * seconds) + 2.0) + 0.1 * (cos(3.0 * PI * seconds) + 1.0) +
           0.1 * (cos(2.5 * PI * seconds) + 1.0);
}

// Brightness of a flame with this phase (share of the period): 0.399 to 0.725 at full depth.
float flickerOf(float phase)
{
    float mean = 0.55;
    return mix(mean, 0.3 + 0.5 * flickerSum(lake.flickerTime + 4.0 * phase * lake.flickerApart), lake.flickerDepth);
}

// Absorption times thickness of a lantern's paper: most are equal, some dyed red, rose, gold or amber.
vec3 paperAbsorbOf(float hue)
{
    vec3 dye = vec3(0.0);
    if (hue > 0.5) dye = vec3(0.02, 1.3, 1.5);
    if (hue > 0.7) dye = vec3(0.02, 0.75, 0.3);
    if (hue > 0.83) dye = vec3(0.0, 0.12, 1.6);
    if (hue > 0.93) dye = vec3(0.15, 0.55, 1.9);
    return lake.paperAbsorb + dye * (lake.variety * lake.paperScatter);
}

// Irradiance of a flame of intensity 1 on the inside of the paper at a height; its mean over all heights is below.
float wallDirect(float y)
{
    float r = lake.paperRadius;
    float up = y - lake.flameHeight;
    float squared = r * r + up * up;
    return r / (squared * sqrt(squared));
}

float wallDirectMean()
{
    float r = lake.paperRadius;
    float above = lake.paperHeight - lake.flameHeight;
    float below = lake.flameHeight;
    return (above / sqrt(r * r + above * above) + below / sqrt(r * r + below * below)) / (r * lake.paperHeight);
}

// The same for light reflected between walls and base, for paper of this reflectance.
float wallIndirect(float reflected)
{
    float r = lake.paperRadius;
    float h = lake.paperHeight;
    // Share of the flame's light that does not leave through the opening.
    float above = h - lake.flameHeight;
    float kept = 0.5 + 0.5 * above / sqrt(r * r + above * above);
    return 4.0 * kept / (2.0 * r * h + r * r) * (tubeGain(reflected, r, h) - 1.0);
}

// Mean radiance of the paper's outside by light that is scattered forwards: the flame's intensity over the area of the
// tube. Some of the lobe passes above and below. The factor is that for usual shapes, within 0.04.
float forwardMean()
{
    return 0.88 / (2.0 * lake.paperRadius * lake.paperHeight);
}

// Share of the paper that its frame does not hide: two posts in front of it, the lower ring and half of the upper one.
float paperSeen()
{
    float posts = 2.0 * lake.postRadius / lake.paperRadius;
    float rings = 3.0 * lake.ringRadius / lake.paperHeight;
    return clamp((1.0 - posts) * (1.0 - rings), 0.1, 1.0);
}

// Mean radiance of a lantern, frame included, for a flame of this strength.
vec3 paperGlow(float strength, float hue)
{
    vec3 absorb = paperAbsorbOf(hue);
    vec3 glow = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        Sheet sheet = sheetOf(lake.paperScatter, absorb[i]);
        float diffuse = (wallDirectMean() + wallIndirect(sheet.reflected)) / PI;
        glow[i] = sheet.transmitted * mix(diffuse, forwardMean(), lake.paperForward);
    }
    return lake.candle * glow * (paperSeen() * max(strength, 0.0));
}

// Radiance of the paper's outside at a height and a distance from the middle, seen from far away, relative to its mean.
float paperProfile(float aside, float y)
{
    float r = lake.paperRadius;
    float up = y - lake.flameHeight;
    float squared = r * r + up * up;
    float cosine = sqrt(max(r * r - aside * aside, 0.0) / squared);
    float here = mix((wallDirect(y) + wallIndirect(0.5)) / PI, forwardLobe(cosine) / squared, lake.paperForward);
    return here / mix((wallDirectMean() + wallIndirect(0.5)) / PI, forwardMean(), lake.paperForward);
}

// Offset of a cell's lantern from the center of the cell; `id` is the cell's number.
vec2 offMiddle(ivec2 id)
{
    return (vec2(blueNoiseAt(id), blueNoiseAt(id + ivec2(29, 17))) * 2.0 - 1.0) * lake.jitter;
}

// Computes the lantern of a cell of the lattice; `float.comp` stores the result for all cells.
Lantern lanternOfCell(ivec2 cell)
{
    ivec2 id = cell + lake.firstCell;
    uvec3 bits = hashCell(ivec3(id.x, 0, id.y), lake.seed);
    uvec3 more = pcg3d(bits);
    vec2 middle = vec2(float(cell.x) + 0.5, -float(cell.y) - 0.5) * lake.cell + lake.corner + offMiddle(id);
    LakePoint ride = rideAt(middle);
    Lantern l;
    l.place = vec3(middle.x, ride.height, middle.y);
    l.tilt = ride.slope;
    l.turn = 2.0 * PI * lake.turn * unitFromBits(bits.y);
    l.hue = unitFromBits(bits.z);
    bool here = unitFromBits(bits.x) < lake.fill && !(id.x == lake.freedCell.x && id.y == lake.freedCell.y);
    l.light = here ? flickerOf(unitFromBits(more.x)) : -1.0;
    l.glow = paperGlow(l.light, l.hue);
    return l;
}

// Rotation from the lantern's own space to the lake's: x and z along the sides of its base, y up its axis.
mat3 lakeFromLantern(Lantern l)
{
    vec3 up = normalize(vec3(-l.tilt.x, 1.0, -l.tilt.y));
    vec3 side = vec3(cos(l.turn), 0.0, sin(l.turn));
    vec3 x = normalize(side - up * dot(side, up));
    return mat3(x, up, cross(x, up));
}

struct LanternPoint {
    float distance;
    int part;  // PART_ number of the nearest part
};

// Signed distance in the lantern's own space, with the center of the base at the origin. Keeps 1.
LanternPoint lanternField(vec3 p)
{
    evaluations += 1;
    float r = length(vec2(p.x, p.z));
    float top = lake.paperHeight;
    float wall = sdfRectangle(vec2(r - lake.paperRadius, p.y - 0.5 * top), vec2(lake.paperHalf, 0.5 * top));
    float wood = sdfBox(p, vec3(lake.baseHalfWidth, lake.baseHalfHeight, lake.baseHalfWidth));
    // Only the nearer one of the two rings, and the post of this quarter, matter.
    float ringHeight = p.y < 0.5 * (top + lake.lowRing) ? lake.lowRing : top;
    float rings = length(vec2(r - lake.paperRadius, p.y - ringHeight)) - lake.ringRadius;
    vec2 post = abs(vec2(p.x, p.z)) - vec2(0.707 * lake.paperRadius);
    float posts = sdfExtrude(length(post) - lake.postRadius, p.y - 0.5 * top, 0.5 * top + 0.03);
    float metal = sdfSmoothUnion(posts, rings, lake.blend);
    LanternPoint found;
    found.distance = min(wall, min(wood, metal));
    found.part = found.distance == wall ? PART_PAPER : (found.distance == wood ? PART_WOOD : PART_METAL);
    return found;
}

// Interval of a ray in a slab: first and last distance; none if first > last. `d` may be 0.
vec2 slabSpan(float o, float d, float low, float high)
{
    if (abs(d) < 1.0e-12) return o >= low && o <= high ? vec2(-1.0e9, 1.0e9) : vec2(1.0, -1.0);
    float a = (low - o) / d;
    float b = (high - o) / d;
    return vec2(min(a, b), max(a, b));
}

vec2 cylinderSpan(vec3 o, vec3 d, float radius, float low, float high)
{
    vec2 y = slabSpan(o.y, d.y, low, high);
    float a = d.x * d.x + d.z * d.z;
    float b = o.x * d.x + o.z * d.z;
    float c = o.x * o.x + o.z * o.z - radius * radius;
    if (a < 1.0e-12) return c <= 0.0 ? y : vec2(1.0, -1.0);
    float root = b * b - a * c;
    if (root < 0.0) return vec2(1.0, -1.0);
    float s = sqrt(root);
    return vec2(max(y.x, (-b - s) / a), min(y.y, (-b + s) / a));
}

vec2 boxSpan(vec3 o, vec3 d, vec3 halfSize)
{
    vec2 x = slabSpan(o.x, d.x, -halfSize.x, halfSize.x);
    vec2 y = slabSpan(o.y, d.y, -halfSize.y, halfSize.y);
    vec2 z = slabSpan(o.z, d.z, -halfSize.z, halfSize.z);
    return vec2(max(x.x, max(y.x, z.x)), min(x.y, min(y.y, z.y)));
}

// Interval of a ray in the lantern's space in which it may be close to it: around the paper with its frame, and around
// the base. Extended by `margin`, the hit tolerance.
vec2 lanternSpan(vec3 o, vec3 d, float margin)
{
    float wires = max(lake.ringRadius, max(lake.postRadius, lake.paperHalf));
    float around = lake.paperRadius + wires + 0.25 * lake.blend + margin;
    float top = lake.paperHeight + max(lake.ringRadius, 0.03) + 0.25 * lake.blend + margin;
    vec2 tube = cylinderSpan(o, d, around, -lake.baseHalfHeight - margin, top);
    vec3 base = vec3(lake.baseHalfWidth, lake.baseHalfHeight, lake.baseHalfWidth) + vec3(margin);
    vec2 plate = boxSpan(o, d, base);
    if (tube.x > tube.y) return plate;
    if (plate.x > plate.y) return tube;
    return vec2(min(tube.x, plate.x), max(tube.y, plate.y));
}

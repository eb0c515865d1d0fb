// Color of a print seen through its sheet of lenses. The piece of a lens under a pixel is divided into parts. The edges
// of each part are traced to the print, and the print between the two hits is weighted by the visible area of the part.
// So a lens is integrated, not sampled. If lenses are smaller than a pixel, a whole lens is integrated, so that no
// moire pattern with the pixels is left.
//
// Permutations: SCROLLING (both prints are bound), FIRST_RASTER, SECOND_RASTER, DISPERSION, SQUEEZED.

#ifdef FIRST_RASTER
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D firstPicture;
#else
layout(binding = UNIT_EXHIBIT_A) uniform sampler2DArray firstPicture;
#endif
#ifdef SCROLLING
#ifdef SECOND_RASTER
layout(binding = UNIT_EXHIBIT_B) uniform sampler2D secondPicture;
#else
layout(binding = UNIT_EXHIBIT_B) uniform sampler2DArray secondPicture;
#endif
#endif

const int MOST_PARTS = 64;
const int MOST_STRIPS = 64;    // Wider spots skip strips uniformly.
const vec3 PAPER = vec3(0.86, 0.855, 0.84);

int traces = 0;  // Rays traced for this pixel.

// Position of a pixel on a print, and its width there.
struct Spot {
    vec2 place;       // on the print, which scrolling moves under the lenses
    float slide;      // how far scrolling moved it across the lenses, in pitches
    float lenses;     // across the lenses, in pitches from the center of the card
    float width;      // width of the pixel across the lenses, in pitches
    float length_;    // length of the pixel along the lenses, meters
    float blur;       // variation of the print's phase within the pixel, in pitches
    vec2 eyePlane;    // sine and cosine of the eye's angle across the lenses
    float along;      // sine of the eye's angle along the lenses
};

LensShape lensShape(CardPrintBlock print, float index, float along)
{
    LensShape s;
    s.pitch = 1.0;
    s.radius = print.radius;
    s.thickness = print.thickness;
    s.conic = print.conic;
    s.index = lensIndexAskew(index, along);
    return s;
}

// Position of the spot's center on the print, by the model that the parameters choose.
float spotMiddle(LensShape s, vec2 plane)
{
    float tangent = plane.x / plane.y;
    if (parameters.model == model_linear) return -0.5 * tangent / tan(parameters.intendedMaxAngle);
    if (parameters.model == model_paraxial) return -s.thickness / s.index * atan(tangent);
    return lensChiefRay(s, tangent);
}

// Derivative of the spot's position by the tangent of the eye's angle.
float spotRate(LensShape s, vec2 plane)
{
    if (parameters.model == model_linear) return 0.5 / tan(parameters.intendedMaxAngle);
    if (parameters.model == model_paraxial) return s.thickness / s.index * plane.y * plane.y;
    return s.thickness - s.radius;
}

// Position and weight of the ray through x on the lens. The magnification scales the spot around its center.
vec2 landing(LensShape s, float x, vec2 plane, float middle, float views)
{
    ++traces;
    if (parameters.model == model_linear) return vec2(middle - parameters.magnification * x / views, 1.0);
    if (parameters.model == model_paraxial) return vec2(middle + parameters.magnification * x * (1.0 - s.thickness * (s.index - 1.0) / (s.index * s.radius)), 1.0);
    LensRay ray = lensTrace(s, x, plane.x, plane.y);
    return vec2(middle + parameters.magnification * (ray.x - middle), ray.weight);
}

vec3 pictureTexel(int slot, vec3 uvLayer, float level)
{
#if defined(SCROLLING) && !defined(SECOND_RASTER)
    if (slot == 1) return textureLod(secondPicture, uvLayer, level).rgb;
#endif
#ifndef FIRST_RASTER
    if (slot == 0) return textureLod(firstPicture, uvLayer, level).rgb;
#endif
    return vec3(0.0);
}

vec3 rasterTexel(int slot, ivec2 at)
{
#if defined(SCROLLING) && defined(SECOND_RASTER)
    if (slot == 1) return texelFetch(secondPicture, at, 0).rgb;
#endif
#ifdef FIRST_RASTER
    if (slot == 0) return texelFetch(firstPicture, at, 0).rgb;
#endif
    return vec3(0.0);
}

bool isRaster(int slot)
{
#ifdef FIRST_RASTER
    if (slot == 0) return true;
#endif
#ifdef SECOND_RASTER
    if (slot == 1) return true;
#endif
    return false;
}

// Color of view `k` in lens `lens`. `inStrip`: position in the strip, 0 to 1, for squeezed strips.
vec3 viewColor(int slot, CardPrintBlock print, Spot spot, float lens, float k, float inStrip)
{
#ifdef SQUEEZED
    lens += 0.5 - inStrip;
#endif
    // Along the lens, refraction in the sheet displaces the ray.
    float down = dot(spot.place, object.along) - print.pitch * print.thickness * spot.along / print.index.g;
    vec2 uv = object.along * (down / (2.0 * print.halfSize)) + object.across * ((lens - print.phase) * print.texturePerLens);
    vec2 texels = abs(object.across) * (spot.width * print.texturePerLens) + abs(object.along) * (spot.length_ / (2.0 * print.halfSize));
    float level = log2(max(max(texels.x * print.size.x, texels.y * print.size.y), 1.0));
    return pictureTexel(slot, vec3(0.5 + uv.x, 0.5 - uv.y, k), level);
}

// Color of the raster's pixel `column`, counted across the lenses. Along them its rows are averaged over the screen
// pixel, by mip levels.
vec3 rasterColor(int slot, CardPrintBlock print, Spot spot, float column)
{
    bool upright = object.across.x > 0.5;
    // The mip levels halve the rows along the lenses: the texture is rotated for horizontal lenses.
    float down = dot(spot.place, object.along) - print.pitch * print.thickness * spot.along / print.index.g;
    float extent = upright ? print.halfSize.y : print.halfSize.x;
    float share = 0.5 - 0.5 * down / extent;
    float rows = print.size.y;
    float level = clamp(floor(log2(max(spot.length_ / (2.0 * extent) * rows, 1.0))), 0.0, 12.0);
    float first = 0.0;
    for (int l = 0; l < int(level); ++l) {
        first += rows;
        rows = ceil(0.5 * rows);
    }
    float y = clamp(share * rows - 0.5, 0.0, rows - 1.0);
    float y0 = floor(y);
    int x = int(clamp(column, 0.0, print.size.x - 1.0));
    vec3 a = rasterTexel(slot, ivec2(x, int(first + y0)));
    vec3 b = rasterTexel(slot, ivec2(x, int(first + min(y0 + 1.0, rows - 1.0))));
    return mix(a, b, y - y0);
}

// Sum of color times weight, and the weight, of the piece [from, to] of lens `lens`. Channel 3 means all three.
vec4 lensPiece(int slot, CardPrintBlock print, Spot spot, float lens, float from, float to, int parts, int channel)
{
    LensShape s = lensShape(print, channel == 0 ? print.index.r : channel == 2 ? print.index.b : print.index.g, spot.along);
    float middle = spotMiddle(s, spot.eyePlane);
    vec3 pieces[MOST_PARTS];  // from, to on the print; weight
    int found = 0;
    float low = 1.0e9;
    float high = -1.0e9;
    float total = 0.0;
    vec2 left = landing(s, from, spot.eyePlane, middle, float(print.views));
    for (int i = 0; i < parts; ++i) {
        vec2 at = landing(s, mix(from, to, (float(i) + 0.5) / float(parts)), spot.eyePlane, middle, float(print.views));
        vec2 right = landing(s, mix(from, to, (float(i) + 1.0) / float(parts)), spot.eyePlane, middle, float(print.views));
        if (at.y > 0.0) {
            float a = left.y > 0.0 ? left.x : at.x;
            float b = right.y > 0.0 ? right.x : at.x;
            pieces[found] = vec3(min(a, b), max(a, b), at.y * (to - from) / float(parts));
            low = min(low, pieces[found].x);
            high = max(high, pieces[found].y);
            total += pieces[found].z;
            ++found;
        }
        left = right;
    }
    if (found == 0) return vec4(0.0);

    float cells = isRaster(slot) ? print.texturePerLens : float(print.views);  // strips, or pixels, per lens
    float blur = (print.blur + spot.blur) * cells;
    // In cells, 0 at the left end of the print's lens `lens`.
    float ratio = print.pitchRatio;
    float offset = lens * (ratio - 1.0) + print.phase + print.slope * dot(spot.place, object.along) / print.pitch + spot.slide + 0.5;
    // The pixels of a raster are not aligned with the print's lenses.
    float column = isRaster(slot) ? (lens - 0.5) * cells + 0.5 * print.size.x : 0.0;
    float start = offset * cells + column - floor(column);
    float scale = ratio * cells;
    float first = floor(start + scale * low - 0.5 * blur);
    float last = floor(start + scale * high + 0.5 * blur);
    // Beyond any texture, at grazing angles, where the cells are a blur anyway.
    if (!(abs(first) < 1.0e7) || !(abs(last) < 1.0e7)) return vec4(PAPER * total, total);
    float stride = max(1.0, ceil((last - first + 1.0) / float(MOST_STRIPS)));
    vec3 sum = vec3(0.0);
    for (int n = 0; n < MOST_STRIPS; ++n) {
        float cell = first + stride * float(n);
        if (cell > last) break;
        float share = 0.0;
        for (int i = 0; i < found; ++i) {
            float a = start + scale * pieces[i].x;
            float b = start + scale * pieces[i].y;
            float center = 0.5 * (a + b);
            share += pieces[i].z * (boxesBefore(cell + stride - center, b - a, blur) - boxesBefore(cell - center, b - a, blur));
        }
        if (share <= 1.0e-4 * total) continue;
        float shown = cell + floor(0.5 * stride);
        if (isRaster(slot)) {
            sum += share * rasterColor(slot, print, spot, shown + floor(column));
        } else {
            float away = floor(shown / cells);
            float strip = clamp(shown - away * cells, 0.0, cells - 1.0);
            float inStrip = clamp(0.5 * (max(start + scale * low, shown) + min(start + scale * high, shown + 1.0)) - shown, 0.0, 1.0);
            sum += share * viewColor(slot, print, spot, lens + away, parameters.reverse ? strip : cells - 1.0 - strip, inStrip);
        }
    }
    return vec4(sum, total);
}

// Color of a pixel's window on the lenses, divided at the cusps.
vec3 windowColor(int slot, CardPrintBlock print, Spot spot, int channel)
{
    // A pixel wider than a quarter of a lens gradually covers more of it, from half a lens on the whole. A box of
    // exactly one pitch removes all frequencies of the pitch.
    float wide = spot.width + (1.0 - spot.width) * smoothStep(0.25, 0.5, spot.width);
    int parts = clamp(parameters.apertureSamples, 1, MOST_PARTS);
    int places = 1;
    if (spot.width >= 0.5) wide = 1.0;
    if (!parameters.prefilter) {
        wide = 1.0e-6;
        parts = 1;
    } else if (isRaster(slot)) {
        places = int(clamp(ceil(spot.width), 1.0, 6.0));
    }
    vec4 sum = vec4(0.0);
    for (int place = 0; place < places; ++place) {
        float lenses = spot.lenses + ((float(place) + 0.5) / float(places) - 0.5) * (places > 1 ? spot.width : 0.0);
        float lens = floor(lenses - 0.5 * wide + 0.5);
        float from = lenses - 0.5 * wide - lens;
        float to = from + wide;
        float cusp = min(to, 0.5);
        sum += lensPiece(slot, print, spot, lens, from, cusp, clamp(int(ceil(float(parts) * (cusp - from) / wide)), 1, parts), channel);
        if (to > 0.5) sum += lensPiece(slot, print, spot, lens + 1.0, -0.5, to - 1.0, clamp(int(ceil(float(parts) * (to - 0.5) / wide)), 1, parts), channel);
    }
    // No part of the lens is visible: edge on.
    return sum.a > 0.0 ? sum.rgb / sum.a : PAPER;
}

// Color that an eye at `eye` sees at `place` of the card's front, where the pixel spans `stepX` and `stepY`.
vec3 printedColor(vec2 place, vec3 eye, vec2 stepX, vec2 stepY)
{
    Spot spot;
    spot.place = place;
    int slot = 0;
#ifdef SCROLLING
    spot.place.y -= 2.0 * object.halfSize.y * object.scroll;
    if (spot.place.y < -object.halfSize.y) {
        spot.place.y += 2.0 * object.halfSize.y;
        slot = 1;
    }
#endif
    CardPrintBlock print = object.prints[slot];
    vec2 across = object.across;
    vec2 along = object.along;
    vec3 toEye = normalize(eye - vec3(place, 0.0));
    // Beyond 87 degrees nothing can be distinguished, because Fresnel reflection dominates.
    toEye.z = max(toEye.z, 0.05);
    toEye = normalize(toEye);
    spot.along = dot(toEye.xy, along);
    float inPlane = sqrt(max(1.0 - spot.along * spot.along, 1.0e-6));
    spot.eyePlane = vec2(dot(toEye.xy, across), toEye.z) / inPlane;
    spot.lenses = dot(place, across) / print.pitch;
    spot.slide = dot(spot.place - place, across) / print.pitch;
    spot.width = (abs(dot(stepX, across)) + abs(dot(stepY, across))) / print.pitch;
    spot.length_ = abs(dot(stepX, along)) + abs(dot(stepY, along));
    float rate = spotRate(lensShape(print, print.index.g, spot.along), spot.eyePlane) * print.pitch / max(eye.z, 1.0e-3);
    float perLens = print.pitchRatio * (1.0 + rate) - 1.0;
    spot.blur = parameters.prefilter ? abs(perLens) * spot.width + abs(print.slope) * spot.length_ / print.pitch : 0.0;

    // The picture is surrounded by paper.
    vec2 wide = max(abs(stepX) + abs(stepY), vec2(1.0e-6));
    vec2 inside = clamp((print.halfSize - abs(spot.place)) / wide + 0.5, 0.0, 1.0);
    float covered = inside.x * inside.y;
    if (covered <= 0.0) return PAPER;
#ifdef DISPERSION
    vec3 color = vec3(windowColor(slot, print, spot, 0).r, windowColor(slot, print, spot, 1).g, windowColor(slot, print, spot, 2).b);
#else
    vec3 color = windowColor(slot, print, spot, 3);
#endif
    return mix(PAPER, color * 0.93, covered);
}

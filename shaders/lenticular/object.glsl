// The card and its two prints: mirrored by CardObject and CardPrintBlock in exhibits/lenticular/card_object.h.
//
// The card's own space: metres, the middle of its front at the origin, x to the right, y up, z towards the viewer.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/lens.glsl"

struct Print {
    vec4 area;    // xy: half the picture's size, metres; z: views; w: length of one lens pitch, metres
    vec4 shape;   // of the lens, in pitches: x: radius, y: thickness, z: conic; w: width of the ink's blur
    vec4 index;   // rgb: refractive index of each
    vec4 strips;  // x: lens pitch over strips' pitch, y: phase in lenses, z: slope of the print against the sheet,
                  // w: pictures: one lens as a part of the texture; rasters: pixels per lens pitch
    vec4 size;    // xy: of the picture in texels; rasters: rows of the whole raster, without its halvings
};

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    mat4 worldFromCard;
    mat4 cardFromWorld;
    vec4 eyes[2];   // left and right, or both the camera
    vec4 card;      // xyz: half its size; w: the scroll, 0 at rest to 1
    vec4 axes;      // xy: across the lenses, zw: along them; unit vectors of the card's front
    Print prints[2];
} object;

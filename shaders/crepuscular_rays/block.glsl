// What the passes of the sunbeams share: mirrored by RaysBlock in exhibits/crepuscular_rays/rays_scene.h.
#include "lib/bindings.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    vec4 source;      // xy: the sun in pixels of the mask; z: exponent of the weight; w: share of the way that is gathered
    vec4 strength;    // rgb: what a white mean adds to the radiance; w: 1 over the exposure of the picture
    vec4 taps;        // x: samples or taps of this pass; y: ratio of neighbors; z: 1 for the first pass, else 0; w: way left out
    vec4 polar;       // x: first angle; y: angles, radians; z: ln of the first radius; w: ln of last over first
    vec4 polarSize;   // x: radii; y: angles; z: what a cell keeps of the sum before it
    vec4 grid;        // x: pixels along a cell; yz: first cell of the tile; w: mask pixels per picture pixel
    vec4 sides;       // x: technique on the left, y: on the right (bits: 1 screen space, 2 volume); z: pixel of the wipe; w: picture shown
    vec4 mask;        // x: threshold; y: angle around the sun; z: 1 for the colors of the sky; w: 1 to shift samples
    vec4 low[2];      // of the openings, world space; w: axis across it
    vec4 high[2];     // w: the plane of the opening on that axis
    vec4 airLow[2];   // box of air around each beam, world space; w of the first: number of openings
    vec4 airHigh[2];
} rays;

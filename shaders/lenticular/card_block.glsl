// The card and its two prints. The card's own space: meters, the center of its front at the origin, x to the right, y
// up, z towards the viewer. GLSL and C++: render/glsl/std140.h.
#define CARD_PRINT_FIELDS(FIELD, ARRAY) \
    FIELD(vec2, halfSize)      /* half size of the picture, meters */ \
    FIELD(int, views) \
    FIELD(float, pitch)        /* pitch of the lenses, meters */ \
    FIELD(float, radius)       /* radius of curvature of a lens, in pitches */ \
    FIELD(float, thickness)    /* thickness of the sheet, in pitches */ \
    FIELD(float, conic)        /* conic constant of the lens */ \
    FIELD(float, blur)         /* width of the ink's blur, in pitches */ \
    FIELD(vec3, index)         /* refractive index, for red, green and blue */ \
    FIELD(float, pitchRatio)   /* lens pitch divided by the strips' pitch */ \
    FIELD(float, phase)        /* in lenses */ \
    FIELD(float, slope)        /* slope of the print relative to the sheet */ \
    FIELD(float, texturePerLens)  /* views: width of a lens in texture coordinates; rasters: pixels per lens pitch */ \
    FIELD(vec2, size)          /* picture in texels; rasters: rows of the whole raster, without mip levels */
BLOCK_STRUCT(CardPrintBlock, CARD_PRINT_FIELDS)

#define CARD_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromCard) \
    FIELD(mat4, cardFromWorld) \
    FIELD(vec3, leftEye)       /* in the card's space; both are the camera if there is one eye */ \
    FIELD(vec3, rightEye) \
    FIELD(vec3, lamp)          /* position of the lamp that is aimed at the card, in the card's space */ \
    FIELD(vec3, halfSize)      /* half size of the card, meters */ \
    FIELD(float, scroll)       /* 0 at rest to 1 */ \
    FIELD(vec2, across)        /* direction across the lenses: unit vector in the card's front */ \
    FIELD(vec2, along) \
    ARRAY(CardPrintBlock, prints, 2)
BLOCK_STRUCT(CardObject, CARD_OBJECT_FIELDS)

// The card and its two prints. The card's own space: meters, the middle of its front at the origin, x to the right, y
// up, z towards the viewer. GLSL and C++: render/glsl/std140.h.
#define CARD_PRINT_FIELDS(FIELD, ARRAY) \
    FIELD(vec2, halfSize)      /* of the picture, meters */ \
    FIELD(int, views) \
    FIELD(float, pitch)        /* of the lenses, meters */ \
    FIELD(float, radius)       /* of a lens, in pitches */ \
    FIELD(float, thickness)    /* of the sheet, in pitches */ \
    FIELD(float, conic)        /* constant of the lens */ \
    FIELD(float, blur)         /* width of the ink's, in pitches */ \
    FIELD(vec3, index)         /* of refraction, for red, green and blue */ \
    FIELD(float, pitchRatio)   /* lens pitch over strips' pitch */ \
    FIELD(float, phase)        /* in lenses */ \
    FIELD(float, slope)        /* of the print against the sheet */ \
    FIELD(float, texturePerLens)  /* views: one lens as a part of the texture; rasters: pixels per lens pitch */ \
    FIELD(vec2, size)          /* of the picture in texels; rasters: rows of the whole raster, without its halvings */
BLOCK_STRUCT(CardPrintBlock, CARD_PRINT_FIELDS)

#define CARD_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromCard) \
    FIELD(mat4, cardFromWorld) \
    FIELD(vec3, leftEye)       /* the card's space; both are the camera where there is one eye */ \
    FIELD(vec3, rightEye) \
    FIELD(vec3, halfSize)      /* of the card, meters */ \
    FIELD(float, scroll)       /* 0 at rest to 1 */ \
    FIELD(vec2, across)        /* the lenses: unit vector of the card's front */ \
    FIELD(vec2, along) \
    ARRAY(CardPrintBlock, prints, 2)
BLOCK_STRUCT(CardObject, CARD_OBJECT_FIELDS)

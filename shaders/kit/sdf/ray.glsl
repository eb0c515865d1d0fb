// Camera rays in the object's own space.
#include "kit/sdf/object.glsl"

struct LocalRay {
    vec3 origin;
    vec3 direction;   // unit length
    float perDepth;   // local length per meter along the view axis
    float halfPixel;  // half a pixel's width at local distance 1, never too large
    vec2 span;        // interval of the ray inside the box, from the near plane on
};

LocalRay localRay(vec2 fragCoord)
{
    LocalRay r;
#ifdef PIXEL_CENTERS
    fragCoord -= frame.tileOrigin - frameTile();  // All samples at the same position: aliased edges.
#endif
    vec3 world = frameRay(fragCoord);
    vec3 d = mat3(object.localFromWorld) * world;
    r.perDepth = length(d);
    r.direction = d / r.perDepth;
    r.origin = (object.localFromWorld * vec4(frame.eye, 1.0)).xyz;
    // A width in world space shrinks by at most the largest scale when it is transformed to the object's space.
    r.halfPixel = 0.5 * frame.pixelAngle / (r.perDepth * object.largestScale);
    r.span = rayBox(r.origin, r.direction, object.boxLow, object.boxHigh);
    r.span.x = max(r.span.x, frame.nearPlane * r.perDepth);
    return r;
}

#ifdef CONE_PREPASS
// Side of the block of pixels that one cone covers; blocks lie on the grid of the whole picture.
const float BLOCK = float(CONE_PREPASS);

// Position of the tile within its first block.
vec2 tileInBlock()
{
    return mod(frameTile(), BLOCK);
}
#endif

// Draws translucent parts of a user's model, lit and blended from back to front. Permutations: those of
// pixel_art/picture.glsl, pixel_art/light.glsl and kit/material.glsl, and UNLIT (some parts are).
#include "pixel_art/picture.glsl"
#include "pixel_art/object.glsl"
#include "kit/material.glsl"
#include "pixel_art/light.glsl"

in vec3 modelPosition;
in vec3 viewNormal;
in vec2 uvAt;

layout(location = 0) out vec4 colorOut;   // premultiplied alpha; a: opacity
layout(location = 1) out vec4 normalOut;  // view space, of the nearest part
layout(location = 2) out vec4 depthOut;   // reversed depth, of the nearest part

void main()
{
    vec3 n = dot(viewNormal, viewNormal) > 0.0 ? normalize(viewNormal) : vec3(0.0, 0.0, 1.0);
    if (!gl_FrontFacing) n = -n;
    vec4 base = materialColor(uvAt);
    vec3 emitted = materialEmission(uvAt);
    if (base.a <= 0.0) discard;
    vec3 world = (object.worldFromModel * vec4(modelPosition, 1.0)).xyz;
    vec3 place = (world - pixel.worldFromView[3].xyz) * mat3(pixel.worldFromView);
    float wide = pixel.orthographic ? 1.0 : -place.z;
    float width = 2.0 * pixel.halfExtent.y * wide / float(pixel.size.y);
    vec3 lit = shaded(base.rgb, n, sunOn(place, n, width)) + emitted;
#ifdef UNLIT
    if (object.unlit) lit = base.rgb;
#endif
    colorOut = vec4(clamp(lit, 0.0, 1.0) * base.a, base.a);
    // Blended with an opacity of 1, so that these two replace the values behind.
    normalOut = vec4(n, 1.0);
    depthOut = vec4(gl_FragCoord.z, 0.0, 0.0, 1.0);
}

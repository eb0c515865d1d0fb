// Enameled letters, from a signed distance field (Green 2007, "Improved Alpha-Tested Magnification").
#include "lib/frame.glsl"
#include "lib/surface.glsl"
#include "kit/surface_object.glsl"

layout(binding = UNIT_FONT) uniform sampler2D font;

in vec3 worldPosition;
in vec3 worldNormal;
in vec2 glyphUv;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

void main()
{
    float d = texture(font, glyphUv).r - 0.5;
    // Half a screen pixel of blur on either side of the outline, and never sharper than the distance field's
    // resolution.
    float width = clamp(length(fwidth(glyphUv) * vec2(textureSize(font, 0))) * 0.7 / object.fontSpread, 0.01, 0.5);
    float coverage = smoothstep(-width, width, d);
    if (coverage <= 0.003) discard;
    Surface s;
    s.position = worldPosition;
    s.normal = normalize(worldNormal);
    s.baseColor = object.baseColor.rgb;
    s.metalness = 0.0;
    s.roughness = 0.45;
    s.specular = 0.5;
    s.ambient = ambientAt(s.position, s.normal);
    s.occlusion = 1.0;
    vec3 toEye = normalize(frame.eye - worldPosition);
    // Premultiplied alpha.
    radiance = vec4(shadeSurface(s, toEye), 1.0) * coverage * object.baseColor.a;
#ifdef WRITE_ALBEDO
    albedoOut = vec4(s.baseColor, 1.0) * coverage * object.baseColor.a;
#endif
}

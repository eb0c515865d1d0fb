// Draws a mesh instead of the marched body, with the same material, but without the effects that need a march.
// Permutations: WRITE_NORMAL, DEPTH_ONLY (no shading).
#include "kit/sdf/object.glsl"
#include "lib/surface.glsl"

in vec3 localPosition;
in vec3 worldNormal;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

void main()
{
#ifndef DEPTH_ONLY
    turnDisk(framePixel(gl_FragCoord.xy));
    fieldDistance(localPosition);  // Sets fieldPart.
    FieldMaterial material = fieldMaterial(localPosition);
    Surface s;
    s.position = (object.worldFromLocal * vec4(localPosition, 1.0)).xyz;
    vec3 toEye = normalize(frame.eye - s.position);
    s.normal = safeNormalize(worldNormal, toEye);
    if (!gl_FrontFacing) s.normal = -s.normal;
    s.baseColor = material.baseColor;
    s.metalness = material.metalness;
    s.roughness = clamp(material.roughness, 0.045, 1.0);
    s.specular = material.specular;
    s.ambient = ambientAt(s.position, s.normal);
    s.occlusion = 1.0;
    radiance = vec4(min(shadeSurface(s, toEye), vec3(6e4)), 1.0);  // Half floats end at 65504.
#ifdef WRITE_NORMAL
    normalOut = vec4(s.normal, 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(s.baseColor, 1.0);
#endif
#endif
}

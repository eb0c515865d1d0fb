// Floor of the pit. Darkens it by the light that the bodies block, blended over it, and draws the rug on it. With
// ALONE, draws the floor itself, too, fading out.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "fur/bodies.glsl"
#include "fur/rug.glsl"

in vec3 world;
in vec2 left;
in vec3 inPit;
in vec3 onRug;
flat in vec3 upwards;
flat in vec3 ambient;
flat in vec3 lampOnFloor;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

vec3 sunOnFloor(vec3 normal)
{
    if (dot(light.sunIrradiance, vec3(1.0)) <= 0.0) return vec3(0.0);
    float lit = sunVisibility(world, upwards) * max(dot(normal, light.sunDirection), 0.0);
    return light.sunIrradiance * sunThroughGlass(world) * (lit / PI);
}

const vec3 FLOOR_COLOR = vec3(0.34, 0.31, 0.28);  // with ALONE

// Radiance of the rug. `width`: of the pixel, in the pit. `open`: share of the sky's light past the bodies.
vec3 rugRadiance(float r, float width, float open)
{
    RugPoint rug = rugPoint(inPit.xz, width, fur.rugRadius, fur.rugColor);
    vec3 normal = normalize(mat3(fur.worldFromPit) * rug.normal);
    vec3 toLamp = lampDirection();
    vec3 lamp = lampLight() * (max(dot(normal, toLamp), 0.0) / PI * left.y * open);
    float wall = 1.0 - 0.45 * exp(-max(fur.pitRadius - r, 0.0) * 3.0);
    float facing = max(dot(normal, upwards), 0.0);
    vec3 sky = onRug * (open * wall * facing);
    return rug.color * ((sky + lamp) * rug.open + sunOnFloor(normal));
}

void main()
{
    turnDisk(framePixel(gl_FragCoord.xy));
    float open = left.x * left.x;
    float r = length(inPit.xz);
    vec3 lamp = lampOnFloor * (left.y * open);
#ifdef ALONE
    float there = 1.0 - smoothStep(0.35, 1.0, r / fur.pitRadius);
    vec3 color = FLOOR_COLOR * (ambient * open + sunOnFloor(upwards) + lamp);
    radiance = vec4(color, 1.0) * there;
#else
    // The hall has lit the floor with both lights already. The output is the share of their light that the bodies do
    // not block.
    vec3 gray = vec3(0.2126, 0.7152, 0.0722);
    float all = dot(ambient + lampOnFloor, gray);
    float there = dot(ambient * open + lamp, gray);
    radiance = vec4(0.0, 0.0, 0.0, all > 0.0 ? 1.0 - min(there / all, 1.0) : 1.0 - open);
    // Contact shadow of the rug's edge.
    float beside = r - fur.rugRadius;
    if (fur.rugRadius > 0.0) radiance.a = 1.0 - (1.0 - radiance.a) * (1.0 - 0.5 * exp(-max(beside, 0.0) * 60.0));
#endif
    float edge = max(fwidth(r), 1.0e-5);
    float cover = fur.rugRadius > 0.0 ? clamp(0.5 + (fur.rugRadius - r) / edge, 0.0, 1.0) : 0.0;
    float width = max(length(dFdx(inPit.xz)), length(dFdy(inPit.xz)));
    if (cover > 0.0) {
        vec3 rug = min(rugRadiance(r, width, open), vec3(6e4));
        radiance = radiance * (1.0 - cover) + vec4(rug, 1.0) * cover;
    }
#ifdef WRITE_ALBEDO
    vec3 rugColor = rugPoint(inPit.xz, width, fur.rugRadius, fur.rugColor).color;
#ifdef ALONE
    albedoOut = mix(vec4(FLOOR_COLOR, 1.0) * there, vec4(rugColor, 1.0), cover);
#else
    albedoOut = vec4(rugColor, 1.0) * cover;  // A floor in shadow keeps its color.
#endif
#endif
}

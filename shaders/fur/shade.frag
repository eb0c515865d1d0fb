// Lights the strands of one body (the first of the block) that the shells found, once per pixel.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "fur/bodies.glsl"
#include "fur/found.glsl"
#include "fur/hair.glsl"
#include "fur/marking.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler2D coatFound;

flat in vec3 keyDirection;
flat in vec3 toLamp;
flat in float cover;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

// Visible point of the coat in a pixel; directions in world space.
struct HairPoint {
    vec3 albedo;
    vec3 normal;      // of the coat, turned partly towards the visible side of the strand
    vec3 coatNormal;
    vec3 along;
    vec3 toEye;
    float height;
    float open;       // share of the ambient light past the coat
    bool bare;        // true: skin without a strand
};

// One comparison in each map: fur makes the edge of a shadow irregular anyway.
float sunOnFur(vec3 world)
{
    float visible = 1.0;
    if (light.hallCastsShadow) visible = shadowMapLight(hallShadow, shadowPosition(light.hallShadowFromWorld, world));
    if (light.exhibitsCastShadow) visible *= shadowMapLight(exhibitShadow, shadowPosition(light.exhibitShadowFromWorld, world));
    return visible;
}

// Light from one direction. Multiple scattering between the strands is half Lambert, colored and weakened on its way
// into the coat. Direct light is reflected by a strand, and makes a thin fringe glow from behind.
vec3 directLight(vec3 irradiance, vec3 l, HairPoint p)
{
    float slant = dot(p.coatNormal, l);
    float crossed = (1.0 - p.height) * parameters.selfShadow * cover * 2.2 / max(slant + 0.35, 0.15);
    // The body blocks light for parts that face far away from it, but not for its fringe.
    vec3 lit = irradiance * smoothStep(-0.55 - 0.35 * p.height, 0.25 - 0.35 * p.height, slant);
    vec3 color = p.albedo * lit * forwardScattered(crossed, p.albedo) * scatteredOcclusion(p.open, p.albedo) * (halfLambert(dot(p.normal, l)) / PI);
    if (p.bare) return color;
    HairLobes lobes = hairLobes(hairAngles(p.along, l, p.toEye), p.albedo, 0.4);
    float fringe = 1.0 - abs(dot(p.coatNormal, p.toEye));
    vec3 mirrored = (lobes.r + lobes.trt) * (2.0 * parameters.sheen * p.open);
    return color + lit * exp(-crossed) * (mirrored + lobes.tt * (parameters.rimLight * p.height * fringe * fringe));
}

// Color of a strand at the height where it was found. `world`: that point.
vec3 strandColor(FoundStrand found, vec3 world)
{
    vec3 albedo = mix(fur.bodies[0].rootColor, fur.bodies[0].tipColor, powPositive(found.height, parameters.gradient));
    // Markings follow the root. The strand leaves along the normal and ends along its direction at the top.
    if (fur.bodies[0].marking != MARKING_NONE) {
        vec3 root = (fur.bodies[0].bodyFromWorld * vec4(world, 1.0)).xyz - normalize(found.coatNormal + found.along) * (found.height * fur.bodies[0].strandLength);
        albedo = mix(albedo, fur.bodies[0].markColor, markingShare(fur.bodies[0].marking, root, found.height, fur.bodies[0].markSize));
    }
    return clamp(albedo * (1.0 + parameters.colorVariation * (found.rank - 0.5)), 0.0, 1.0);
}

HairPoint hairPoint(FoundStrand found, vec3 toEye, vec3 world)
{
    HairPoint p;
    mat3 outwards = transpose(mat3(fur.bodies[0].bodyFromWorld));
    p.height = found.height;
    p.bare = found.height <= 0.0;
    p.albedo = strandColor(found, world);
    p.coatNormal = normalize(outwards * found.coatNormal);
    p.along = normalize(mat3(fur.bodies[0].worldFromBody) * found.along);
    p.toEye = toEye;
    // A strand is round: its sides face sideways.
    vec3 aside = cross(mat3(fur.bodies[0].bodyFromWorld) * toEye, found.along);
    vec3 across = safeNormalize(mat3(fur.bodies[0].worldFromBody) * aside, vec3(0.0)) * found.across;
    p.normal = p.bare ? p.coatNormal : normalize(p.coatNormal + across * 0.5 + p.along * 0.25);
    p.open = mix(1.0, coatOcclusion(found.height, parameters.occlusionAttenuation, parameters.occlusionBias), cover);
    return p;
}

// Visible share past the other bodies, the floor and the wall of the pit: of ambient light, x, and of the lamp, y.
vec2 openAround(HairPoint p, vec3 world, vec3 inPit)
{
    vec2 left = vec2(1.0);
    for (int i = 1; i < FUR_BODIES; ++i) left *= openTo(fur.bodies[i], world, p.coatNormal, toLamp);
    float below = 0.5 - 0.5 * p.coatNormal.y;
    left.x *= 1.0 - 0.9 * below * exp(-max(inPit.y, 0.0) * 1.1);
    float wallShade = exp(-max(fur.pitRadius - length(inPit.xz), 0.0) * 4.0) * exp(-max(inPit.y, 0.0) * 3.0);
    left.x *= 1.0 - 0.35 * wallShade;
    return left;
}

// Ambient light of the room: through the coat, reflected along the strands, and through the fringe from the background.
vec3 roomLight(HairPoint p, vec3 world, vec3 inPit, float open)
{
    // A coat is thick: parts that face away from that side get its light through more hair.
    float wrapped = 0.5 + 0.5 * dot(p.normal, keyDirection);
    vec3 ambient = probeAmbient(p.normal) * (open * mix(1.0, 1.7 * wrapped * wrapped, parameters.contrast * cover));
    vec3 color = p.albedo * ambient * scatteredOcclusion(p.open, p.albedo);
    if (p.bare) {
        float cosine = dot(p.coatNormal, p.toEye);
        return color + probeRadiance(world, reflect(-p.toEye, p.coatNormal), 0.6) * (schlick(cosine, 0.04) * open * p.open);
    }
    float cone = (dot(p.along, keyDirection) + dot(p.along, p.toEye) + 0.06) / 0.29;
    color += ambient * (parameters.sheen * p.open * open * 0.4 * exp(-0.5 * cone * cone)) * mix(vec3(0.3), p.albedo, 0.7);

    float grazing = 1.0 - clamp(dot(p.coatNormal, p.toEye), 0.0, 1.0);
    float hall = hallBehind(inPit, mat3(fur.pitFromWorld) * -p.toEye);
    if (grazing <= 0.0 || hall <= 0.0) return color;
    vec3 behind = probeRadiance(world, normalize(p.coatNormal * 0.5 - p.toEye), 0.5) * (hall * open * p.height * grazing * grazing);
    return color + behind * (p.albedo * (parameters.rimLight * 1.5 * p.height * grazing) + 0.15 * parameters.sheen * p.open);
}

void main()
{
    FoundStrand found = unpackedStrand(texelFetch(coatFound, ivec2(gl_FragCoord.xy), 0));
    if (found.body != fur.bodies[0].number) discard;
    vec3 ray = frameRay(gl_FragCoord.xy);
    vec3 world = frame.eye + ray * found.viewDepth;
    HairPoint p = hairPoint(found, -normalize(ray), world);
    vec3 inPit = (fur.pitFromWorld * vec4(world, 1.0)).xyz;
    vec2 left = openAround(p, world, inPit);
    vec3 color = roomLight(p, world, inPit, left.x);
    if (dot(light.sunIrradiance, vec3(1.0)) > 0.0) {
        // The lookup is moved a little towards the sun, so that a strand is not shadowed by its own shell.
        float visible = sunOnFur(world + light.sunDirection * 0.012);
        if (visible > 0.0) color += directLight(light.sunIrradiance * sunThroughGlass(world) * visible, light.sunDirection, p);
    }
    if (parameters.lamp > 0.0) color += directLight(lampLight() * left.y, toLamp, p);
    radiance = vec4(min(color, vec3(6e4)), 1.0);
#ifdef WRITE_ALBEDO
    albedoOut = vec4(p.albedo, 1.0);
#endif
}

// Light on the strands of one body (the first of the block) that the shells found, once for every pixel.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "fur/bodies.glsl"
#include "fur/found.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler2D coatFound;

flat in vec3 keyDirection;
flat in vec3 toLamp;

layout(location = 0) out vec4 radiance;

// A highlight along hair, around the cone that mirrors the light (Kajiya and Kay 1989).
float hairLobe(vec3 along, vec3 toLight, vec3 toEye, float shift, float exponent)
{
    float cosL = dot(along, toLight) + shift;
    float cosV = dot(along, toEye);
    float sines = safeSqrt(1.0 - cosL * cosL) * safeSqrt(1.0 - cosV * cosV);
    return powPositive(clamp(sines - cosL * cosV, 0.0, 1.0), exponent);
}

// One comparison in each map: the edge of a shadow frays by itself where it falls on fur.
float sunOnFur(vec3 world)
{
    float visible = 1.0;
    if (light.hallCastsShadow) visible = shadowMapLight(hallShadow, shadowPosition(light.hallShadowFromWorld, world), SHADOW_FILTER_HARD);
    if (light.exhibitsCastShadow) visible *= shadowMapLight(exhibitShadow, shadowPosition(light.exhibitShadowFromWorld, world), SHADOW_FILTER_HARD);
    return visible;
}

// Light from one direction, as hair sends it on: half Lambert, weakened on its way into the coat; highlights along the strands, white from
// their surface and colored from inside them (Marschner et al. 2003); and what a thin fringe lets through.
vec3 directLight(vec3 irradiance, vec3 l, vec3 albedo, vec3 normal, vec3 skinNormal, vec3 along, vec3 toEye, float height, float occlusion)
{
    float deep = (1.0 - height) * parameters.selfShadow;
    float slant = dot(skinNormal, l);
    float through = exp(-deep * 2.2 / max(slant + 0.35, 0.15));
    // The body itself is in the way of what faces far off the light, but not of its fringe.
    float around = smoothStep(-0.55 - 0.35 * height, 0.25 - 0.35 * height, slant);
    vec3 lit = irradiance * (through * around / PI);
    vec3 color = albedo * lit * (halfLambert(dot(normal, l)) * occlusion);
    color += lit * (parameters.sheen * occlusion * (0.35 * hairLobe(along, l, toEye, 0.08, 60.0) + albedo * 0.7 * hairLobe(along, l, toEye, -0.1, 12.0)));
    float fringe = 1.0 - abs(dot(skinNormal, toEye));
    float towards = max(-dot(toEye, l), 0.0);
    return color + albedo * lit * (parameters.rimLight * height * fringe * fringe * (0.3 + 3.0 * powPositive(towards, 4.0)));
}

void main()
{
    FoundStrand found = unpackedStrand(texelFetch(coatFound, ivec2(gl_FragCoord.xy), 0));
    if (found.body != fur.bodies[0].number) discard;
    float height = found.height;
    vec3 albedo = mix(fur.bodies[0].rootColor, fur.bodies[0].tipColor, powPositive(height, parameters.gradient));
    albedo = clamp(albedo * (1.0 + parameters.colorVariation * (found.rank - 0.5)), 0.0, 1.0);
    vec3 ray = frameRay(gl_FragCoord.xy);
    vec3 world = frame.eye + ray * found.viewDepth;
    vec3 toEye = -normalize(ray);

    mat3 outwards = transpose(mat3(fur.bodies[0].bodyFromWorld));
    vec3 hairNormal = normalize(outwards * found.normal);
    vec3 skinNormal = normalize(outwards * found.coatNormal);
    vec3 tipOffset = mat3(fur.bodies[0].worldFromBody) * (fur.bodies[0].tipOffset + fur.bodies[0].wind);
    vec3 along = normalize(skinNormal + (tipOffset + (hairNormal - skinNormal) * 0.5) * height);

    // What the coat hides from itself.
    float occlusion = coatOcclusion(height, parameters.occlusionAttenuation, parameters.occlusionBias);
    // What the other bodies, the floor and the wall of the pit hide.
    vec2 left = vec2(1.0);
    for (int i = 1; i < FUR_BODIES; ++i) left *= openTo(fur.bodies[i], world, skinNormal, toLamp);
    float open = left.x;
    vec3 inPit = (fur.pitFromWorld * vec4(world, 1.0)).xyz;
    float below = 0.5 - 0.5 * skinNormal.y;
    open *= 1.0 - 0.9 * below * exp(-max(inPit.y, 0.0) * 1.1);
    float wallShade = exp(-max(fur.pitRadius - length(inPit.xz), 0.0) * 4.0) * exp(-max(inPit.y, 0.0) * 3.0);
    open *= 1.0 - 0.35 * wallShade;

    vec3 bent = normalize(mix(skinNormal, hairNormal, 0.6));
    // A coat is thick: what faces away from that side gets its light through more hair.
    float wrapped = 0.5 + 0.5 * dot(bent, keyDirection);
    vec3 ambient = probeAmbient(bent) * (open * mix(1.0, 1.7 * wrapped * wrapped, parameters.contrast));
    vec3 color = albedo * ambient * occlusion;
    color += ambient * (parameters.sheen * occlusion * open * 0.4 * hairLobe(along, keyDirection, toEye, -0.06, 12.0)) * mix(vec3(0.3), albedo, 0.7);

    if (dot(light.sunIrradiance, vec3(1.0)) > 0.0) {
        vec3 l = light.sunDirection;
        // Looked up a little towards the sun, so that a strand is not kept off the light by its own shell.
        vec3 sun = light.sunIrradiance * sunOnFur(world + l * 0.012);
        color += directLight(sun, l, albedo, bent, skinNormal, along, toEye, height, occlusion);
    }
    if (parameters.lamp > 0.0) {
        color += directLight(lampLight() * left.y, toLamp, albedo, bent, skinNormal, along, toEye, height, occlusion);
    }

    // The window's light through the fringe, and what glances off it.
    float grazing = 1.0 - clamp(dot(skinNormal, toEye), 0.0, 1.0);
    vec3 behind = probeRadiance(world, normalize(-toEye + skinNormal * 0.5), 0.5) * (open * height * grazing * grazing);
    color += behind * albedo * (parameters.rimLight * 1.5 * height * grazing) + behind * (0.15 * parameters.sheen * occlusion);

    radiance = vec4(min(color, vec3(6e4)), 1.0);
}

// Bounced sunlight on a texel of the hall's lightmap: the light of the air there, times the texel's factor for all suns
// together. Irradiance over pi, for a sun of irradiance 1.
#include "lib/bindings.glsl"
#include "lib/air_light.glsl"
#include "hall/bounce_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Walls {
    AirOnWalls walls;
};

layout(binding = UNIT_EXHIBIT_A) uniform sampler3D bouncedAir;
layout(binding = UNIT_SOURCE) uniform sampler2D surfaces;

in vec3 worldPosition;
in vec3 worldNormal;
in vec2 atlasUv;

layout(location = 0) out vec4 bounced;

void main()
{
    vec3 root = texelFetch(surfaces, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 n = normalize(worldNormal);
    float air = airLightOf(bouncedAir, walls.low, walls.high, worldPosition, n).a;
    bounced = vec4(root * root * (walls.scale * air), 1.0);
}

// Irradiance of a volume of light probes on a surface with normal `n`. Each point of a grid has an ambient cube with
// six sides (McTaggart 2004, "Half-Life 2 / Valve Source Shading"). The volume texture stores the sides one behind the
// other. Values are interpolated linearly; outside the grid, those of its border are used.
vec4 airLightOf(sampler3D air, vec3 low, vec3 high, vec3 world, vec3 n)
{
    vec3 points = vec3(textureSize(air, 0)) * vec3(1.0, 1.0, 1.0 / 6.0);
    vec3 at = clamp((world - low) / (high - low), 0.0, 1.0) * (points - 1.0) + 0.5;
    vec2 across = at.xy / points.xy;
    // The texel centers of other sides are half a texel away, so that filtering does not mix them in.
    vec3 depths = (at.z + points.z * vec3(n.x < 0.0 ? 1.0 : 0.0, n.y < 0.0 ? 3.0 : 2.0, n.z < 0.0 ? 5.0 : 4.0)) / (6.0 * points.z);
    return n.x * n.x * textureLod(air, vec3(across, depths.x), 0.0) + n.y * n.y * textureLod(air, vec3(across, depths.y), 0.0) +
           n.z * n.z * textureLod(air, vec3(across, depths.z), 0.0);
}

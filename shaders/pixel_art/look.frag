// Draws the finished picture, or a debug view of its inputs. Linear display light; a: 1 where anything is visible.
// Before the palette, a is 2 for views that keep their own colors. Permutations: LEFT_VIEW and RIGHT_VIEW, values of
// the parameter `view`; LINES, REFERENCE_EDGES, SHADOWS, EMISSION, TRANSLUCENT, DEPTH_ALONE (`surfaces` is the
// depth: no view needs normals); SHOWN and LIT, output locations of the picture with the palette and before it;
// PALETTE, and those of pixel_art/dither.glsl. Compile-time choices replace branches, because some processors execute
// both sides.
#include "pixel_art/picture.glsl"
#include "pixel_art/surface.glsl"
#include "lib/heat_color.glsl"

layout(binding = UNIT_BASE_COLOR) uniform sampler2D colors;
layout(binding = UNIT_NORMAL) uniform sampler2D surfaces;
layout(binding = UNIT_ORM) uniform sampler2D trueNormals;
#ifdef EMISSION
layout(binding = UNIT_SOURCE) uniform sampler2D emissions;
#endif
#ifdef TRANSLUCENT
layout(binding = UNIT_BACKDROP) uniform sampler2D translucent;  // premultiplied alpha
#endif

#ifdef SHOWN
layout(location = SHOWN) out vec4 shown;
#endif
#ifdef LIT
layout(location = LIT) out vec4 lit;
#endif
#ifdef PALETTE
#include "pixel_art/dither.glsl"
#endif

Surface surfaceAt(ivec2 p)
{
#ifdef DEPTH_ALONE
    return Surface(vec3(0.0), 0.0, texelFetch(surfaces, p, 0).r);
#else
    return surfaceOf(texelFetch(surfaces, p, 0));
#endif
}

#include "pixel_art/edges.glsl"
#include "pixel_art/light.glsl"

Edges edgesAt(DepthLens lens, ivec2 p, Surface surface)
{
#ifdef REFERENCE_EDGES
    return referenceEdges(lens, p, surface);
#else
    Edges e = adaptiveEdges(lens, p, surface);
    if (isSky(lens, surface.depth)) e = Edges(0.0, 0.0, 0.0);
    return e;
#endif
}

vec3 skyColor(ivec2 p)
{
    float up = (float(p.y) + 0.5) / float(pixel.size.y);
    float towardsView = dot(pixel.up, vec3(0.0, 0.0, -1.0));
    return mix(parameters.horizon, parameters.zenith, clamp(up * 0.8 + 0.2 * towardsView, 0.0, 1.0));
}

vec3 finished(ivec2 p, DepthLens lens, Surface surface)
{
    bool sky = isSky(lens, surface.depth);
    vec4 base = texelFetch(colors, p, 0);
    vec3 n = surface.normal;
    vec3 place = positionAt(lens, p, surface.depth);
    float light = sunOn(place, n, texelWidth(lens, surface.depth));
    vec3 color = shaded(base.rgb, n, light);
    color += base.rgb * ((base.a - 1.0) * 1.6);
    float glows = clamp(base.a - 1.0, 0.0, 1.0);
#ifdef EMISSION
    vec3 emitted = texelFetch(emissions, p, 0).rgb;
    color += emitted;
    glows = clamp(max(glows, max(emitted.r, max(emitted.g, emitted.b))), 0.0, 1.0);
#endif
    if (sky) color = skyColor(p);
#ifndef LINES
    return color;
#else
    Edges e = edgesAt(lens, p, surface);
#ifdef REFERENCE_EDGES
    color = mix(color, mix(color, parameters.highlightColor, parameters.highlightStrength), e.highlight);
    return mix(color, mix(color, parameters.outlineColor, parameters.outlineStrength), e.outline);
#else
    vec3 lighter = mix(color * 1.5, parameters.highlightColor, 0.35) * mix(0.75, 1.0, light);
    color = mix(color, lighter, clamp(2.5 * parameters.highlightStrength, 0.0, 1.0) * e.highlight * (1.0 - glows));
    vec3 own = color * vec3(0.20, 0.16, 0.30);
    color = mix(color, mix(color, own, 0.6), parameters.outlineStrength * e.crease * (1.0 - e.outline));
    vec3 line = mix(parameters.outlineColor, own, parameters.coloredOutline);
    return mix(color, line, parameters.outlineStrength * e.outline * (1.0 - 0.7 * glows));
#endif
#endif
}

// `view` is a compile-time constant, so the other views are compiled out.
vec4 viewOf(int view, ivec2 p, DepthLens lens, Surface surface)
{
    bool sky = isSky(lens, surface.depth);
    if (view == view_finished) {
        vec3 behind = clamp(finished(p, lens, surface), 0.0, 1.0);
#ifdef TRANSLUCENT
        vec4 over = texelFetch(translucent, p, 0);
        return vec4(behind * (1.0 - over.a) + over.rgb, sky ? over.a : 1.0);
#else
        return vec4(behind, sky ? 0.0 : 1.0);
#endif
    }
    vec3 color = vec3(0.0);
    if (view == view_normals) color = pow(surface.normal * 0.5 + 0.5, vec3(2.2));
    if (view == view_error && !sky) {
        float cosine = dot(surface.normal, texelFetch(trueNormals, p, 0).xyz);
        color = heatColor(degrees(acos(clamp(cosine, -1.0, 1.0))) / parameters.errorScale);
    }
    if (view == view_depth && !sky) {
        float near = viewDistance(lens, surface.depth);
        color = vec3(0.9 * clamp(1.0 - (near - parameters.distance * 0.55) / (parameters.distance * 0.9), 0.0, 1.0));
    }
    if (view == view_edges) {
        Edges e = edgesAt(lens, p, surface);
        color = vec3(0.05) + vec3(0.9, 0.25, 0.1) * e.outline + vec3(0.1, 0.75, 0.3) * e.highlight +
                vec3(0.1, 0.3, 0.9) * e.crease;
    }
    return vec4(clamp(color, 0.0, 1.0), 2.0);
}

void main()
{
    DepthLens lens = pictureLens();
    ivec2 p = ivec2(gl_FragCoord.xy);
    Surface surface = surfaceAt(p);
#if LEFT_VIEW == RIGHT_VIEW
    vec4 color = viewOf(LEFT_VIEW, p, lens, surface);
#else
    vec4 color;
    if (p.x < pixel.divider)
        color = viewOf(LEFT_VIEW, p, lens, surface);
    else
        color = viewOf(RIGHT_VIEW, p, lens, surface);
#endif
#ifdef LIT
    lit = color;
#endif
#ifdef SHOWN
    shown = vec4(color.rgb, min(color.a, 1.0));
#ifdef PALETTE
    if (color.a < 1.5) shown.rgb = paletteColor(ditheredIndex(color.rgb, p));
#endif
#endif
}

// Outlines, highlights and creases of one texel. Include it after pixel_art/picture.glsl, with `Surface
// surfaceAt(ivec2)` defined before.

struct Edges {
    float outline;    // 1 on the near side of a step in depth, or between objects
    float highlight;  // 1 on edges that face light and eye
    float crease;     // 1 in a concave corner
};

const vec3 HIGHLIGHT_BIAS = vec3(1.0, 1.0, 1.0);

// Distance of a point behind the plane through another point, in texel widths. `away` is the vector between the points.
// Positive: the plane is on the near side. In perspective this is a first-order approximation over one texel, because
// the ray to the point turns.
float gapTo(vec3 away, vec3 n, float width)
{
    float predicted = -(n.x * away.x + n.y * away.y) / max(n.z, 0.12);
    return (predicted - away.z) / width;
}

// Computes the edges. A texel beyond the picture's border equals the border texel, so there is no edge between them.
// All four neighbors are read before any decision.
Edges adaptiveEdges(DepthLens lens, ivec2 p, Surface surface)
{
    Edges e = Edges(0.0, 0.0, 0.0);
    vec3 n = surface.normal;
    vec3 place = positionAt(lens, p, surface.depth);
    float width = texelWidth(lens, surface.depth);
    float leastTurn = parameters.edgeAngle * parameters.edgeAngle * 0.5;
    for (int i = 0; i < 4; ++i) {
        ivec2 q = p + ivec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
        q = clamp(q, ivec2(0), lens.size - 1);
        Surface other = surfaceAt(q);
        vec3 m = other.normal;
        vec3 there = positionAt(lens, q, other.depth);
        vec3 away = there - place;
        float gap = gapTo(away, n, width);
        float back = gapTo(vec3(0.0) - away, m, width);
        // Both planes must miss the other point: a fold, as of a roof, is no depth step.
        bool nothing = isSky(lens, other.depth);
        bool apart = min(abs(gap), abs(back)) > parameters.outlineGap;
        bool named = parameters.objectOutlines && other.id != surface.id;
        float line = named && surface.id > other.id ? 0.6 : 0.0;
        line = apart ? (there.z < place.z ? 1.0 : 0.0) : line;
        e.outline = max(e.outline, nothing ? 1.0 : line);
        vec3 turn = n - m;
        bool folded = !nothing && !apart && !named && 1.0 - dot(n, m) >= leastTurn;
        float convex = -dot(turn, away);
        bool chosen = dot(turn, HIGHLIGHT_BIAS) > 0.0;
        e.highlight = folded && chosen && convex > 0.0 ? 1.0 : e.highlight;
        e.crease = folded && !chosen && convex < 0.0 ? 1.0 : e.crease;
    }
    return e;
}

// Formulas that the reference takes from others: sums of absolute differences in meters, smoothed steps.
Edges referenceEdges(DepthLens lens, ivec2 p, Surface surface)
{
    vec3 n = surface.normal;
    float z = viewDistance(lens, surface.depth);
    float nearer = 0.0;
    float farther = 0.5;
    float turned = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 q = p + ivec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
        q = clamp(q, ivec2(0), lens.size - 1);
        Surface other = surfaceAt(q);
        float zq = viewDistance(lens, other.depth);
        nearer += clamp(zq - z, 0.0, 1.0);
        farther += z - zq;
        vec3 m = other.normal;
        turned += (1.0 - dot(n, m)) * smoothstep(-0.01, 0.01, dot(n - m, HIGHLIGHT_BIAS));
    }
    float behind = step(0.5, clamp(farther, 0.0, 1.0)) * clamp((farther - 0.5) * 10.0, 0.0, 1.0);
    Edges e;
    e.outline = smoothstep(0.2, 0.3, nearer);
    e.highlight = clamp(smoothstep(0.2, 0.8, turned) - behind, 0.0, 1.0);
    e.crease = 0.0;
    return e;
}

// One triangle that covers the target. Corner of this vertex, in texture coordinates: 0 to 1 inside the target.
vec2 coveringCorner()
{
    return vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
}

// The same at the far plane (depth 0), in clip space.
vec4 coveringPosition()
{
    return vec4(coveringCorner() * 2.0 - 1.0, 0.0, 1.0);
}

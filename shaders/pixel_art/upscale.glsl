// Returns where to sample a picture with linear filtering, so that its texels appear as squares with borders that are
// smoothed over one pixel of the larger picture. All texels have the same width, and none shimmers when the picture
// moves. `at` in texels; a pixel is `wide` texels wide, below 1.
vec2 sharpTexel(vec2 at, float wide)
{
    vec2 base = floor(at);
    vec2 within = at - base;
    float scale = 1.0 / max(wide, 1e-6);
    vec2 low = clamp(within * scale, vec2(0.0), vec2(0.5));
    vec2 high = clamp((vec2(1.0) - within) * scale, vec2(0.0), vec2(0.5));
    return base + vec2(0.5) + low - high;
}

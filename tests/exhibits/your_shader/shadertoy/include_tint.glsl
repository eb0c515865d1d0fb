vec4 tint(vec2 at)
{
    return vec4(floor(at), 77.0, 255.0) / 255.0;
}

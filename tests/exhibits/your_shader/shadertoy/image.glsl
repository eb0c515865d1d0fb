// mainImage with the size of the picture: red counts columns, green rows from below, blue is width + height.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 whole = floor(fragCoord);
    fragColor = vec4(whole, iResolution.x + iResolution.y * iResolution.z, 0.0) / 255.0;
}

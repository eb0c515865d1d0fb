// iTimeDelta in hundredths of a sixtieth of a second, iFrameRate, and iTime in tenths of a second.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(100.0 * 60.0 * iTimeDelta, iFrameRate, 10.0 * iTime, 0.0) / 255.0;
}

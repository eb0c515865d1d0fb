// iFrame: the number of the frame, its parity, and whether it is the first.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(iFrame, iFrame & 1, iFrame == 0 ? 1 : 0, 0) / 255.0;
}

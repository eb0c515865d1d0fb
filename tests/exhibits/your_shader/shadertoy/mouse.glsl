// iMouse: place in pixels while the button is held; signs of z and w say that it is held, and not pressed in this frame.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    bool isHeld = iMouse.z > 0.0 && iMouse.w <= 0.0;
    fragColor = vec4(iMouse.xy, isHeld ? 1.0 : 0.0, 0.0) / 255.0;
}

// Mip level of a picture whose pixels are as wide as the blur at the hit. `blur` is the tangent of half the angle by
// which a rough surface spreads the ray.
float blurLevel(float wayBehind, float blur)
{
    return log2(max(2.0 * blur * wayBehind / frame.pixelAngle, 1.0));
}

// A picture beside the shader, named by #iChannel0: its size, and its lower left texel.
#iChannel0 "file://four.png"
#iChannel0::MinFilter "Nearest"
#iChannel0::WrapMode "Clamp"
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec4 corner = texture(iChannel0, vec2(0.25, 0.25));
    fragColor = vec4(float(textureSize(iChannel0, 0).x) / 255.0, corner.g, texelFetch(iChannel0, ivec2(1, 0), 0).r, 1.0);
}

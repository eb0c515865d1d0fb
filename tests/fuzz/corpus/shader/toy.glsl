#iUniform float strength = 0.5 in { 0.0, 1.0 } step 0.1
#iUniform color3 tint = color3(1.0, .5, 0.)
#iChannel0 "file://sand.png"
#iChannel0::MinFilter "Nearest"
void mainImage(out vec4 c, in vec2 p) { c = vec4(tint, strength) * texture(iChannel0, p); }

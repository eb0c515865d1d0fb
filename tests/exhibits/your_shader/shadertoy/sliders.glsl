// #iUniform lines of every type, and the comment behind one that gives an exact value.
#iUniform float level = 7.0 in {0.0, 9.0} // 0 .. 9, default 7, exact 9, "Level"
#iUniform int count = 3 in {1, 20}
#iUniform bool isOn = 1
#iUniform vec2 shift = vec2(4.0, 5.0) in {0.0, 10.0}
#iUniform vec3 place = vec3(1.0, 2.0, 3.0) in {0.0, 10.0}
#iUniform color3 tint = color3(0.2, 0.4, 0.6)
#iUniform color4 veil = color4(1.0, 1.0, 1.0, 0.5)

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec3 numbers = vec3(level + float(count), (isOn ? 10.0 : 0.0) + shift.x + shift.y, place.x + place.y + place.z);
    fragColor = vec4(fragCoord.x < 12.0 ? numbers / 255.0 : tint * veil.rgb, veil.a);
}

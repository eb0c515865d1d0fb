#ifdef GL_ES
precision highp float;
precision highp int;
#endif
// GLSL ES 3.00: array constructors, switch, do, bit operations, unsigned numbers, a matrix that is not square, and names
// that later versions reserve.
const int table[4] = int[4](3, 5, 7, 11);
struct patch_ { vec2 size; };

int sample(int buffer)
{
    switch (buffer & 3) {
    case 0: return table[0];
    case 1: return table[1];
    default: return table[3];
    }
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    uint bits = 0x2Au << 1u;
    int rounds = 0;
    do ++rounds; while (rounds < 9);
    mat2x3 wide = mat2x3(vec3(1.0, 2.0, 3.0), vec3(4.0, 5.0, 6.0));
    patch_ one = patch_(vec2(wide * vec2(1.0, 2.0)));
    fragColor = vec4(sample(5) + sample(2) + rounds, int(bits), int(one.size.y), 0) / 255.0;
}

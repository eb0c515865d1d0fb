#include "../outside.glsl"
void main() {}

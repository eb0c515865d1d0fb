// Covers the target, at the far plane.
#include "lib/covering_triangle.glsl"

out vec2 textureCoordinate;

void main()
{
    textureCoordinate = coveringCorner();
    gl_Position = coveringPosition();
}

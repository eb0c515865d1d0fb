// Computes every lantern of the lattice for this frame: position, tilt and brightness.
#include "paper_lanterns/scene.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image3D afloat;

void main()
{
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (cell.x >= lake.cells.x || cell.y >= lake.cells.y) return;
    Lantern l = lanternOfCell(cell);
    imageStore(afloat, ivec3(cell, 0), vec4(l.place, l.light));
    imageStore(afloat, ivec3(cell, 1), vec4(l.tilt, l.turn, l.hue));
    imageStore(afloat, ivec3(cell, 2), vec4(l.glow, 0.0));
}

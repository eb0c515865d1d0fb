// Known load for testing clocks: its cost is proportional to the number of rounds.
#include "lib/bindings.glsl"
#include "lib/clock_load_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Load {
    ClockLoadBlock load;
};

layout(location = 0) out vec4 result;

void main()
{
    // Each round depends on the one before, so that no compiler removes any.
    uint state = uint(gl_FragCoord.x) * 1973u + uint(gl_FragCoord.y) * 9277u + 1u;
    for (int i = 0; i < load.rounds; ++i) state = (state ^ (state >> 15u)) * 747796405u + 2891336453u;
    result = vec4(float(state >> 8u) / 16777216.0);
}

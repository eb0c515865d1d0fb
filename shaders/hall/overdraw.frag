// Counts fragments by additive blending, one for each that passes the depth test.
layout(location = 0) out vec4 count;

void main()
{
    count = vec4(1.0, 0.0, 0.0, 0.0);
}

float fieldDistance(vec3 p)
{
    return length(p) - parameters.radius;
}

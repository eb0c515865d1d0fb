// Cube maps in OpenGL's orientation.

// Direction through a face (0 to 5: +x -x +y -y +z -z) at `p`, each -1 to 1; its largest component is 1.
vec3 cubeDirection(int face, vec2 p)
{
    if (face == 0) return vec3(1.0, -p.y, -p.x);
    if (face == 1) return vec3(-1.0, -p.y, p.x);
    if (face == 2) return vec3(p.x, 1.0, p.y);
    if (face == 3) return vec3(p.x, -1.0, -p.y);
    if (face == 4) return vec3(p.x, -p.y, 1.0);
    return vec3(-p.x, -p.y, -1.0);
}

// Center of a texel on a face of `size` texels, each coordinate -1 to 1.
vec2 cubeTexel(vec2 texel, float size)
{
    return (texel + 0.5) / size * 2.0 - 1.0;
}

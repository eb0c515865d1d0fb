// Hit of a ray, and the next ray from there.

int evaluations;  // Calls of fieldDistance for this pixel.

struct Hit {
    vec3 local;        // hit point, in the object's own space
    vec3 localNormal;  // facing the ray
    vec3 world;
    vec3 worldNormal;
    float tolerance;   // in local units
    float traveled;   // local length of the path so far
};

vec3 worldDirection(vec3 local)
{
    return normalize(mat3(object.worldFromLocal) * local);
}

Hit findHit(vec3 origin, vec3 direction, March march, MarchSettings settings)
{
    Hit hit;
    hit.local = origin + direction * march.t;
    hit.tolerance = hitTolerance(march.t, settings);
    hit.traveled = settings.traveled + march.t;
    int part = fieldPart;
    float step_ = max(parameters.normalStep, 0.25 * settings.pixelCone * hit.traveled);
    vec3 n = fieldNormal(hit.local, step_, parameters.normalMethod, -direction * march.side);
    fieldPart = part;
    evaluations += parameters.normalMethod == NORMAL_CENTRAL ? 6 : 4;
    // A ray inside the solid hits the surface from behind.
    hit.localNormal = n * march.side;
    hit.world = (object.worldFromLocal * vec4(hit.local, 1.0)).xyz;
    hit.worldNormal = worldNormalOf(hit.localNormal);
    return hit;
}

// Finds the next surface along a ray that starts on a surface. `side`: 1 outside the solid, -1 inside.
March onward(vec3 start, vec3 direction, float side, MarchSettings settings, float traveled)
{
    float tMax = rayBox(start, direction, object.boxLow, object.boxHigh).y;
    MarchSettings s = settings;
    s.tMin = 0.0;
    s.tMax = tMax;
    s.traveled = traveled;
    s.side = side;
    March march = sphereTrace(start, direction, s);
    evaluations += march.evaluations;
    return march;
}

// Intersections of rays with the scene.

struct SceneHit {
    vec3 position;
    vec3 normal;      // unit; outward
    float curvature;  // mean curvature of the surface, 1/meter, without its sign
    float tolerance;  // meters
    float traveled;   // length of the path so far
};

struct SceneSeen {
    vec3 radiance;
    vec3 normal;     // normal of the first surface; 0 if there is none
    float distance;  // distance to it; at least 1e20 if there is none
    int steps;       // steps of the camera ray
    vec3 albedo;     // base color of the first surface; 0 if there is none
};

MarchSettings sceneSettings(float tMin, float footprint)
{
    MarchSettings s = marchSettings(tMin, stage.farthest, 0.5 * footprint);
    s.tolerance = parameters.hitTolerance;
    s.stepLimit = parameters.stepLimit;
    return s;
}

// Finds the first surface along a ray, within the bounding box of the scene. Planes are intersected in closed form if
// the ray starts outside of them.
March sceneMarch(vec3 origin, vec3 direction, MarchSettings settings)
{
    MarchSettings s = settings;
    vec2 span = rayBox(origin, direction, stage.boxLow, stage.boxHigh);
#ifdef SCENE_NEAR
    float plane = settings.side < 0.0 ? -1.0 : scenePlaneAhead(origin, direction, SCENE_PLANES);
    if (plane < 0.0) span = vec2(0.0, settings.tMax);
    else s.tMax = min(s.tMax, plane);
    scenePlanesAway = plane < 0.0 ? 0.0 : 1e30;
#endif
    if (s.tMin > 0.0) s.tMin = max(s.tMin, span.x);
    s.tMax = min(s.tMax, span.y);
    // Floats are less precise far from the origin.
    s.toleranceFloor = 1e-5 + 4e-7 * length(origin);
    March march = sphereTrace(origin, direction, s);
    evaluations += march.evaluations;
#ifdef SCENE_NEAR
    scenePlanesAway = 0.0;
    if (!march.hit && plane >= 0.0 && plane <= settings.tMax) {
        march.hit = true;
        march.t = max(plane, settings.tMin);
        march.distance = 0.0;
        march.side = 1.0;
    }
#endif
    return march;
}

// Normal and curvature are those at the scale `width`, meters: central differences with steps of that length, or longer.
// The sum of the second differences is the Laplacian, which for a field of slope 1 is twice the mean curvature.
SceneHit sceneHit(vec3 origin, vec3 direction, March march, MarchSettings settings, float width)
{
    SceneHit hit;
    hit.position = origin + direction * march.t;
    hit.tolerance = hitTolerance(march.t, settings);
    hit.traveled = settings.traveled + march.t;
    float asked = min(parameters.normalStep, stage.largestNormalStep);
    float h = max(max(asked, width), 2e-6 * length(hit.position));
    vec3 gradient = vec3(0.0);
    float sum = 0.0;
    for (int i = 0; i < 6; ++i) {
        int axis = i < 3 ? i : i - 3;
        vec3 along = vec3(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0) * (i < 3 ? 1.0 : -1.0);
        float d = fieldDistance(hit.position + along * h);
        gradient += along * d;
        sum += d;
    }
    float slope = length(gradient) / (2.0 * h);
    vec3 fallback = -direction * march.side;
    hit.normal = slope > 1e-3 ? safeNormalize(gradient, fallback) : fallback;
    hit.curvature = 0.5 * abs(sum - 6.0 * march.distance) / (h * h * max(slope, 1e-3));
    evaluations += 6;
    return hit;
}

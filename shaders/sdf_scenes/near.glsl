// Acceleration grid: for each cell, the list of steps that can matter there. Infinite planes are stored separately.

#define SCENE_MOST_PLANES 4

layout(std430, binding = STORAGE_EXHIBIT_A) readonly buffer SceneRecords {
    vec4 sceneRecords[];
};

layout(std430, binding = STORAGE_EXHIBIT_B) readonly buffer SceneLists {
    uvec4 sceneLists[];
};

// Filled by exhibits/sdf_scenes/scene_grid.h.
layout(std430, binding = STORAGE_EXHIBIT_C) readonly buffer SceneNear {
    vec4 low;                           // low corner of the grid; w: cells per meter along x
    vec4 high;                          // high corner of the grid; w: cells per meter along y
    vec4 heldLow;                       // low corner of the box of all but the planes; w: cells per meter along z
    vec4 heldHigh;                      // high corner of that box
    uvec4 count;                        // number of cells; w: 0 without a grid, when all steps matter everywhere
    vec4 planes[SCENE_MOST_PLANES];     // normal and height
    uint planeMaterials[SCENE_MOST_PLANES];
    uvec2 cells[];                      // first step of the list, or none; distance at the cell's center
} sceneNear;

// Added to the distances of planes: excludes them from the field while a march intersects them in closed form.
float scenePlanesAway = 0.0;

struct SceneCell {
    uint first;       // first step of its list
    bool near;        // false: no surface lies within `clearance` of the point
    float clearance;  // negative inside
};

SceneCell sceneCellAt(vec3 p)
{
    SceneCell cell = SceneCell(0u, true, 0.0);
    if (sceneNear.count.w == 0u) return cell;
    vec3 perMeter = vec3(sceneNear.low.w, sceneNear.high.w, sceneNear.heldLow.w);
    vec3 last = vec3(sceneNear.count.xyz - 1u);
    vec3 at = clamp(floor((p - sceneNear.low.xyz) * perMeter), vec3(0.0), last);
    uvec3 index = uvec3(at);
    uvec2 found = sceneNear.cells[(index.z * sceneNear.count.y + index.y) * sceneNear.count.x + index.x];
    cell.near = found.x != 0xFFFFFFFFu;
    cell.first = cell.near ? found.x : 0u;
    // Accounts for a few times the rounding error of float32.
    vec3 center = sceneNear.low.xyz + (at + 0.5) / perMeter;
    float d = uintBitsToFloat(found.y);
    float sure = max(abs(d) * (1.0 - 2e-6) - distance(p, center), 0.0);
    cell.clearance = d < 0.0 ? -sure : sure;
    vec3 outside = max(max(sceneNear.low.xyz - p, p - sceneNear.high.xyz), vec3(0.0));
    if (outside.x + outside.y + outside.z > 0.0) {
        cell.near = false;
        cell.clearance = length(max(max(sceneNear.heldLow.xyz - p, p - sceneNear.heldHigh.xyz), vec3(0.0)));
    }
    return cell;
}

SceneMaterial sceneMaterialAt(uint record)
{
    return sceneMaterial(sceneRecords[record], sceneRecords[record + 1u], sceneRecords[record + 2u], sceneRecords[record + 3u]);
}

// Distance at which a ray that starts outside of all planes hits the first of them; below 0 if it starts inside one.
float scenePlaneAhead(vec3 origin, vec3 direction, int planes)
{
    float first = 1e30;
    for (int i = 0; i < planes; ++i) {
        float height = dot(sceneNear.planes[i].xyz, origin) - sceneNear.planes[i].w;
        float towards = -dot(sceneNear.planes[i].xyz, direction);
        if (height <= 0.0) return -1.0;
        if (towards * first > height) first = height / towards;
    }
    return first;
}

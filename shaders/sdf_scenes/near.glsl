// Acceleration grid: for each cell, the list of steps that can matter there. Infinite planes are stored separately.

layout(binding = UNIT_BUFFER_A) uniform samplerBuffer sceneRecords;
layout(binding = UNIT_BUFFER_B) uniform usamplerBuffer sceneLists;
layout(binding = UNIT_BUFFER_C) uniform usamplerBuffer sceneNear;

vec4 sceneRecord(uint i)
{
    return texelFetch(sceneRecords, int(i));
}

uvec4 sceneStep(uint i)
{
    return texelFetch(sceneLists, int(i));
}

vec4 nearHead(int i)
{
    return uintBitsToFloat(texelFetch(sceneNear, i));
}

// Filled by exhibits/sdf_scenes/scene_grid.h; read once for each pixel.
vec4 nearLow = nearHead(0);              // low corner of the grid; w: cells per meter along x
vec4 nearHigh = nearHead(1);             // high corner of the grid; w: cells per meter along y
vec4 heldLow = nearHead(2);              // low corner of the box of all but the planes; w: cells per meter along z
vec4 heldHigh = nearHead(3);             // high corner of that box
uvec4 nearCount = texelFetch(sceneNear, 4);  // number of cells; w: 0 without a grid, when all steps matter everywhere

// Normal and height.
vec4 scenePlane(int i)
{
    return nearHead(5 + i);
}

uint scenePlaneMaterial(int i)
{
    return texelFetch(sceneNear, 9)[i];
}

// First step of the list, or none; distance at the cell's center.
uvec2 nearCell(uint i)
{
    uvec4 both = texelFetch(sceneNear, 10 + int(i >> 1u));
    return (i & 1u) == 0u ? both.xy : both.zw;
}

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
    if (nearCount.w == 0u) return cell;
    vec3 perMeter = vec3(nearLow.w, nearHigh.w, heldLow.w);
    vec3 last = vec3(nearCount.xyz - 1u);
    vec3 at = clamp(floor((p - nearLow.xyz) * perMeter), vec3(0.0), last);
    uvec3 index = uvec3(at);
    uvec2 found = nearCell((index.z * nearCount.y + index.y) * nearCount.x + index.x);
    cell.near = found.x != 0xFFFFFFFFu;
    cell.first = cell.near ? found.x : 0u;
    // Accounts for a few times the rounding error of float32.
    vec3 center = nearLow.xyz + (at + 0.5) / perMeter;
    float d = uintBitsToFloat(found.y);
    float sure = max(abs(d) * (1.0 - 2e-6) - distance(p, center), 0.0);
    cell.clearance = d < 0.0 ? -sure : sure;
    vec3 outside = max(max(nearLow.xyz - p, p - nearHigh.xyz), vec3(0.0));
    if (outside.x + outside.y + outside.z > 0.0) {
        cell.near = false;
        cell.clearance = length(max(max(heldLow.xyz - p, p - heldHigh.xyz), vec3(0.0)));
    }
    return cell;
}

SceneMaterial sceneMaterialAt(uint record)
{
    return sceneMaterial(sceneRecord(record), sceneRecord(record + 1u), sceneRecord(record + 2u), sceneRecord(record + 3u));
}

// Distance at which a ray that starts outside of all planes hits the first of them; below 0 if it starts inside one.
float scenePlaneAhead(vec3 origin, vec3 direction, int planes)
{
    float first = 1e30;
    for (int i = 0; i < planes; ++i) {
        vec4 plane = scenePlane(i);
        float height = dot(plane.xyz, origin) - plane.w;
        float towards = -dot(plane.xyz, direction);
        if (height <= 0.0) return -1.0;
        if (towards * first > height) first = height / towards;
    }
    return first;
}

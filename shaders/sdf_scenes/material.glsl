// Surface material of a scene for both shading models, and the blend of two materials.
//
// GLSL 4.50 and C++ (exhibits/sdf_scenes/scene_functions_cpu.h).

struct SceneMaterial {
    vec3 color;             // linear; used by both shading models
    float ambient;          // Phong: share of the color in ambient light
    float diffuse;
    float specular;         // Phong: strength of the white highlight
    float shininess;        // Phong: exponent of the highlight
    float mirror;           // Phong: reflected share
    float metalness;        // 0 to 1
    float roughness;        // perceptual, 0 to 1
    float reflectance;      // 0.5 is 4 % at normal incidence
    float refractiveIndex;  // for glass
    float transmission;     // 0 is opaque, 1 is clear glass
    float emission;         // emitted light as a multiple of the color
};

struct SceneSurface {
    float distance;
    SceneMaterial material;
};

// Makes a material from the numbers in the order above; d.z and d.w are padding.
SceneMaterial sceneMaterial(vec4 a, vec4 b, vec4 c, vec4 d)
{
    SceneMaterial m;
    m.color = vec3(a.x, a.y, a.z);
    m.ambient = a.w;
    m.diffuse = b.x;
    m.specular = b.y;
    m.shininess = b.z;
    m.mirror = b.w;
    m.metalness = c.x;
    m.roughness = c.y;
    m.reflectance = c.z;
    m.refractiveIndex = c.w;
    m.transmission = d.x;
    m.emission = d.y;
    return m;
}

// Interpolates: exactly a at 0 and b at 1, bitwise.
SceneMaterial sceneBlend(SceneMaterial a, SceneMaterial b, float share)
{
    if (share <= 0.0) return a;
    if (share >= 1.0) return b;
    float rest = 1.0 - share;
    SceneMaterial m;
    m.color = a.color * rest + b.color * share;
    m.ambient = a.ambient * rest + b.ambient * share;
    m.diffuse = a.diffuse * rest + b.diffuse * share;
    m.specular = a.specular * rest + b.specular * share;
    m.shininess = a.shininess * rest + b.shininess * share;
    m.mirror = a.mirror * rest + b.mirror * share;
    m.metalness = a.metalness * rest + b.metalness * share;
    m.roughness = a.roughness * rest + b.roughness * share;
    m.reflectance = a.reflectance * rest + b.reflectance * share;
    m.refractiveIndex = a.refractiveIndex * rest + b.refractiveIndex * share;
    m.transmission = a.transmission * rest + b.transmission * share;
    m.emission = a.emission * rest + b.emission * share;
    return m;
}

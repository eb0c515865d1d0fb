// Shading of the reference: Phong with reflections, ambient light counted twice, values displayed without tone mapping.
// Akgul, Boucher and El Hajal, "Ray Marching and Ambient Occlusion Rendering".

#include "lib/srgb.glsl"

vec3 phongLit(SceneHit hit, SceneMaterial m, vec3 toEye)
{
    vec3 sum = vec3(0.0);
#ifdef LIGHTS
    for (int i = 0; i < min(stage.lights, SCENE_MOST_LIGHTS); ++i) {
        SceneLight l = sceneLight(i, hit.position);
        float cosine = dot(hit.normal, l.direction);
        if (cosine <= 0.0 || max(m.diffuse, m.specular) <= 0.0) continue;
#ifdef SHADOWS
        float visible = sceneVisibility(hit.position + hit.normal * (2.0 * hit.tolerance), l, uint(i));
#else
        float visible = 1.0;
#endif
        float gleam = powPositive(dot(reflect(-l.direction, hit.normal), toEye), m.shininess);
        sum += visible * l.arriving * (m.color * (m.diffuse * cosine) + m.specular * gleam);
    }
#endif
    return sum;
}

SceneSeen sceneSeen(PortalRay ray)
{
    SceneSeen seen = SceneSeen(vec3(0.0), vec3(0.0), 1e20, 0, vec3(0.0));
    MarchSettings settings = sceneSettings(max(ray.start, 1e-4), ray.footprint);
    vec3 origin = ray.origin;
    vec3 direction = ray.direction;
    vec3 color = vec3(0.0);
    float share = 1.0;
#ifdef MIRRORS
    const int most = 4;
#else
    const int most = 0;
#endif
    for (int bounce = 0; bounce <= most; ++bounce) {
        March march = sceneMarch(origin, direction, settings);
        if (bounce == 0) seen.steps = march.steps;
        if (!march.hit || (bounce > 0 && evaluations >= mostEvaluations)) {
            color += share * environmentLight(direction, 0.0);
            break;
        }
        SceneHit hit = sceneHit(origin, direction, march, settings, 0.25 * settings.pixelCone * (settings.traveled + march.t));
        SceneMaterial m = sceneSurface(hit.position).material;
        evaluations += 1;
        vec3 around = stage.ambient * m.color * m.ambient;
        vec3 lit = phongLit(hit, m, -direction) + 0.8 * around;
        if (bounce == 0) {
            seen.normal = hit.normal;
            seen.distance = march.t;
            seen.albedo = m.color;
            float open = 1.0;
#ifdef OCCLUSION
            if (max(around.r, max(around.g, around.b)) > 0.0) open = 1.0 - stage.occlusion * sceneHidden(hit.position, hit.normal);
#endif
            lit += open * around;
        }
#ifdef GLOWS
        lit += m.emission * m.color;
#endif
        color += (1.0 - m.mirror) * share * lit;
        share *= m.mirror;
        if (share < 0.004 || bounce >= stage.bounces) break;
        origin = hit.position + hit.normal * max(2.0 * hit.tolerance, 0.01);
        direction = reflect(direction, hit.normal);
        settings.tMin = 0.0;
        settings.traveled = hit.traveled;
        settings.side = 1.0;
    }
    seen.radiance = linearFromSrgb(color);  // As a screen shows the value directly, without tone curve.
    return seen;
}

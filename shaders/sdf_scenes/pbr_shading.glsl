// Physically based shading: metal, glaze and glass, lit by lamps and the environment; in linear light.

#define ROUGHEST_MIRROR 0.35  // Rougher surfaces show the blurred environment instead of traced reflections.

vec3 reflectanceOf(SceneMaterial m)
{
    return mix(vec3(0.08 * m.reflectance), m.color, m.metalness);
}

// Directional albedo of the GGX lobe as scale and bias of the reflectance; a fit in the manner of Karis 2014,
// "Physically Based Shading on Mobile".
vec2 mirrorShare(float roughness, float cosine)
{
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y;
    return max(vec2(-1.04, 1.04) * a + r.zw, vec2(0.0));
}

// Reflected light for light from l with irradiance pi: Burley 2012, Heitz 2014, Schlick 1994. `width`: tangent of half
// the light's apparent angle, which is the least width of highlights (Karis 2013, "Real Shading in Unreal Engine 4").
vec3 lightReflected(SceneMaterial m, vec3 n, vec3 toEye, vec3 l, float width)
{
    float cosL = dot(n, l);
    if (cosL <= 0.0) return vec3(0.0);
    vec3 h = safeNormalize(l + toEye, n);
    float cosV = max(dot(n, toEye), 1e-3);
    float cosH = clamp(dot(n, h), 0.0, 1.0);
    float sharp = max(m.roughness * m.roughness, 0.003);
    float a = clamp(sharp + 0.35 * width, 0.003, 1.0);
    float a2 = a * a;
    float d = a2 / (PI * pow(max(cosH * cosH * (a2 - 1.0) + 1.0, 1e-7), 2.0));
    float energy = sharp / a;
    float v = 0.5 / (cosL * sqrt(cosV * cosV * (1.0 - a2) + a2) + cosV * sqrt(cosL * cosL * (1.0 - a2) + a2));
    vec3 f = reflectanceOf(m);
    f += (1.0 - f) * schlick(clamp(dot(toEye, h), 0.0, 1.0), 0.0);
    vec3 diffuse = m.color * (1.0 - m.metalness) * (1.0 - m.transmission) * (1.0 - f);
    return (diffuse + PI * min(f * (d * v * energy), vec3(40.0))) * cosL;
}

// Roughness of a curved surface under a footprint of half the width `width`, meters: its normals under the footprint
// widen the lobe, so that highlights and reflections of small shapes do not flicker (Tokuyoshi and Kaplanyan 2019,
// "Improved Geometric Specular Antialiasing"). `cosine` is that of the angle to the eye.
float filteredRoughness(float roughness, float curvature, float width, float cosine)
{
    float turned = 2.0 * width * curvature;
    float grazing = 0.5 + 0.5 / max(cosine * cosine, 0.1);
    float a2 = roughness * roughness * roughness * roughness + 0.5 * turned * turned * grazing;
    return sqrt(sqrt(min(a2, 1.0)));
}

vec3 allLights(SceneHit hit, SceneMaterial m, vec3 n, vec3 toEye)
{
    vec3 sum = vec3(0.0);
#ifdef LIGHTS
    for (int i = 0; i < min(stage.lights, SCENE_MOST_LIGHTS); ++i) {
        SceneLight l = sceneLight(i, hit.position);
        if (dot(n, l.direction) <= 0.0 || l.arriving.r + l.arriving.g + l.arriving.b <= 0.0) continue;
#ifdef SHADOWS
        float visible = sceneVisibility(hit.position + n * (2.0 * hit.tolerance), l, uint(i));
        if (visible <= 0.0) continue;
#else
        float visible = 1.0;
#endif
        sum += visible * l.arriving * lightReflected(m, n, toEye, l.direction, l.width);
    }
#endif
    return sum;
}

// Radiance of the background for a ray that leaves the scene: environment and suns.
vec3 beyond(vec3 d, float roughness)
{
    vec3 light_ = environmentLight(d, roughness);
#if defined(LIGHTS) && !defined(PANORAMA)
    for (int i = 0; i < min(stage.lights, SCENE_MOST_LIGHTS); ++i) {
        if (int(stage.lightPlace[i].w) != SCENE_SUN) continue;
        float cosine = dot(d, stage.lightPlace[i].xyz);
        float off = safeAcos(cosine);
        float radius = max(atan(stage.lightColor[i].w), 0.004);
        light_ += stage.lightColor[i].rgb * (0.12 * exp(-off * 7.0) + 14.0 * (1.0 - smoothstep(radius, 1.35 * radius, off)) * (1.0 - roughness));
    }
#endif
    return light_;
}

#ifdef LAMPS
// Radiance of area lights that are directly visible before `t`.
vec3 lampsSeen(vec3 origin, vec3 d, float t)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < min(stage.lights, SCENE_MOST_LIGHTS); ++i) {
        if (int(stage.lightPlace[i].w) != SCENE_AREA) continue;
        vec3 across = stage.lightAcross[i].xyz;
        vec3 along = stage.lightAlong[i].xyz;
        vec3 facing = cross(across, along);
        float towards = dot(d, facing);
        if (towards >= 0.0) continue;
        vec3 away = stage.lightPlace[i].xyz - origin;
        float s = dot(away, facing) / towards;
        if (s <= 0.0 || s >= t) continue;
        vec3 place = d * s - away;
        if (abs(dot(place, across)) <= dot(across, across) && abs(dot(place, along)) <= dot(along, along)) sum += stage.lightColor[i].rgb;
    }
    return sum;
}
#endif

SceneSeen sceneSeen(PortalRay ray)
{
    SceneSeen seen = SceneSeen(vec3(0.0), vec3(0.0), 1e20, 0, vec3(0.0));
    MarchSettings settings = sceneSettings(max(ray.start, 1e-4), ray.footprint);
    vec3 origin = ray.origin;
    vec3 direction = ray.direction;
    vec3 color = vec3(0.0);
    vec3 share = vec3(1.0);
    float side = 1.0;  // -1 inside glass
    // Half the ray's width at its start, and its growth with distance, which curved mirrors increase.
    float width = settings.pixelCone * settings.traveled;
    float spread = settings.pixelCone;
    float roughness = 0.0;
    int bounces = 0;
#if defined(GLASS)
    const int most = 14;
    // The reflection at the first side of glass. It is traced after the path through the glass has ended.
    bool waits = false;
    bool waited = false;
    vec3 waitingOrigin = vec3(0.0);
    vec3 waitingDirection = vec3(0.0);
    vec3 waitingShare = vec3(0.0);
    float waitingTraveled = 0.0;
    float waitingWidth = 0.0;
    float waitingSpread = 0.0;
#elif defined(MIRRORS)
    const int most = 4;
#else
    const int most = 0;
#endif
    bool ended = false;
    for (int i = 0; i <= most; ++i) {
        if (ended) {
#ifdef GLASS
            if (!waits) break;
            waits = false;
            ended = false;
            origin = waitingOrigin;
            direction = waitingDirection;
            share = waitingShare;
            side = 1.0;
            settings.side = 1.0;
            settings.traveled = waitingTraveled;
            width = waitingWidth;
            spread = waitingSpread;
#else
            break;
#endif
        }
        March march = sceneMarch(origin, direction, settings);
        if (i == 0) seen.steps = march.steps;
#ifdef LAMPS
        if (side > 0.0) color += share * lampsSeen(origin, direction, march.hit ? march.t : stage.farthest);
#endif
        // Light from beyond the scene arrives along the ray, and along a reflection that is not traced.
        vec3 along = direction;
        float alongRoughness = roughness;
        vec3 alongShare = share;
        vec3 image = direction;
        float imageRoughness = roughness;
        vec3 imageShare = vec3(0.0);
        ended = !march.hit || (i > 0 && evaluations >= mostEvaluations);
        if (!ended) {
            width += spread * march.t;
            SceneHit hit = sceneHit(origin, direction, march, settings, 0.5 * width);
            // Infinite floors fade into the background before rays reach the step limit.
            float haze = smoothstep(0.05, 0.5, hit.traveled / stage.farthest);
            alongShare = share * haze;
            share *= 1.0 - haze;
            ended = haze >= 1.0;
            if (!ended) {
                SceneMaterial m = sceneSurface(hit.position).material;
                evaluations += 1;
                vec3 n = hit.normal * side;
                vec3 toEye = -direction;
                if (i == 0) {
                    seen.normal = n;
                    seen.distance = march.t;
                    seen.albedo = m.color;
                }
                float cosine = clamp(dot(n, toEye), 0.0, 1.0);
                m.roughness = filteredRoughness(m.roughness, hit.curvature, width, cosine);
                settings.tMin = 0.0;
                settings.traveled = hit.traveled;
                image = reflect(direction, n);
                imageRoughness = m.roughness;
                bool isGlass = false;
#ifdef GLASS
                isGlass = m.transmission > 0.5;
                if (side < 0.0) share *= exp(log(clamp(m.color, 0.02, 1.0)) * (march.t * 10.0));
#endif
                vec3 lit = vec3(0.0);
                if (side > 0.0 || !isGlass) lit = allLights(hit, m, n, toEye);
                if (!isGlass) {
                    float open = 1.0;
#ifdef OCCLUSION
                    open = 1.0 - stage.occlusion * sceneHidden(hit.position, n);
#endif
                    vec2 lobe = mirrorShare(m.roughness, cosine);
                    vec3 mirrors = reflectanceOf(m) * lobe.x + lobe.y;
                    vec3 diffuse = m.color * (1.0 - m.metalness) * (1.0 - mirrors) * environmentAround(n) * open;
                    color += share * (diffuse + lit);
#ifdef GLOWS
                    color += share * (m.emission * m.color);
#endif
                    ended = true;
#ifdef MIRRORS
                    ended = i >= most || bounces >= stage.bounces || m.roughness > ROUGHEST_MIRROR || max(mirrors.r, max(mirrors.g, mirrors.b)) * max(share.r, max(share.g, share.b)) < 0.01;
#endif
                    share *= mirrors;
                    // Shapes that would occlude the reflection only darken it.
                    if (ended) imageShare = share * mix(1.0, open, 0.8);
                    bounces += 1;
                    spread += 2.0 * width * hit.curvature;
                    roughness = max(roughness, m.roughness);
                    origin = hit.position + n * (2.0 * hit.tolerance);
                    direction = image;
                    settings.side = side;
                }
#ifdef GLASS
                // Traces through glass, and then the reflection at its first side; later sides reflect only the
                // environment.
                else {
                    float index = side > 0.0 ? m.refractiveIndex : 1.0 / m.refractiveIndex;
                    float mirrored = fresnelDielectric(cosine, index);
                    vec3 through = refract(direction, n, 1.0 / index);
                    bool total = dot(through, through) < 0.5;
                    if (side > 0.0) {
                        color += share * lit;
                        vec3 reflected = share * mirrored;
                        bool follows = !waited && bounces < stage.bounces && m.roughness <= ROUGHEST_MIRROR && max(reflected.r, max(reflected.g, reflected.b)) >= 0.01;
                        if (follows) {
                            waits = true;
                            waited = true;
                            waitingOrigin = hit.position + n * (2.0 * hit.tolerance);
                            waitingDirection = image;
                            waitingShare = reflected;
                            waitingTraveled = hit.traveled;
                            waitingWidth = width;
                            waitingSpread = spread + 2.0 * width * hit.curvature;
                        } else {
                            imageShare = reflected;
                        }
                    }
                    if (total) {
                        direction = image;
                    } else {
                        share *= 1.0 - mirrored;
                        direction = through;
                        side = -side;
                    }
                    origin = hit.position + n * ((total ? 2.0 : -2.0) * hit.tolerance);
                    settings.side = side;
                    if (i == most) color += share * environmentAround(direction);
                }
#endif
            }
        }
        // Looked up at one place of the code: a SIMD processor without branches would pay for a second one.
        bool looksAlong = max(alongShare.r, max(alongShare.g, alongShare.b)) > 0.0;
        bool looksAtImage = max(imageShare.r, max(imageShare.g, imageShare.b)) > 0.0;
        while (looksAlong || looksAtImage) {
            color += (looksAlong ? alongShare : imageShare) * beyond(looksAlong ? along : image, looksAlong ? alongRoughness : imageRoughness);
            if (looksAlong) looksAlong = false;
            else looksAtImage = false;
        }
    }
#ifdef GLASS
    if (waits) color += waitingShare * beyond(waitingDirection, roughness);
#endif
    seen.radiance = color * stage.exposure;
    return seen;
}

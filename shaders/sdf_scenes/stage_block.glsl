// What stands around the shapes of a scene at one moment. GLSL and C++: render/glsl/std140.h.
#define SCENE_MOST_LIGHTS 24

// Kinds of lights.
#define SCENE_POINT 0
#define SCENE_SUN 1
#define SCENE_AREA 2

#define SCENE_STAGE_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, boxLow)               /* holds all that is solid */ \
    FIELD(float, farthest)            /* no ray goes on from here, meters */ \
    FIELD(float, largestNormalStep)   /* limit of the row normalStep, meters: a small scene is seen from near */ \
    FIELD(vec3, boxHigh) \
    FIELD(float, exposure)            /* of the picture; not as in the source */ \
    FIELD(vec3, zenith)               /* the sky: radiance from above, ... */ \
    FIELD(float, environmentRotation) /* of the panorama about the y axis, radians */ \
    FIELD(vec3, horizon)              /* ... around ... */ \
    FIELD(float, environmentBrightness) /* its factor */ \
    FIELD(vec3, ground)               /* ... and below */ \
    FIELD(float, softShadows)         /* the source's factor; 0: hard */ \
    FIELD(vec3, ambient)              /* the source's light from everywhere */ \
    FIELD(float, occlusion)           /* how much of the ambient occlusion, 0 to 1 */ \
    FIELD(int, bounces)               /* mirror images of mirror images */ \
    FIELD(int, lights) \
    ARRAY(vec4, lightPlace, SCENE_MOST_LIGHTS)  /* position, or direction towards a sun; kind */ \
    ARRAY(vec4, lightColor, SCENE_MOST_LIGHTS)  /* point, sun: irradiance / pi (point: at distance 1); area: radiance; tangent of half the sun's angle */ \
    ARRAY(vec4, lightAcross, SCENE_MOST_LIGHTS) /* area: half of one edge ... */ \
    ARRAY(vec4, lightAlong, SCENE_MOST_LIGHTS)  /* ... and of the other one */
BLOCK_STRUCT(SceneStage, SCENE_STAGE_FIELDS)

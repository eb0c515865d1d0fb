// Environment and lights of a scene at one moment. GLSL and C++: render/glsl/std140.h.
#define SCENE_MOST_LIGHTS 24

// Kinds of lights.
#define SCENE_POINT 0
#define SCENE_SUN 1
#define SCENE_AREA 2

#define SCENE_STAGE_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, boxLow)               /* box around all solids */ \
    FIELD(float, farthest)            /* length at which rays end, meters */ \
    FIELD(float, largestNormalStep)   /* limit of the parameter normalStep, meters, for small scenes seen up close */ \
    FIELD(vec3, boxHigh) \
    FIELD(float, exposure)            /* exposure of the picture; unused by the reference's shading */ \
    FIELD(vec3, zenith)               /* the sky: radiance from above, ... */ \
    FIELD(float, environmentRotation) /* rotation of the panorama around the y axis, radians */ \
    FIELD(vec3, horizon)              /* ... around ... */ \
    FIELD(float, environmentBrightness) /* its brightness */ \
    FIELD(vec3, ground)               /* ... and below */ \
    FIELD(float, softShadows)         /* factor of the reference; 0: hard */ \
    FIELD(vec3, ambient)              /* ambient light of the reference */ \
    FIELD(float, occlusion)           /* strength of the ambient occlusion, 0 to 1 */ \
    FIELD(int, bounces)               /* number of reflections of reflections */ \
    FIELD(int, lights) \
    FIELD(int, loops)                 /* loop iterations in one evaluation of the field */ \
    ARRAY(vec4, lightPlace, SCENE_MOST_LIGHTS)  /* position, or direction towards a sun; kind */ \
    ARRAY(vec4, lightColor, SCENE_MOST_LIGHTS)  /* irradiance / pi (point: at distance 1); area: radiance; w: tangent of half the sun's angle */ \
    ARRAY(vec4, lightAcross, SCENE_MOST_LIGHTS) /* area: half of one edge ... */ \
    ARRAY(vec4, lightAlong, SCENE_MOST_LIGHTS)  /* ... and of the other one */
BLOCK_STRUCT(SceneStage, SCENE_STAGE_FIELDS)

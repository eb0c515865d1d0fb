// The local lights of a frame. GLSL and C++: render/glsl/std140.h.
#define MOST_LOCAL_LIGHTS 32

// One of them: a point, or a sphere of even radiance.
#define LOCAL_LIGHT_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, position)     /* world space, meters */ \
    FIELD(float, radius)      /* of the sphere, meters; 0: a point */ \
    FIELD(vec3, intensity)    /* radiant intensity, W/sr: of a sphere pi radius^2 times its radiance */ \
    FIELD(float, range)       /* meters: beyond, it is not seen; 0: no end */ \
    FIELD(bool, castsShadow)  /* it has shadow maps */ \
    FIELD(int, firstLayer)    /* of its six layers in the shadow maps */ \
    FIELD(float, nearPlane)   /* of these maps, meters */ \
    FIELD(vec3, axis)         /* of the cone that it shines in, unit */ \
    FIELD(float, coneCosine)  /* of half the angle within which it has all its intensity */ \
    FIELD(float, coneScale)   /* 1 over what the cosine falls by until it has none; 0: no cone */ \
    FIELD(float, nearest)     /* meters: surfaces nearer than this get the irradiance of this distance; 0: no limit */
BLOCK_STRUCT(LocalLightEntry, LOCAL_LIGHT_FIELDS)

#define LOCAL_LIGHTS_FIELDS(FIELD, ARRAY) \
    FIELD(int, count) \
    ARRAY(LocalLightEntry, lights, MOST_LOCAL_LIGHTS)  /* the first `count` of them */
BLOCK_STRUCT(LocalLightsBlock, LOCAL_LIGHTS_FIELDS)

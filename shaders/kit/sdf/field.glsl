// Placeholder for the exhibit's field: `SdfShaders::field` of exhibits/kit/sdf_exhibit.h replaces this file. It defines
//     float fieldDistance(vec3 p);  // meters, negative inside, 1-Lipschitz, in the body's own space
// and may set fieldPart in it, and define FIELD_LEVEL and FIELD_CLEARANCE (lib/sphere_tracing.glsl).
#error "no exhibit has put its field here"

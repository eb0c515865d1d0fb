// Placeholder for the shading of the exhibit's field: `SdfShaders::shading` of exhibits/kit/sdf_exhibit.h replaces this
// file. It defines
//     vec3 exhibitLight(Surface s, Hit hit, vec3 toEye);                  // added to the hall's light, on any surface
//     vec3 fieldRadiance(LocalRay ray, Hit hit, MarchSettings settings);  // radiance along the camera ray
// by the functions of kit/sdf/shade.glsl.
#error "no exhibit has put its shading here"

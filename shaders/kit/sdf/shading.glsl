// The shading of the exhibit's field: `SdfShaders::shading` of exhibits/kit/sdf_exhibit.h takes the place of this file. It
// defines
//     vec3 exhibitLight(Surface s, Hit hit, vec3 toEye);                          // light beside the hall's, on any surface
//     vec3 fieldRadiance(LocalRay ray, Hit hit, MarchSettings settings);  // what the eye's ray sees
// by the means of kit/sdf/shade.glsl.
#error "no exhibit has put its shading here"

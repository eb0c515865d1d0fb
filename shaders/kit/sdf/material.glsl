// Placeholder for the material of the exhibit's field: `SdfShaders::material` of exhibits/kit/sdf_exhibit.h replaces
// this file. It defines
//     FieldMaterial fieldMaterial(vec3 p);  // of a point of the surface, in the body's own space
// with the fields of FieldMaterial in kit/sdf/object.glsl.
#error "no exhibit has put its material here"

// Binding numbers that shaders and C++ share. Only macros, so that both languages can include this.

// Macros for the files *_block.glsl, which list the fields of a uniform block. C++ has others: see
// render/glsl/std140.h.
#ifndef __cplusplus
#define BLOCK_STRUCT(name, FIELDS) struct name { FIELDS(BLOCK_FIELD, BLOCK_ARRAY) };
#define BLOCK_FIELD(type, name) type name;
#define BLOCK_ARRAY(type, name, count) type name[count];
#endif

// std140 blocks.
#define BLOCK_FRAME 0
#define BLOCK_PARAMETERS 1
#define BLOCK_OBJECT 2
#define BLOCK_LIGHT 3
#define BLOCK_TEMPORAL 4
#define BLOCK_LOCAL_LIGHTS 5
#define BLOCK_EXHIBIT 6  // Data common to all draws of an exhibit.

// std430 buffers.
#define STORAGE_INSTANCES 0
#define STORAGE_EXHIBIT_A 1

// Texture units.
#define UNIT_BASE_COLOR 0
#define UNIT_NORMAL 1
#define UNIT_ORM 2
#define UNIT_EMISSIVE 3
#define UNIT_SKY_LIGHTMAP 4
#define UNIT_BOUNCED_LIGHT 5
#define UNIT_SHADOW_HALL 6
#define UNIT_SHADOW_EXHIBITS 7
#define UNIT_PROBE 8
#define UNIT_PROBE_IRRADIANCE 9
#define UNIT_ENVIRONMENT 10
#define UNIT_FONT 11
#define UNIT_SOURCE 12
#define UNIT_EXHIBIT_A 13
#define UNIT_EXHIBIT_B 14
#define UNIT_EXHIBIT_C 15
#define UNIT_LOCAL_SHADOWS 16
#define UNIT_AIR_LIGHT 17
#define UNIT_BACKDROP 18
#define UNIT_BACKDROP_DEPTH 19
#define UNIT_SHADOW_GLASS 20
#define UNIT_OCCLUSION 21
// Buffer textures. Software renderers read a storage buffer component by component for each pixel, texels at once.
#define UNIT_BUFFER_A 22
#define UNIT_BUFFER_B 23
#define UNIT_BUFFER_C 24

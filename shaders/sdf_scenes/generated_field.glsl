// Placeholder: the GLSL generated for a scene replaces this file (exhibits/sdf_scenes/scene_glsl.h).
#error "no scene was given"

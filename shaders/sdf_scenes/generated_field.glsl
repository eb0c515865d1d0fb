// In place of this file stands the text that is made of a scene (exhibits/sdf_scenes/scene_glsl.h).
#error "no scene was given"

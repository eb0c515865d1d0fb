#version 120
#ifdef GL_ES
precision highp float;
#endif
uniform float u_size; // 0.1 .. 2, default 0.5, exact 1, m, "Size"
uniform vec3 u_tint; // color
uniform vec2 u_resolution;
#define STEPS 64 // 8 .. 512
#if defined(BUFFER_0)
#endif
varying vec2 uv;
void main() { float sample = u_size; gl_FragColor = vec4(u_tint * sample, 1.0); }

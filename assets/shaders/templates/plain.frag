// A plain fragment shader, as glslViewer and The Book of Shaders have them. A comment behind a uniform, a #define or a
// const gives its range and makes a slider: lowest .. highest, default, unit, "label".
#ifdef GL_ES
precision highp float;
#endif

uniform vec2 u_resolution; // size of the picture, in pixels
uniform vec2 u_mouse;      // in pixels
uniform float u_time;      // seconds

uniform float u_rings; // 1 .. 40, default 12, "Rings"
uniform vec3 u_tint;   // color

void main()
{
    vec2 p = (2.0 * gl_FragCoord.xy - u_resolution) / u_resolution.y;
    float wave = 0.5 + 0.5 * cos(u_rings * length(p) - 2.0 * u_time);
    gl_FragColor = vec4(wave * u_tint, 1.0);
}

/*{
    "ISFVSN": "2",
    "DESCRIPTION": "Begin here: inputs in this head become sliders.",
    "CATEGORIES": ["Generator"],
    "INPUTS": [
        {"NAME": "rings", "LABEL": "Rings", "TYPE": "float", "MIN": 1.0, "MAX": 40.0, "DEFAULT": 12.0},
        {"NAME": "tint", "LABEL": "Tint", "TYPE": "color", "DEFAULT": [1.0, 0.8, 0.5, 1.0]},
        {"NAME": "center", "LABEL": "Center", "TYPE": "point2D", "MIN": [0.0, 0.0], "MAX": [1.0, 1.0], "DEFAULT": [0.5, 0.5]}
    ]
}*/

void main()
{
    vec2 p = 2.0 * (isf_FragNormCoord - center) * vec2(RENDERSIZE.x / RENDERSIZE.y, 1.0);
    float wave = 0.5 + 0.5 * cos(rings * length(p) - 2.0 * TIME);
    gl_FragColor = vec4(wave * tint.rgb, 1.0);
}

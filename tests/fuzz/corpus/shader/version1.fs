/*{"PERSISTENT_BUFFERS": ["a"], "PASSES": [{"TARGET": "a"}, {}]}*/
varying vec2 left;
void main() { gl_FragColor = texture2D(a, vv_FragNormCoord + left); }

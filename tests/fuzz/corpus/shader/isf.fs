/*{"ISFVSN": "2", "INPUTS": [{"NAME": "size", "TYPE": "float", "MIN": 0, "MAX": 2, "DEFAULT": 0.5},
 {"NAME": "mode", "TYPE": "long", "VALUES": [0, 2], "LABELS": ["a", "b"]}, {"NAME": "inputImage", "TYPE": "image"}],
 "IMPORTED": {"mask": {"PATH": "mask.png"}},
 "PASSES": [{"TARGET": "last", "PERSISTENT": true, "WIDTH": "floor($WIDTH/2)"}, {}]}*/
void main() { gl_FragColor = IMG_THIS_PIXEL(last) * size; }

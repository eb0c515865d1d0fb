// Shapes that were asked for this pixel: counted for whoever defines COUNT_SHAPES.
int shapesAsked = 0;
#ifdef COUNT_SHAPES
#define SCENE_ASKED(isShape) shapesAsked += (isShape) ? 1 : 0;
#else
#define SCENE_ASKED(isShape)
#endif

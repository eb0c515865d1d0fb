// Counter of primitive evaluations for this pixel; active with COUNT_SHAPES.
int shapesAsked = 0;
#ifdef COUNT_SHAPES
#define SCENE_ASKED(isShape) shapesAsked += (isShape) ? 1 : 0;
#else
#define SCENE_ASKED(isShape)
#endif

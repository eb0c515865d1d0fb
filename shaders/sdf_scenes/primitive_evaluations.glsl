// Counter of primitive evaluations for this pixel; active with COUNT_SHAPES.
int primitiveEvaluations = 0;
#ifdef COUNT_SHAPES
#define COUNT_EVALUATION(isShape) primitiveEvaluations += (isShape) ? 1 : 0;
#else
#define COUNT_EVALUATION(isShape)
#endif

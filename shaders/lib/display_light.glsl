// Alpha of a pixel whose color is display light already: a debug view, or a data plot. The tone curve leaves it as it
// is, because no scene light of 0 or more maps to saturated bright display colors.
const float DISPLAY_LIGHT = 2.0;

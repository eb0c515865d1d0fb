#pragma once

class QWidget;

namespace vitrine::ui {

class Viewport;

/// If VITRINE_FIRST_PICTURE is set, closes the window once it shows all that is in view. Prints the times of the first
/// and the complete picture: "first picture at 12.345678 s, 640x360" and "all at 12.456789 s" (render::wallSeconds).
/// Used by tests/bench/window_start.cpp.
void reportFirstPicture(Viewport&, QWidget& window);

}  // namespace vitrine::ui

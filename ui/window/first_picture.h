#pragma once

class QWidget;

namespace vitrine::ui {

class Viewport;

/// Where VITRINE_FIRST_PICTURE is set, closes the window as soon as its first picture is on the screen, and says on
/// standard output when that was: "first picture at 12.345678 s, 640x360", by render::wallSeconds. For
/// tests/bench/window_start.cpp.
void reportFirstPicture(Viewport&, QWidget& window);

}  // namespace vitrine::ui

#pragma once

class QWidget;

namespace vitrine::ui {

class Viewport;

/// Where VITRINE_FIRST_PICTURE is set, closes the window as soon as it shows all that is in view, and says on standard
/// output when that was, and when its first picture was on the screen: "first picture at 12.345678 s, 640x360" and
/// "all at 12.456789 s", by render::wallSeconds. For tests/bench/window_start.cpp.
void reportFirstPicture(Viewport&, QWidget& window);

}  // namespace vitrine::ui

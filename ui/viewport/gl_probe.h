#pragma once

#include <QString>

namespace vitrine::ui {

/// Makes an offscreen context as the viewport would. Returns an empty text when it is OpenGL 4.5 core or
/// newer, else one sentence for people. To be asked before any QOpenGLWidget exists: on Qt 6.4 one without
/// a context crashes. Needs a QGuiApplication.
[[nodiscard]] QString whyNoOpenGl();

}  // namespace vitrine::ui

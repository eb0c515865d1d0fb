#pragma once

#include <QString>

namespace vitrine::ui {

/// Makes an offscreen context as the viewport would. Returns an empty text if it is OpenGL 4.5 core or newer, otherwise
/// one sentence for people. Call it before any QOpenGLWidget is made: on Qt 6.4 one without a context crashes. Requires
/// a QGuiApplication.
[[nodiscard]] QString whyNoOpenGl();

}  // namespace vitrine::ui

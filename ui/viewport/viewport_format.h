#pragma once

#include <QSurfaceFormat>

namespace vitrine::ui {

/// Returns the format of all OpenGL contexts of the window: OpenGL 4.5 core, with a debug context in debug builds.
[[nodiscard]] QSurfaceFormat viewportFormat();

}  // namespace vitrine::ui

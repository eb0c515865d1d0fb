#pragma once

#include <QSurfaceFormat>

namespace vitrine::ui {

/// The format every context of the window asks for: OpenGL 4.5 core, with a debug context in debug builds.
[[nodiscard]] QSurfaceFormat viewportFormat();

}  // namespace vitrine::ui

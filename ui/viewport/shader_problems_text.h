#pragma once

#include "render/gl/renderer.h"

#include <QString>

#include <vector>

namespace vitrine::ui {

/// What the picture says over itself while shaders do not build, a line for each problem; empty for none.
[[nodiscard]] QString shaderProblemsText(const std::vector<render::gl::ShaderProblem>&);

}  // namespace vitrine::ui

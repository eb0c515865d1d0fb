#pragma once

#include "render/gl/renderer.h"

#include <QString>

#include <vector>

namespace vitrine::ui {

/// Returns the text shown over the picture while shaders do not build: a line for each problem; empty if there are
/// none.
[[nodiscard]] QString shaderProblemsText(const std::vector<render::gl::ShaderProblem>&);

}  // namespace vitrine::ui

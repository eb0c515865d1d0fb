#pragma once

#include <glm/glm.hpp>

#include <QColor>

namespace vitrine::ui {

/// Returns linear Rec. 709 in the sRGB encoding of screens; components are clamped to 0 to 1.
[[nodiscard]] QColor encoded(const glm::dvec3& linear);
/// Returns a color of screens in linear Rec. 709.
[[nodiscard]] glm::dvec3 linear(const QColor&);

}  // namespace vitrine::ui

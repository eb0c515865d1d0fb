#pragma once

#include "ui/compare/compare_mode.h"

#include <QImage>

namespace vitrine::ui {

/// Returns the difference of two screen pictures, with A as the reference: a FLIP heat map, white at 1/gain, or the
/// signed difference times `gain` (`render::signedDifference`). A is scaled to the size of B. `mode` must be one of the
/// differences. Thread-safe.
[[nodiscard]] QImage differenceImage(const QImage& a, const QImage& b, CompareMode mode, int gain);

}  // namespace vitrine::ui

#pragma once

#include "ui/compare/compare_mode.h"

#include <QImage>

namespace vitrine::ui {

/// Where and how two pictures of the screen differ, A being the reference: the heat map of FLIP, white at 1/gain, or
/// the signed difference times `gain` (`render::signedDifference`). Of pictures of two sizes, A is scaled to that of B.
/// `mode` is one of the differences; any thread may call it.
[[nodiscard]] QImage differenceImage(const QImage& a, const QImage& b, CompareMode mode, int gain);

}  // namespace vitrine::ui

#pragma once

#include <QElapsedTimer>
#include <QString>

namespace vitrine::ui {

/// Estimates the seconds until work is done, of which `part` (0 to 1) is done since the clock started. Negative: not
/// known yet.
[[nodiscard]] double secondsLeft(double part, const QElapsedTimer& since);

/// Formats a time: "About 12 s left", or "About 3 min left".
[[nodiscard]] QString timeLeft(double seconds);

}  // namespace vitrine::ui

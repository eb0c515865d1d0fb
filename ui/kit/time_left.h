#pragma once

#include <QElapsedTimer>
#include <QString>

namespace vitrine::ui {

/// Seconds that work takes which has done `part` (0 to 1) of itself since the clock started; negative: not known yet.
[[nodiscard]] double secondsLeft(double part, const QElapsedTimer& since);

/// "About 12 s left", or "About 3 min left".
[[nodiscard]] QString timeLeft(double seconds);

}  // namespace vitrine::ui

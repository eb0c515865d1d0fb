#include "ui/kit/time_left.h"

#include <QObject>

#include <cmath>

namespace vitrine::ui {

double secondsLeft(double part, const QElapsedTimer& since)
{
    const double seconds = static_cast<double>(since.elapsed()) / 1000;
    return part > 0.02 ? seconds / part * (1 - part) : -1;
}

QString timeLeft(double seconds)
{
    const int whole = static_cast<int>(std::ceil(seconds));
    return whole < 90 ? QObject::tr("About %1 s left").arg(whole)
                      : QObject::tr("About %1 min left").arg((whole + 30) / 60);
}

}  // namespace vitrine::ui

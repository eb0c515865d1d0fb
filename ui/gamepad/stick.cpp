#include "ui/gamepad/stick.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

double response(double way, double rests)
{
    const double beyond = std::clamp((way - rests) / (stickIsFull - rests), 0.0, 1.0);
    return beyond * beyond;
}

}  // namespace

Push pushOf(double x, double y)
{
    const double way = std::hypot(x, y);
    if (!(way > stickRests)) return {};
    const double push = response(way, stickRests) / way;
    return {x * push, y * push};
}

double pullOf(double trigger)
{
    return trigger > triggerRests ? response(trigger, triggerRests) : 0;
}

}  // namespace vitrine::ui

#include "ui/viewport/moving_region.h"

#include <algorithm>

namespace vitrine::ui {
namespace moving_regions {
namespace {

constexpr double rest = 5;             // Pause after a drawing, as a multiple of its time ...
constexpr double shortestRest = 0.03;  // ... and at least, in seconds.

}  // namespace
}  // namespace moving_regions

void MovingRegion::set(std::optional<PictureRegion> part)
{
    part_ = part;
    if (!part_) isDue_ = moved_ = false;
}

void MovingRegion::passTick(bool moves, bool changed)
{
    isDue_ = isDue_ || moves || moved_ || changed;
    moved_ = moves;
}

double MovingRegion::wait(double now) const
{
    return std::max(restsUntil_ - now, moving_regions::shortestRest);
}

void MovingRegion::drawn(double now, double seconds)
{
    restsUntil_ = now + std::max(moving_regions::rest * seconds, moving_regions::shortestRest);
}

}  // namespace vitrine::ui

#include "ui/viewport/adaptive_scale.h"

namespace vitrine::ui {
namespace adaptive_scales {
namespace {

// Resolution drops as soon as a frame takes `late` times the target. It rises only after `framesBeforeFiner` frames
// whose predicted time at the finer level is below `room` times the target, so that it does not oscillate.
constexpr double late = 1.3;
constexpr double room = 0.7;
constexpr int framesBeforeFiner = 4;

}  // namespace
}  // namespace adaptive_scales

void AdaptiveScale::setLeast(double scale)
{
    least_ = scale;
    while (level_ > 0 && scales[level_] < least_) --level_;
}

bool AdaptiveScale::canBeCoarser() const
{
    return level_ + 1 < scales.size() && scales[level_ + 1] >= least_;
}

void AdaptiveScale::drawn(double scale, double seconds)
{
    using namespace adaptive_scales;
    const double perPixelShare = seconds / (scale * scale);
    const auto predicted = [&](std::size_t level) { return perPixelShare * scales[level] * scales[level]; };
    if (scale == scales[level_] && seconds > late * targetTime) {
        while (canBeCoarser() && predicted(level_) > targetTime) ++level_;
        fastFrames_ = 0;
    } else if (level_ > 0 && predicted(level_ - 1) < room * targetTime) {
        if (++fastFrames_ < framesBeforeFiner) return;
        --level_;
        fastFrames_ = 0;
    } else {
        fastFrames_ = 0;
    }
}

}  // namespace vitrine::ui

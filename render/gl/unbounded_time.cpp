#include "render/gl/unbounded_time.h"

#include <algorithm>

namespace vitrine::render::gl {
namespace {

constexpr double bandSeconds = 0.1;
constexpr int softwarePixels = 16384;  // Largest band of a software renderer.

}  // namespace

void UnboundedTime::beginFrame()
{
    used_ = 0;
    if (!isOver_) lateOnce_.clear();
    isOver_ = false;
    band_.reset();  // The last frame may have been abandoned within a pass.
}

std::optional<glm::ivec2> UnboundedTime::nextBand(glm::ivec2 size)
{
    const double now = clocks_.wall();
    ThreadTimes threads = software_ ? clocks_.threads() : ThreadTimes();
    int row = 0;
    int rows = software_ ? 1 : std::max(size.y / 4, 1);
    if (band_) {
        const double seconds = now - begun_;
        used_ += withoutWaiting(seconds, begunThreads_, threads);
        row = band_->y;
        const int drawn = band_->y - band_->x;
        const double inTime = drawn * bandSeconds / std::max(seconds, 1e-9);
        const int most = software_ ? std::min(4 * drawn, std::max(softwarePixels / std::max(size.x, 1), 1)) : rows;
        rows = static_cast<int>(std::clamp(inTime, 1.0, static_cast<double>(most)));
    }
    band_.reset();
    isOver_ = row < size.y && used_ > limit_;
    if (row >= size.y || isOver_) return std::nullopt;
    begun_ = now;
    begunThreads_ = std::move(threads);
    band_ = glm::ivec2(row, std::min(row + rows, size.y));
    return band_;
}

bool UnboundedTime::isTooSlow(std::uint64_t passes)
{
    return !begunThreads_.empty() || !lateOnce_.insert(passes).second;
}

}  // namespace vitrine::render::gl

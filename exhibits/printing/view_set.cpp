#include "exhibits/printing/view_set.h"

#include "render/failure.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::printing {
namespace {

/// A view larger than this share (1/n) of the memory goes to disk at once, since it is in memory anyway while it is
/// read.
constexpr std::size_t largestShare = 4;

std::uint16_t code(double linear)
{
    return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(linear, 0.0, 1.0)));
}

/// Computes row `y` of `height` from the rows of the image, box-filtered, or interpolated when enlarging.
void resampledRow(const render::Image& image, int y, int height, std::vector<double>& out)
{
    const double scale = static_cast<double>(image.height) / height;
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    std::fill(out.begin(), out.end(), 0.0);
    const auto add = [&](int from, double weight) {
        const float* at = image.pixels.data() + static_cast<std::size_t>(std::clamp(from, 0, image.height - 1)) * row;
        for (std::size_t i = 0; i < row; ++i) out[i] += weight * static_cast<double>(at[i]);
    };
    if (scale <= 1) {
        const double at = (y + 0.5) * scale - 0.5;
        const int first = static_cast<int>(std::floor(at));
        if (at > first) add(first + 1, at - first);
        add(first, 1 - (at - first));
        return;
    }
    const double from = y * scale;
    const double to = from + scale;
    for (int r = static_cast<int>(from); r < to && r < image.height; ++r)
        add(r, (std::min<double>(to, r + 1) - std::max<double>(from, r)) / scale);
}

}  // namespace

void ViewSet::add(const render::Image& image)
{
    if (image.width < 1 || image.height < 1 || image.channels < 1)
        throw Failure(ErrorKind::file, "A view is empty; choose another picture.");
    if (height_ == 0) height_ = image.height;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t rowSamples = static_cast<std::size_t>(image.width) * 3;
    const std::size_t samples = rowSamples * static_cast<std::size_t>(height_) + behind;
    const bool onDisk = scratch_ || samples * 2 > memory_ / largestShare || samples * 2 > memory_ - used_;
    if (onDisk && !scratch_) {
        scratch_ = std::make_shared<render::ScratchFile>();
        firstOnDisk_ = views_.size();
    }
    const std::uint64_t begin = onDisk ? scratch_->size() : 0;
    auto kept = onDisk ? nullptr : std::make_shared<std::vector<std::uint16_t>>(samples);
    std::vector<std::uint16_t> passing(onDisk ? rowSamples : 0);
    std::vector<double> row(static_cast<std::size_t>(image.width) * channels);
    const bool gray = channels < 3;
    const std::size_t alphaAt = channels == 2 ? 1 : channels == 4 ? 3 : channels;
    for (int y = 0; y < height_; ++y) {
        resampledRow(image, y, height_, row);
        std::uint16_t* out = onDisk ? passing.data() : kept->data() + static_cast<std::size_t>(y) * rowSamples;
        for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x, out += 3) {
            const double* pixel = row.data() + x * channels;
            const double alpha = alphaAt < channels ? std::clamp(pixel[alphaAt], 0.0, 1.0) : 1.0;
            for (std::size_t c = 0; c < 3; ++c) out[c] = code(pixel[gray ? 0 : c] * alpha + (1 - alpha));
        }
        if (onDisk) scratch_->append(passing.data(), rowSamples * 2);
    }
    if (!onDisk) {
        used_ += samples * 2;
        views_.push_back({image.width, {kept, kept->data()}});
        return;
    }
    const std::array<std::uint16_t, behind> unused{};
    scratch_->append(unused.data(), sizeof unused);
    scratch_->align();
    const auto* mapped = static_cast<const std::uint16_t*>(scratch_->map(begin, samples * 2));
    views_.push_back(
        {image.width, {mapped, [samples](const std::uint16_t* at) { render::unmapPages(at, samples * 2); }}});
}

void ViewSet::rowIsRead(int y) const
{
    for (std::size_t k = firstOnDisk_; k < views_.size(); ++k) {
        const std::size_t row = static_cast<std::size_t>(views_[k].width) * 6;
        render::releasePages(views_[k].samples.get(), row * static_cast<std::size_t>(height_),
                             row * static_cast<std::size_t>(y), row);
    }
}

void ViewSet::allIsRead() const
{
    for (std::size_t k = firstOnDisk_; k < views_.size(); ++k) {
        const std::size_t all = static_cast<std::size_t>(views_[k].width) * 6 * static_cast<std::size_t>(height_);
        render::releasePages(views_[k].samples.get(), all, 0, all);
    }
}

std::string stretchWarning(const PrintLayout& layout, const ViewSet& views)
{
    const PrintSettings& s = layout.settings();
    const double wanted = (s.width + 2 * s.bleed) / (s.height + 2 * s.bleed);
    for (int k = 0; k < views.count(); ++k) {
        const double shape = static_cast<double>(views.view(k).width) / views.height();
        if (shape / wanted > 1.02 || shape / wanted < 0.98)
            return "The views are not shaped as the print is and are stretched to it.";
    }
    return {};
}

}  // namespace vitrine::printing

#include "render/measure/distance.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

/// Copies the channels of one pixel into a picture of one pixel.
Image pixelOf(const Image& image, int x, int y, int first, int count)
{
    Image pixel(1, 1, count);
    for (int c = 0; c < count; ++c) pixel.at(0, 0, c) = image.at(x, y, first + c);
    return pixel;
}

/// Returns the index of a channel that both pictures have at the same index; -1 otherwise.
int sharedChannel(const Image& a, const Image& b, std::string_view name)
{
    const int channel = channelNamed(a, name);
    return channel == channelNamed(b, name) ? channel : -1;
}

}  // namespace

int channelNamed(const Image& image, std::string_view name)
{
    const auto found = std::find(image.channelNames.begin(), image.channelNames.end(), name);
    return found == image.channelNames.end() ? -1 : static_cast<int>(found - image.channelNames.begin());
}

std::optional<double> distance(Metric metric, const Image& reference, const Image& test, double pixelsPerDegree)
{
    switch (metric) {
    case Metric::rmse: return colorDifference(reference, test).rmse;
    case Metric::psnr: return colorDifference(reference, test).psnr();
    case Metric::max: return colorDifference(reference, test).max;
    case Metric::beyond: return colorDifference(reference, test).beyond;
    case Metric::flip: return flip(reference, test, pixelsPerDegree);
    case Metric::normal: {
        const int first = sharedChannel(reference, test, "normal.X");
        return first < 0 ? std::nullopt : std::optional(normalDifference(reference, test, first).mean);
    }
    case Metric::depth: {
        const int channel = sharedChannel(reference, test, "depth.Z");
        return channel < 0 ? std::nullopt : std::optional(depthDifference(reference, test, channel).rms);
    }
    }
    return std::nullopt;
}

std::optional<Image> errorMap(Metric metric, const Image& reference, const Image& test, double pixelsPerDegree)
{
    if (metric == Metric::flip) return flipMap(reference, test, pixelsPerDegree);
    if (metric != Metric::normal && metric != Metric::depth) return differenceMap(reference, test);
    const bool normals = metric == Metric::normal;
    const int channel = sharedChannel(reference, test, normals ? "normal.X" : "depth.Z");
    if (channel < 0) return std::nullopt;
    Image map(reference.width, reference.height, 1);
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const Image a = pixelOf(reference, x, y, channel, normals ? 3 : 1);
            const Image b = pixelOf(test, x, y, channel, normals ? 3 : 1);
            const NormalDifference n = normals ? normalDifference(a, b, 0) : NormalDifference{};
            const DepthDifference d = normals ? DepthDifference{} : depthDifference(a, b, 0);
            map.at(x, y) = n.missing + d.missing > 0 ? INFINITY : static_cast<float>(n.mean + d.rms);
        }
    }
    return map;
}

double fullScale(Metric metric, const Image& errors)
{
    if (metric == Metric::flip) return 1;
    double largest = 0;
    for (const float e : errors.pixels)
        if (std::isfinite(e)) largest = std::max(largest, static_cast<double>(e));
    return largest > 0 ? largest : 1;
}

bool isBeyond(Metric metric, double value, double limit)
{
    return metric == Metric::psnr ? value < limit : value > limit;
}

}  // namespace vitrine::render

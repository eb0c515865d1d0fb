#include "exhibits/printing/fitting.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

double shapeOf(const render::Image& image)
{
    return static_cast<double>(image.width) / image.height;
}

/// The part of `width` x `height` pixels around the middle; white where that is larger than the picture.
render::Image middle(const render::Image& image, int width, int height)
{
    render::Image out(width, height, image.channels, 1);
    const int left = (width - image.width) / 2;
    const int top = (height - image.height) / 2;
    const int first = std::max(0, -left);
    const int count = std::min(image.width, width);
    for (int y = std::max(0, top); y < std::min(height, top + image.height); ++y) {
        const float* from = image.pixels.data() + image.index(first, y - top);
        std::copy_n(from, static_cast<std::size_t>(count) * static_cast<std::size_t>(image.channels),
                    out.pixels.data() + out.index(left + first, y));
    }
    return out;
}

}  // namespace

double aspectOf(const PrintSettings& s)
{
    return (s.width + 2 * s.bleed) / (s.height + 2 * s.bleed);
}

render::Image fitted(render::Image image, double aspect, Fitting fitting)
{
    constexpr int most = 65536;
    if (fitting == Fitting::stretch || image.width < 1 || image.height < 1) return image;
    const auto pixels = [](double x) { return static_cast<int>(std::clamp(std::round(x), 1.0, double{most})); };
    const bool wide = shapeOf(image) > aspect;
    // Cropping changes the width of a wide picture, margins change its height; for a high one the other way round.
    const bool width = wide == (fitting == Fitting::crop);
    const int newWidth = width ? pixels(image.height * aspect) : image.width;
    const int newHeight = width ? image.height : pixels(image.width / aspect);
    if (newWidth == image.width && newHeight == image.height) return image;
    return middle(image, newWidth, newHeight);
}

std::string fittingNote(const render::Image& image, double aspect, Fitting fitting)
{
    const double ratio = shapeOf(image) / aspect;
    if (fitting == Fitting::stretch || (ratio < 1.02 && ratio > 0.98)) return {};
    const bool sides = (ratio > 1) == (fitting == Fitting::crop);
    const double part = 1 - std::min(ratio, 1 / ratio);
    const std::string percent = std::to_string(std::lround(part * 100));
    if (fitting == Fitting::crop)
        return "The pictures are not shaped as the print is: " + percent + " % of their " +
               (sides ? "width" : "height") + " is cut off.";
    return "The pictures are not shaped as the print is: " + percent + " % of its " + (sides ? "width" : "height") +
           " stays white.";
}

}  // namespace vitrine::printing

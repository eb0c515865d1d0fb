#include "exhibits/printing/fitting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::printing {
namespace {

double shapeOf(const render::Image& image)
{
    return static_cast<double>(image.width) / image.height;
}

/// Returns the central part of `width` x `height` pixels; white where that is larger than the picture.
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

/// Returns a channel of a pixel; white outside the image.
float valueAt(const render::Image& image, int x, int y, int c)
{
    return x < 0 || y < 0 || x >= image.width || y >= image.height ? 1.0F : image.at(x, y, c);
}

/// Cuts or pads an image as `middle` does, then turns and shifts it, with bilinear interpolation. Cost: one sample per
/// output pixel.
render::Image placed(const render::Image& image, int width, int height, const ViewPlace& place)
{
    render::Image out(width, height, image.channels, 1);
    const double turn = place.turn * std::numbers::pi / 180;
    // Without rotation, pixels shifted by whole numbers keep their exact values.
    const double c = place.turn == 0 ? 1 : std::cos(turn);
    const double s = place.turn == 0 ? 0 : std::sin(turn);
    const glm::dvec2 shift = place.shift / 100.0 * glm::dvec2(width, height);
    const glm::dvec2 center = 0.5 * glm::dvec2(width, height);
    const glm::dvec2 corner((width - image.width) / 2, (height - image.height) / 2);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 from = glm::dvec2(x + 0.5, y + 0.5) - center - shift;
            // Clockwise on the screen, since y points down. Pixel centers lie at half-integers.
            const glm::dvec2 at = glm::dvec2(c * from.x + s * from.y, c * from.y - s * from.x) + center - corner - 0.5;
            const glm::dvec2 low = glm::floor(at);
            const glm::dvec2 part = at - low;
            const int left = static_cast<int>(low.x);
            const int top = static_cast<int>(low.y);
            for (int channel = 0; channel < image.channels; ++channel) {
                const auto row = [&](int v) {
                    const double a = valueAt(image, left, v, channel);
                    return part.x == 0 ? a : a + part.x * (valueAt(image, left + 1, v, channel) - a);
                };
                const double a = row(top);
                out.at(x, y, channel) = static_cast<float>(part.y == 0 ? a : a + part.y * (row(top + 1) - a));
            }
        }
    return out;
}

}  // namespace

double aspectOf(const PrintSettings& s)
{
    return (s.width + 2 * s.bleed) / (s.height + 2 * s.bleed);
}

render::Image fitted(render::Image image, double aspect, Fitting fitting, const ViewPlace& place)
{
    constexpr int most = 65536;
    if (image.width < 1 || image.height < 1) return image;
    if (fitting == Fitting::stretch)
        return place == ViewPlace{} ? image : placed(image, image.width, image.height, place);
    const auto pixels = [](double x) { return static_cast<int>(std::clamp(std::round(x), 1.0, double{most})); };
    const bool wide = shapeOf(image) > aspect;
    // Cropping changes the width of a wide picture, and margins change its height; for a high picture it is the
    // reverse.
    const bool width = wide == (fitting == Fitting::crop);
    const int newWidth = width ? pixels(image.height * aspect) : image.width;
    const int newHeight = width ? image.height : pixels(image.width / aspect);
    if (place != ViewPlace{}) return placed(image, newWidth, newHeight, place);
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

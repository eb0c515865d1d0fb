#include "exhibits/printing/proof.h"

#include "exhibits/printing/optics.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"
#include "render/image/rec709.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::printing {
namespace {

struct Ray {
    double theta = 0, beta = 0;
};

/// A lens from one direction, as offsets on the print from the lens's axis at the viewed place.
struct Sight {
    struct Point {
        double across = 0, along = 0;
        float share = 0;
    };
    std::vector<Point> points{};
};

Sight sightOf(const Sheet& sheet, const Ray& ray, int parts)
{
    Sight sight;
    const double sineInside = std::sin(ray.beta) / sheet.index;
    const double inPlane = std::sqrt(1 - sineInside * sineInside);
    for (const Aperture::Part& part : aperture(sheet, ray.theta, ray.beta, parts).parts) {
        const double along = -part.depth * sineInside / (inPlane * std::cos(part.psi));
        sight.points.push_back({(part.from + part.to) / 2, along, static_cast<float>(part.share)});
    }
    return sight;
}

/// Direction to the eye from a place (millimeters from the center, y downwards).
class Viewer {
public:
    Viewer(const PrintLayout& layout, const Eye& eye) : layout_(layout), distance_(eye.distance)
    {
        const bool upright = std::abs(layout.settings().direction) <= 45;
        x_ = std::tan(upright ? eye.angle : eye.angleAlong);
        y_ = upright ? -std::tan(eye.angleAlong) : std::tan(eye.angle);
    }
    [[nodiscard]] Ray from(double x, double y) const
    {
        const double dx = x_ - x / distance_;
        const double dy = y_ - y / distance_;
        const double across = dx * layout_.cosine() + dy * layout_.sine();
        const double along = dy * layout_.cosine() - dx * layout_.sine();
        return {std::atan(across), std::asin(along / std::sqrt(1 + across * across + along * along))};
    }

private:
    const PrintLayout& layout_;
    double distance_;
    double x_ = 0, y_ = 0;
};

void check(const PrintLayout& layout, const Eye& eye)
{
    if (!(std::abs(eye.angle) < 1.5) || !(std::abs(eye.angleAlong) < 1.5))
        throw Failure(ErrorKind::usage, "The eye's angle must lie between -85 and 85 degrees.");
    if (!(eye.distance > layout.settings().sheet.thickness))
        throw Failure(ErrorKind::usage, "The eye must be farther away than the sheet is thick.");
}

/// Implements `lookThrough`. `pixelAt(x, y)` returns three linear samples of the raster.
template <typename PixelAt>
render::Image lookThroughOf(const PrintLayout& layout, const Eye& eye, int apertureParts, const PixelAt& pixelAt)
{
    check(layout, eye);
    const PrintSettings& s = layout.settings();
    const double pitch = s.sheet.pitch();
    const double perMmX = s.dpiX / mmPerInch;
    const double perMmY = s.dpiY / mmPerInch;
    const auto width = static_cast<double>(layout.width());
    const auto height = static_cast<double>(layout.height());
    const auto cells = [&](double pixels, double perMm) {
        return static_cast<int>(std::max(1.0, std::round(pixels / perMm / pitch)));
    };
    render::Image seen(cells(width, perMmX), cells(height, perMmY), 3);
    const Viewer viewer(layout, eye);
    const double finest = std::max(perMmX, perMmY);
    const int alongSteps = std::clamp(static_cast<int>(std::ceil(pitch * finest)), 1, 16);
    const bool far = std::isinf(eye.distance);
    Sight sight;
    if (far) sight = sightOf(s.sheet, viewer.from(0, 0), apertureParts);
    for (int row = 0; row < seen.height; ++row) {
        for (int column = 0; column < seen.width; ++column) {
            double x = (column + 0.5 - 0.5 * seen.width) * pitch;
            double y = (row + 0.5 - 0.5 * seen.height) * pitch;
            // Moves to the axis of the lens that covers this place.
            const double across = x * layout.cosine() + y * layout.sine();
            const double off = std::floor(across / pitch + 0.5) * pitch - across;
            x += off * layout.cosine();
            y += off * layout.sine();
            if (!far) sight = sightOf(s.sheet, viewer.from(x, y), apertureParts);
            std::array<double, 3> sum{};
            for (int step = 0; step < alongSteps; ++step) {
                const double slide = ((step + 0.5) / alongSteps - 0.5) * pitch;
                for (const Sight::Point& point : sight.points) {
                    const double along = slide + point.along;
                    const double px =
                        (x + point.across * layout.cosine() - along * layout.sine()) * perMmX + 0.5 * width;
                    const double py =
                        (y + point.across * layout.sine() + along * layout.cosine()) * perMmY + 0.5 * height;
                    if (!(px >= 0 && px < width && py >= 0 && py < height)) {
                        for (double& channel : sum) channel += static_cast<double>(point.share);
                        continue;
                    }
                    const auto from = static_cast<std::int64_t>(px);
                    const std::array<float, 3> pixel =
                        pixelAt(s.mirror ? layout.width() - 1 - from : from, static_cast<std::int64_t>(py));
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(point.share * pixel[c]);
                }
            }
            for (int c = 0; c < 3; ++c)
                seen.at(column, row, c) = static_cast<float>(sum[static_cast<std::size_t>(c)] / alongSteps);
        }
    }
    return seen;
}

}  // namespace

render::Image lookThrough(const PrintLayout& layout, const render::Image& raster, const Eye& eye, int apertureParts)
{
    if (raster.width != layout.width() || raster.height != layout.height()) {
        throw Failure(ErrorKind::file, "The print has " + std::to_string(raster.width) + " x " +
                                           std::to_string(raster.height) + " pixels, and its description says " +
                                           std::to_string(layout.width()) + " x " + std::to_string(layout.height()) +
                                           "; look at the unscaled, uncut file.");
    }
    const std::size_t second = raster.channels < 3 ? 0 : 1;
    return lookThroughOf(layout, eye, apertureParts, [&](std::int64_t x, std::int64_t y) {
        const float* at = raster.pixels.data() + raster.index(static_cast<int>(x), static_cast<int>(y));
        return std::array<float, 3>{at[0], at[second], at[2 * second]};
    });
}

render::Image lookThrough(PrintRaster& raster, const Eye& eye, int apertureParts)
{
    static const std::vector<float> linear = [] {
        std::vector<float> table(65536);
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = static_cast<float>(render::linearFromSrgb(static_cast<double>(i) / 65535));
        return table;
    }();
    render::Image seen = lookThroughOf(raster.layout(), eye, apertureParts, [&](std::int64_t x, std::int64_t y) {
        const std::uint16_t* at = raster.row(y) + static_cast<std::size_t>(x) * 3;
        return std::array<float, 3>{linear[at[0]], linear[at[1]], linear[at[2]]};
    });
    render::convertFromProfile(seen, raster.profile());
    return seen;
}

double angleOfView(const PrintLayout& layout, int k)
{
    const PrintSettings& s = layout.settings();
    const double place = (s.reverse ? k + 0.5 : s.views - k - 0.5) / s.views;
    const double target = (place - 0.5 - s.phase) * s.sheet.pitch();
    double low = -1.45;
    double high = 1.45;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (aperture(s.sheet, middle).mean > target ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace vitrine::printing

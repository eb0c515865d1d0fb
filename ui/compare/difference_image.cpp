#include "ui/compare/difference_image.h"

#include "render/image/srgb.h"
#include "render/measure/flip.h"
#include "render/measure/metrics.h"

#include <array>

namespace vitrine::ui {
namespace {

render::Image lightOf(const QImage& screen)
{
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> table{};
        for (std::size_t code = 0; code < table.size(); ++code)
            table.at(code) = static_cast<float>(render::linearFromSrgb(static_cast<double>(code) / 255));
        return table;
    }();
    const QImage codes = screen.convertToFormat(QImage::Format_RGBX8888);
    render::Image light(codes.width(), codes.height(), 3);
    for (int y = 0; y < light.height; ++y) {
        const uchar* row = codes.constScanLine(y);
        for (int x = 0; x < light.width; ++x)
            for (int c = 0; c < 3; ++c) light.at(x, y, c) = linear[row[4 * x + c]];
    }
    return light;
}

QImage screenOf(const render::Image& light)
{
    QImage screen(light.width, light.height, QImage::Format_RGBX8888);
    for (int y = 0; y < light.height; ++y) {
        uchar* row = screen.scanLine(y);
        for (int x = 0; x < light.width; ++x) {
            for (int c = 0; c < 3; ++c) row[4 * x + c] = render::srgb8FromLinear(light.at(x, y, c));
            row[4 * x + 3] = 255;
        }
    }
    return screen;
}

}  // namespace

QImage differenceImage(const QImage& a, const QImage& b, CompareMode mode, int gain)
{
    const QImage sized = a.size() == b.size() ? a : a.scaled(b.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const render::Image reference = lightOf(sized), test = lightOf(b);
    if (mode == CompareMode::signedDifference) return screenOf(render::signedDifference(reference, test, gain));
    return screenOf(render::heatMap(render::flipMap(reference, test), 1.0 / gain));
}

}  // namespace vitrine::ui

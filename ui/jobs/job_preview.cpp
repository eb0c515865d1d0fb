#include "ui/jobs/job_preview.h"

#include "render/image/srgb.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

QImage imageWithOpacity(const render::Image& light)
{
    QImage picture(light.width, light.height, QImage::Format_ARGB32);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            const auto code = [&](int k) { return static_cast<int>(render::srgb8FromLinear(light.at(x, y, k))); };
            const float alpha = light.channels > 3 ? std::clamp(light.at(x, y, 3), 0.0F, 1.0F) : 1.0F;
            const auto opacity = static_cast<int>(std::lround(255 * alpha));
            picture.setPixel(x, y, opacity > 0 ? qRgba(code(0), code(1), code(2), opacity) : 0U);
        }
    return picture;
}

}  // namespace vitrine::ui

#include "moc_job_preview.cpp"

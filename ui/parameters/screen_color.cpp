#include "ui/parameters/screen_color.h"

#include "render/image/srgb.h"

namespace vitrine::ui {

QColor encoded(const glm::dvec3& color)
{
    const glm::dvec3 c = glm::clamp(color, 0.0, 1.0);
    const auto encode = [](double x) { return static_cast<float>(render::srgbFromLinear(x)); };
    return QColor::fromRgbF(encode(c.x), encode(c.y), encode(c.z));
}

glm::dvec3 linear(const QColor& color)
{
    const QColor rgb = color.toRgb();
    const auto decode = [](int code) { return render::linearFromSrgb(code / 255.0); };
    return {decode(rgb.red()), decode(rgb.green()), decode(rgb.blue())};
}

}  // namespace vitrine::ui

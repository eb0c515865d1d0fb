#include "tests/exhibits/lenticular/card_shot.h"

#include "render/image/image_io.h"
#include "render/image/srgb.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <cmath>

namespace vitrine::test {
namespace {

void writeView(const std::filesystem::path& folder, int k, double linear)
{
    std::filesystem::create_directories(folder);
    render::writePicture(folder / ("view" + std::to_string(k) + ".png"),
                         render::Image(12, 8, 3, static_cast<float>(linear)), render::PictureFormat::png8);
}

}  // namespace

double solidLevel(int k, int count)
{
    return render::linearFromSrgb(render::srgb8FromLinear(static_cast<float>((k + 1.0) / (count + 1.0))) / 255.0);
}

std::string CardViews::solid(int count)
{
    const std::filesystem::path folder = folder_.path() / ("solid" + std::to_string(count));
    if (!std::filesystem::exists(folder))
        for (int k = 0; k < count; ++k) writeView(folder, k, (k + 1.0) / (count + 1.0));
    return folder.string();
}

std::string CardViews::level(double linear)
{
    const std::filesystem::path folder = folder_.path() / ("level" + std::to_string(linear));
    if (!std::filesystem::exists(folder)) writeView(folder, 0, linear);
    return folder.string();
}

CardShot::CardShot() : ExhibitShot("lenticular")
{
    request.frame.channels.normal = false;
    set(table().scroll, false).set(table().margin, 0.0).set(table().distance, 1e6).set(table().inkSpread, 0.0);
    set(table().views, 256).set(table().apertureSamples, 64).set(table().specular, 0.0);
    transform(glm::affineInverse(lenticular::exhibitFromCard()));
    size(25, 25);
}

CardShot& CardShot::from(double angle, double distance, double pixel, double rise)
{
    const glm::dvec3 toEye(std::sin(angle) * std::cos(rise), std::sin(rise), std::cos(angle) * std::cos(rise));
    request.frame.camera.target = glm::dvec3(0);
    request.frame.camera.eye = distance * toEye;
    request.frame.camera.fovY = 2 * std::atan(0.5 * pixel * request.frame.raster.size.y / distance);
    return *this;
}

std::vector<double> CardShot::printed(CardViews& views, const std::string& path, int channel)
{
    const auto shot = [&](const std::string& print) {
        values().set(table().frontPrint, print);
        return take().image;
    };
    const render::Image image = shot(path);
    const render::Image black = shot(views.level(0));
    const render::Image white = shot(views.level(1));
    std::vector<double> result;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double low = black.at(x, y, channel);
            result.push_back((static_cast<double>(image.at(x, y, channel)) - low) /
                             (static_cast<double>(white.at(x, y, channel)) - low));
        }
    return result;
}

}  // namespace vitrine::test

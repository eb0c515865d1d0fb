// Pictures of all directions: a panorama as it is, or one made of six faces.

#include "exhibits/sdf_scenes/shown_scene.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vitrine::scenes {
namespace {

constexpr int widestPanorama = 4096;  ///< Made of faces.

/// Which face a direction meets, and where in its picture: columns to the right, rows down, 0 to 1.
struct FacePlace {
    std::size_t face;
    double column, row;
};

/// right, left, top, bottom, front, back, as seen from within; front is -z.
FacePlace facePlace(const glm::dvec3& d)
{
    const glm::dvec3 size = glm::abs(d);
    const auto at = [](std::size_t face, double right, double up, double ahead) {
        return FacePlace{face, 0.5 + 0.5 * right / ahead, 0.5 - 0.5 * up / ahead};
    };
    if (size.x >= size.y && size.x >= size.z) return d.x > 0 ? at(0, d.z, d.y, d.x) : at(1, -d.z, d.y, -d.x);
    if (size.y >= size.z) return d.y > 0 ? at(2, d.x, d.z, d.y) : at(3, d.x, -d.z, -d.y);
    return d.z < 0 ? at(4, d.x, d.y, -d.z) : at(5, -d.x, d.y, d.z);
}

glm::dvec3 colorAt(const render::Image& face, double column, double row)
{
    const auto within = [](double x, int count) { return std::clamp(x * count - 0.5, 0.0, count - 1.0); };
    const double x = within(column, face.width), y = within(row, face.height);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, face.width - 1), y1 = std::min(y0 + 1, face.height - 1);
    glm::dvec3 color;
    for (int c = 0; c < 3; ++c) {
        const int channel = face.channels < 3 ? 0 : c;
        const auto mixed = [&](int line) {
            return std::lerp(static_cast<double>(face.at(x0, line, channel)),
                             static_cast<double>(face.at(x1, line, channel)), x - x0);
        };
        color[c] = std::lerp(mixed(y0), mixed(y1), y - y0);
    }
    return color;
}

std::shared_ptr<const render::Texture> panoramaOf(const std::array<render::Image, 6>& faces)
{
    auto made = std::make_shared<render::Texture>();
    made->name = "six faces";
    made->width = std::clamp(4 * faces[0].width, 4, widestPanorama);
    made->height = made->width / 2;
    made->channels = 3;
    made->floats.reserve(static_cast<std::size_t>(made->width) * static_cast<std::size_t>(made->height) * 3);
    for (int y = 0; y < made->height; ++y) {
        const double polar = (y + 0.5) / made->height * std::numbers::pi;
        for (int x = 0; x < made->width; ++x) {
            // As shaders/lib/sky.glsl looks panoramas up.
            const double around = ((x + 0.5) / made->width - 0.5) * 2 * std::numbers::pi;
            const glm::dvec3 d(std::sin(polar) * std::sin(around), std::cos(polar),
                               -std::sin(polar) * std::cos(around));
            const FacePlace place = facePlace(d);
            const glm::dvec3 color = colorAt(faces[place.face], place.column, place.row);
            for (int c = 0; c < 3; ++c) made->floats.push_back(static_cast<float>(color[c]));
        }
    }
    return made;
}

}  // namespace

std::shared_ptr<const render::Texture> readEnvironment(const ShownScene& shown)
{
    const std::vector<std::filesystem::path> files = environmentFiles(*shown.scene, shown.path);
    if (files.size() == 1) return render::loadTexture(files[0], true, true);
    std::array<render::Image, 6> faces;
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = render::readColor(files[i]);
    return panoramaOf(faces);
}

std::vector<std::filesystem::path> environmentFiles(const Scene& scene, const std::filesystem::path& path)
{
    std::vector<std::filesystem::path> files;
    for (const std::string& file : scene.environment.files) files.push_back(path.parent_path() / file);
    return files;
}

}  // namespace vitrine::scenes

#include "exhibits/pixel_art/method_table.h"

#include "exhibits/pixel_art/pixel_passes.h"
#include "render/scene/gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace vitrine::pixel_art {
namespace {

const PixelArtTable& methodParameters()
{
    static const PixelArtTable table;
    return table;
}

std::size_t methodCount()
{
    return methodParameters().rows()[methodParameters().method.row].choices.size() -
           1;  // All methods except the drawn normals.
}

std::string choiceOf(std::size_t row, int value)
{
    return std::string(methodParameters().rows()[row].choices[static_cast<std::size_t>(value)]);
}

/// Formats a number with this many digits behind the point.
std::string withDigits(double x, int digits)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, x);
    return text.data();
}

/// Returns the angles in degrees, ascending, for all texels that show an object.
std::vector<double> anglesBetween(const render::Image& truth, const render::Image& found)
{
    std::vector<double> off;
    for (std::size_t i = 0; i < truth.pixels.size(); i += 4) {
        if (truth.pixels[i + 3] <= 0) continue;
        const auto at = [i](const render::Image& image) {
            return glm::dvec3(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
        };
        const glm::dvec3 a = at(truth), b = at(found);
        off.push_back(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi);
    }
    std::sort(off.begin(), off.end());
    return off;
}

}  // namespace

NormalErrors measureNormals(render::RenderBackend& backend, const ParameterValues& values,
                            const std::vector<WorldPart>& parts, const PaletteTextures* palette, int runs)
{
    NormalErrors m;
    std::map<std::string, std::vector<double>> times;
    for (int run = 0; run <= runs; ++run) {
        PixelShot shot{
            methodParameters(), values, pixelCamera(methodParameters(), values, {0, 0}), 0.5, parts, 0, palette};
        shot.keepsLit = shot.seenSmaller = false;
        render::FramePlan plan;
        plan.view.raster.size = shot.camera.size;
        plan.allSlices = true;
        planPixelPicture(shot, plan);
        plan.prune({pixelTruthImage, pixelSurfaceImage, pixelShownImage});
        for (const render::StepReport& step : backend.draw(plan).ran)
            if (run > 0) times[step.name].push_back(step.milliseconds);
    }
    for (auto& [name, list] : times) {
        std::sort(list.begin(), list.end());
        m.milliseconds[name] = list[list.size() / 2];
    }
    const std::vector<double> off =
        anglesBetween(backend.read(pixelTruthImage), normalsOf(backend.read(pixelSurfaceImage)));
    if (off.empty()) return m;
    const auto share = [&](double limit) {
        return 100.0 * static_cast<double>(off.end() - std::upper_bound(off.begin(), off.end(), limit)) /
               static_cast<double>(off.size());
    };
    for (const double x : off) m.mean += x / static_cast<double>(off.size());
    m.p99 = off[off.size() * 99 / 100];
    m.beyond5 = share(5);
    m.beyond20 = share(20);
    return m;
}

MethodTable::MethodTable(std::vector<Scene> scenes, std::vector<Picture> pictures, int runs)
    : scenes_(std::move(scenes)), pictures_(std::move(pictures)),
      runs_(runs), lines_{{"scene", "size", "depth", "method", "mean", "p99", "beyond5", "beyond20", "fetches", "ms"}}
{
}

MethodTable MethodTable::all(const ParameterValues& values)
{
    std::vector<Scene> scenes{{"test scene", testParts(0.5)}, {"thin bars", barParts()}, {"isle", isleParts(0.5)}};
    if (const std::string& model = values[methodParameters().model]; !model.empty())
        scenes.push_back({"a visitor's model", modelParts(render::loadGltf(model), 0)});
    return {std::move(scenes),
            {{PixelResolution::r240, DepthBits::float32},
             {PixelResolution::r480, DepthBits::float32},
             {PixelResolution::r960, DepthBits::float32},
             {PixelResolution::r1920, DepthBits::float32},
             {PixelResolution::r480, DepthBits::unorm24},
             {PixelResolution::r480, DepthBits::unorm16}},
            5};
}

std::size_t MethodTable::eachScene() const
{
    return pictures_.size() * methodCount();
}

double MethodTable::work(std::size_t lines) const
{
    constexpr double overhead = 0.1;  // Fixed work of a picture, whatever its size.
    double sum = 0;
    for (std::size_t i = 0; i < lines; ++i) {
        const std::string width =
            choiceOf(methodParameters().resolution.row, static_cast<int>(pictures_[i / methodCount()].resolution));
        sum += overhead + std::stod(width) * std::stod(width) * 9 / 16 / 1e6;
    }
    return sum;
}

double MethodTable::progress() const
{
    const std::size_t each = eachScene();
    return (static_cast<double>(done_ / each) * work(each) + work(done_ % each)) /
           (static_cast<double>(scenes_.size()) * work(each));
}

bool MethodTable::step(render::RenderBackend& backend)
{
    const PixelArtTable& t = methodParameters();
    const std::size_t each = eachScene();
    const Scene& scene = scenes_[done_ / each];
    const Picture& picture = pictures_[done_ % each / methodCount()];
    const auto method = static_cast<NormalsBy>(1 + done_ % methodCount());
    ParameterValues values = t.initial();
    values.set(t.resolution, picture.resolution);
    values.set(t.depthBits, picture.bits);
    values.set(t.projection, PixelProjection::perspective);
    values.set(t.method, method);
    const NormalErrors m = measureNormals(backend, values, scene.parts, nullptr, runs_);
    const auto normals = m.milliseconds.find("pixel_art/normals");
    lines_.push_back({scene.name, choiceOf(t.resolution.row, static_cast<int>(picture.resolution)),
                      choiceOf(t.depthBits.row, static_cast<int>(picture.bits)),
                      choiceOf(t.method.row, static_cast<int>(method)), withDigits(m.mean, 4), withDigits(m.p99, 3),
                      withDigits(m.beyond5, 4), withDigits(m.beyond20, 4), std::to_string(fetchesOf(method)),
                      withDigits(normals == m.milliseconds.end() ? -1 : normals->second, 4)});
    ++done_;
    return done_ < expectedLines();
}

}  // namespace vitrine::pixel_art

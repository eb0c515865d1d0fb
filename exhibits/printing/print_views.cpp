#include "exhibits/printing/print_views.h"

#include "exhibits/printing/view_files.h"
#include "render/failure.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

constexpr int smallSide = 400;
constexpr int draftWidth = 240;
constexpr int largestView = 16384;

/// Box-filtered by a whole factor, so that its longer side is at most about twice `side`.
render::Image shrunk(const render::Image& image, int side)
{
    const int factor = std::max(image.width, image.height) / side;
    if (factor <= 1) return image;
    const int width = (image.width + factor - 1) / factor;
    const int height = (image.height + factor - 1) / factor;
    render::Image small(width, height, image.channels);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int x1 = std::min((x + 1) * factor, image.width);
            const int y1 = std::min((y + 1) * factor, image.height);
            for (int c = 0; c < image.channels; ++c) {
                float sum = 0;
                for (int v = y * factor; v < y1; ++v)
                    for (int u = x * factor; u < x1; ++u) sum += image.at(u, v, c);
                small.at(x, y, c) = sum / static_cast<float>((x1 - x * factor) * (y1 - y * factor));
            }
        }
    }
    return small;
}

/// Of the print's shape.
glm::ivec2 viewSize(const PrintLayout& layout, int width)
{
    const PrintSettings& s = layout.settings();
    const double height = width * (s.height + 2 * s.bleed) / (s.width + 2 * s.bleed);
    return {width, static_cast<int>(std::clamp(std::round(height), 1.0, static_cast<double>(largestView)))};
}

ViewRig rigOf(const PrintLayout& layout, const ParameterValues& values, const SceneState& sceneState)
{
    const PrintTable& table = printTable();
    return {layout,
            sceneState.camera,
            viewSize(layout, values[table.viewWidth]),
            {values[table.baselineScale], values[table.convergence]}};
}

/// `progress`, or Failure where it stops the work.
void require(const Progress& progress, double part)
{
    if (progress && !progress(part)) throw Failure(Blame::usage, "Reading the views was stopped; nothing was changed.");
}

std::shared_ptr<const PrintViews> readQuilt(const ParameterValues& values, const std::vector<std::string>& files,
                                            const Progress& progress)
{
    if (files.empty()) throw Failure(Blame::usage, "There is no quilt; choose a picture with a grid of views.");
    auto views = std::make_shared<PrintViews>();
    require(progress, 0);
    const render::Image quilt = render::readImage(files.front());
    const int columns = values[printTable().quiltColumns];
    const int rows = values[printTable().quiltRows];
    for (int k = 0; k < columns * rows; ++k) {
        require(progress, static_cast<double>(k) / (columns * rows));
        views->add(viewOfQuilt(quilt, columns, rows, k));
    }
    views->setProfile(render::embeddedProfile(files.front()));
    return views;
}

}  // namespace

void PrintViews::add(const render::Image& image)
{
    full_.add(image);
    small_.add(shrunk(image, smallSide));
}

std::shared_ptr<const PrintViews> readViews(const ParameterValues& values, const std::vector<std::string>& names,
                                            const Progress& progress)
{
    if (values[printTable().origin] == ViewOrigin::quilt) return readQuilt(values, names, progress);
    if (names.empty()) throw Failure(Blame::usage, "There are no views; choose a folder or pictures.");
    auto views = std::make_shared<PrintViews>();
    const std::vector<std::filesystem::path> files = viewFiles(names);
    const std::vector<std::size_t> chosen =
        chosenViews(files.size(), {1, false, std::min(values[printTable().views], static_cast<int>(files.size()))});
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        require(progress, static_cast<double>(i) / static_cast<double>(chosen.size()));
        views->add(render::readImage(files[chosen[i]]));
    }
    views->setProfile(render::embeddedProfile(files[chosen.front()]));
    return views;
}

std::vector<ViewShot> printShots(const ParameterValues& values, const SceneState& sceneState, const FrameRequest& frame,
                                 bool draft)
{
    const PrintTable& table = printTable();
    const PrintLayout layout(printSettings(values, values[table.views]));
    ViewShot base{sceneState, {}};
    base.request.frame = frame;
    base.request.frame.raster.size =
        viewSize(layout, draft ? std::min(values[table.viewWidth], draftWidth) : values[table.viewWidth]);
    base.request.samples = draft ? 1 : values[table.samples];
    return shotsOf(rigOf(layout, values, sceneState), base);
}

SceneDepth sceneDepth(const ParameterValues& values, const SceneState& sceneState, const render::Image& picture)
{
    const PrintTable& table = printTable();
    const ViewRig rig = rigOf(PrintLayout(printSettings(values, values[table.views])), values, sceneState);
    const DepthRange scene = depthRange(picture);
    SceneDepth depth{scene, rig.budget(), std::min(1.0, rig.strengthThatHolds(scene)), warningsOf(rig, scene)};
    if (values[table.reverse] && rig.baseline() > 0)
        depth.warnings.emplace_back("In reverse order the depth of rendered views is inside out.");
    return depth;
}

}  // namespace vitrine::printing

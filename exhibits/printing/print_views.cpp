#include "exhibits/printing/print_views.h"

#include "exhibits/printing/view_colors.h"
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

/// Returns the image box-filtered by a whole factor, so its longer side is at most about twice `side`.
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

/// Returns the size of a view in the shape of the print.
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

/// Calls `progress`; throws Failure if it stops the work.
void require(const Progress& progress, double part)
{
    if (progress && !progress(part))
        throw Failure(ErrorKind::usage, "Reading the views was stopped; nothing was changed.");
}

/// Returns width divided by height of the print.
double printAspect(const ParameterValues& values)
{
    const PrintTable& table = printTable();
    return aspectOf({.width = values[table.width], .height = values[table.height], .bleed = values[table.bleed]});
}

/// Reads a picture in the color space of the print.
render::Image readView(const std::filesystem::path& file, const ViewColors& colors, PrintViews& views)
{
    std::vector<std::string> warnings;
    render::Image image = render::readColor(file, {.keepColors = colors.keep}, &warnings);
    for (const std::string& warning : warnings) views.addNote(file.filename().string() + ": " + warning);
    return image;
}

/// Adds a picture in the shape of the print. `picture` is its number among all given pictures, from 1.
void addFitted(render::Image image, int picture, const ParameterValues& values, PrintViews& views)
{
    const Fitting fitting = values[printTable().fitting];
    const double aspect = printAspect(values);
    views.addNote(fittingNote(image, aspect, fitting));
    views.add(fitted(std::move(image), aspect, fitting, placeOf(viewPlaces(values[printTable().places]), picture)),
              picture);
}

std::shared_ptr<const PrintViews> readQuilt(const ParameterValues& values, const std::vector<std::string>& files,
                                            const Progress& progress)
{
    if (files.empty()) throw Failure(ErrorKind::usage, "There is no quilt; choose a picture with a grid of views.");
    auto views = std::make_shared<PrintViews>();
    require(progress, 0);
    const ViewColors colors = viewColors({files.front()});
    const render::Image quilt = readView(files.front(), colors, *views);
    const int columns = values[printTable().quiltColumns];
    const int rows = values[printTable().quiltRows];
    views->addNote(quiltNote(quilt, columns, rows));
    for (int k = 0; k < columns * rows; ++k) {
        require(progress, static_cast<double>(k) / (columns * rows));
        addFitted(viewOfQuilt(quilt, columns, rows, k), k + 1, values, *views);
    }
    views->setProfile(colors.profile);
    return views;
}

}  // namespace

void PrintViews::add(const render::Image& image, int picture)
{
    pictures_.push_back(picture);
    full_.add(image);
    small_.add(shrunk(image, smallSide));
}

void PrintViews::addNote(const std::string& note)
{
    if (!note.empty() && std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
}

std::shared_ptr<const PrintViews> readViews(const ParameterValues& values, const std::vector<std::string>& names,
                                            const Progress& progress)
{
    if (values[printTable().origin] == ViewOrigin::quilt) return readQuilt(values, names, progress);
    if (names.empty()) throw Failure(ErrorKind::usage, "There are no views; choose a folder or pictures.");
    auto views = std::make_shared<PrintViews>();
    std::vector<std::string> notes;
    const std::vector<std::filesystem::path> files = viewFiles(names, &notes);
    for (const std::string& note : notes) views->addNote(note);
    const std::vector<std::size_t> numbers =
        chosenViews(files.size(), {1, false, std::min(values[printTable().views], static_cast<int>(files.size()))});
    std::vector<std::filesystem::path> chosen;
    for (const std::size_t i : numbers) chosen.push_back(files[i]);
    const ViewColors colors = viewColors(chosen);
    views->addNote(colors.note);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        require(progress, static_cast<double>(i) / static_cast<double>(chosen.size()));
        addFitted(readView(chosen[i], colors, *views), static_cast<int>(numbers[i]) + 1, values, *views);
    }
    views->setProfile(colors.profile);
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

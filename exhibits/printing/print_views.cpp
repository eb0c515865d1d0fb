#include "exhibits/printing/print_views.h"

#include "exhibits/framework/table/typed_number.h"
#include "exhibits/museum/assignment.h"
#include "exhibits/printing/quilt.h"
#include "exhibits/printing/view_colors.h"
#include "exhibits/printing/view_files.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/image/rec709.h"
#include "render/video/video_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace vitrine::printing {
namespace {

constexpr int smallSide = 400;
constexpr int draftWidth = 240;
constexpr int largestView = 16384;
constexpr int longestSide = 1200;       // Default of the longer side of a rendered view, in pixels.
constexpr int samplesInTheWindow = 16;  // Samples per pixel, if neither the values nor the scene give them.

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
render::Image readView(const std::filesystem::path& file, const ViewColors& colors, const Progress& progress,
                       double part, PrintViews& views)
{
    require(progress, part);
    std::vector<std::string> warnings;
    const auto canceled = [&] { return progress && !progress(part); };
    render::Image image = render::readColor(file, {.keepColors = colors.keep, .canceled = canceled}, &warnings);
    for (const std::string& warning : warnings) views.addNote(file.filename().string() + ": " + warning);
    return image;
}

/// A picture, or a frame of a video.
struct ViewSource {
    std::filesystem::path file{};
    std::optional<std::size_t> frame{};  ///< From 0.

    [[nodiscard]] std::string name() const
    {
        return file.filename().string() + (frame ? ", frame " + std::to_string(*frame) : std::string());
    }
};

/// Returns the pictures, and every frame of the videos, in order.
std::vector<ViewSource> sourcesOf(const std::vector<std::filesystem::path>& files)
{
    std::vector<ViewSource> sources;
    for (const std::filesystem::path& file : files) {
        if (!render::isReadVideo(file)) {
            sources.push_back({file, {}});
            continue;
        }
        const std::size_t frames = render::countFrames(file);
        for (std::size_t frame = 0; frame < frames; ++frame) sources.push_back({file, frame});
    }
    return sources;
}

/// Views that are read into the shape of the print.
struct ReadingViews {
    const ParameterValues& values;
    ViewPlaces places;
    std::shared_ptr<PrintViews> views;
    mutable std::unique_ptr<render::VideoFrameReader> video{};  ///< The video that was read last.
    mutable std::filesystem::path videoFile{};

    ReadingViews(const ParameterValues& of, std::size_t pictures, ViewUse use)
        : values(of), places(viewPlaces(of[printTable().places])), views(std::make_shared<PrintViews>(use))
    {
        if (use == ViewUse::print) requirePictures(places, static_cast<int>(pictures));
    }
    /// Reads a frame of a video. Throws Failure if the video has fewer.
    [[nodiscard]] render::Image frameOf(const ViewSource& source, const Progress& progress, double part) const
    {
        require(progress, part);
        if (!video || videoFile != source.file) {
            video = std::make_unique<render::VideoFrameReader>(source.file);
            videoFile = source.file;
        }
        if (std::optional<render::Image> image = video->frame(*source.frame)) return std::move(*image);
        throw Failure(ErrorKind::file, "Cannot read " + source.file.string() + ": it ends before frame " +
                                           std::to_string(*source.frame) + "; choose another video.");
    }
    /// `picture` is its number among all given pictures, from 1.
    void add(render::Image image, int picture, const std::string& name) const
    {
        const Fitting fitting = values[printTable().fitting];
        const double aspect = printAspect(values);
        const ViewPlace place = placeOf(places, picture);
        views->addNote(fittingNote(image, aspect, fitting));
        views->add(fitted(std::move(image), aspect, fitting, place), picture,
                   place == ViewPlace{} ? name : name + ", placed by " + textOf({{picture, place}}));
    }
};

/// Returns the indices of the chosen ones of `available` pictures.
std::vector<std::size_t> chosenOf(std::size_t available, const ParameterValues& values, ViewUse use)
{
    const PrintTable& table = printTable();
    SequenceSettings settings{values[table.every], values[table.pingPong], values[table.views]};
    if (use == ViewUse::setup && settings.count > 0) {
        const SequenceSettings all{settings.every, settings.pingPong, 0};
        settings.count = std::min(settings.count, static_cast<int>(chosenViews(available, all).size()));
    }
    return chosenViews(available, settings);
}

std::shared_ptr<const PrintViews> readQuilt(const ParameterValues& values, const Progress& progress, ViewUse use)
{
    const PrintTable& table = printTable();
    const std::filesystem::path file = values[table.quilt];
    if (file.empty()) throw Failure(ErrorKind::usage, "There is no quilt; choose a picture with a grid of views.");
    const int columns = values[table.quiltColumns], rows = values[table.quiltRows];
    const auto available = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const std::vector<std::size_t> chosen = chosenOf(available, values, use);
    const ReadingViews reading(values, available, use);
    const ViewColors colors = viewColors({file});
    const render::Image quilt = readView(file, colors, progress, 0, *reading.views);
    reading.views->addNote(quiltNote(quilt, columns, rows));
    if (const auto named = quiltNamed(file); named && (named->columns != columns || named->rows != rows))
        reading.views->addNote("The name of " + file.filename().string() + " says " + std::to_string(named->columns) +
                               " x " + std::to_string(named->rows) + " views; it is read as " +
                               std::to_string(columns) + " x " + std::to_string(rows) + ".");
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        require(progress, static_cast<double>(i) / static_cast<double>(chosen.size()));
        const int k = static_cast<int>(chosen[i]);
        reading.add(viewOfQuilt(quilt, columns, rows, k, values[table.quiltOrder]), k + 1,
                    file.filename().string() + ", view " + std::to_string(k));
    }
    reading.views->setProfile(colors.profile);
    return reading.views;
}

std::shared_ptr<const PrintViews> readFiles(const ParameterValues& values, const Progress& progress, ViewUse use)
{
    const std::vector<std::string> names = picturesOf(values);
    if (names.empty()) throw Failure(ErrorKind::usage, "There are no views; choose a folder or pictures.");
    std::vector<std::string> notes;
    const std::vector<ViewSource> all = sourcesOf(viewFiles(names, &notes));
    const ReadingViews reading(values, all.size(), use);
    for (const std::string& note : notes) reading.views->addNote(note);
    const std::vector<std::size_t> numbers = chosenOf(all.size(), values, use);
    std::vector<ViewSource> chosen;
    std::vector<std::filesystem::path> pictures;
    for (const std::size_t i : numbers) {
        chosen.push_back(all[i]);
        if (!all[i].frame) pictures.push_back(all[i].file);
    }
    ViewColors colors = viewColors(pictures);
    if (pictures.size() < chosen.size() && colors.keep && !pictures.empty() && !render::isSrgbProfile(colors.profile))
        colors = {false, {}, "The pictures have a color profile and the video has none; all are converted to sRGB."};
    reading.views->addNote(colors.note);
    std::set<std::pair<int, int>> sizes;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(chosen.size());
        render::Image image = chosen[i].frame ? reading.frameOf(chosen[i], progress, part)
                                              : readView(chosen[i].file, colors, progress, part, *reading.views);
        sizes.emplace(image.width, image.height);
        reading.add(std::move(image), static_cast<int>(numbers[i]) + 1, chosen[i].name());
    }
    if (sizes.size() > 1) reading.views->addNote("The views differ in size; each is scaled to the print.");
    reading.views->setProfile(colors.profile);
    return reading.views;
}

/// Splits "morph=0..1" into "morph=0" and "morph=1".
std::array<std::string, 2> endsOf(const std::string& sweep)
{
    const std::size_t equals = sweep.find('=');
    const std::size_t dots = equals == std::string::npos ? equals : sweep.find("..", equals);
    if (dots == std::string::npos || equals == 0 || dots == equals + 1 || dots + 2 == sweep.size())
        throw Failure(ErrorKind::usage, "--sweep \"" + sweep + "\": give name=from..to, such as --sweep morph=0..1.");
    const std::string name = sweep.substr(0, equals + 1);
    return {sweep.substr(0, dots), name + sweep.substr(dots + 2)};
}

void sweepTime(std::vector<ViewShot>& shots, const std::array<std::string, 2>& ends)
{
    const double from = readNumber("--sweep time", ends[0].substr(5), {.unit = Unit::second});
    const double to = readNumber("--sweep time", ends[1].substr(5), {.unit = Unit::second});
    const double last = static_cast<double>(std::max<std::size_t>(shots.size() - 1, 1));
    for (std::size_t k = 0; k < shots.size(); ++k)
        shots[k].request.frame.time = from + (to - from) * static_cast<double>(k) / last;
}

void applySweeps(const std::string& sweeps, const SceneState& sceneState, std::vector<ViewShot>& shots,
                 SweptScene& scene)
{
    for (const std::string& typed : linesOf(sweeps)) {
        const std::array<std::string, 2> ends = endsOf(typed);
        if (typed.rfind("time=", 0) == 0) {
            sweepTime(shots, ends);
        } else if (scene.museum) {
            std::array<SceneState, 2> states{sceneState, sceneState};
            for (std::size_t i = 0; i < 2; ++i) applySet(*scene.museum, states[i], scene.subject, ends[i], scene.notes);
            sweep(shots, states[0], states[1]);
        }
    }
}

}  // namespace

void PrintViews::add(const render::Image& image, int picture, std::string source)
{
    pictures_.push_back(picture);
    sources_.push_back(std::move(source));
    full_.add(image);
    if (use_ == ViewUse::setup) small_.add(shrunk(image, smallSide));
}

void PrintViews::addNote(const std::string& note)
{
    if (!note.empty() && std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
}

std::shared_ptr<const PrintViews> readViews(const ParameterValues& values, const Progress& progress, ViewUse use)
{
    return values[printTable().origin] == ViewOrigin::quilt ? readQuilt(values, progress, use)
                                                            : readFiles(values, progress, use);
}

glm::ivec2 viewSize(const PrintLayout& layout, const ParameterValues& values)
{
    const glm::ivec2 given(values[printTable().viewWidth], values[printTable().viewHeight]);
    if (given.x == 0 && given.y > 0)
        throw Failure(ErrorKind::usage, "--view-size: the height " + std::to_string(given.y) +
                                            " is given without a width; give the width, too, or neither.");
    if (given.x > 0 && given.y > 0) return given;
    const PrintSettings& s = layout.settings();
    const glm::dvec2 print(s.width + 2 * s.bleed, s.height + 2 * s.bleed);
    if (given.x > 0) {
        const double height = std::round(given.x * print.y / print.x);
        return {given.x, static_cast<int>(std::clamp(height, 1.0, static_cast<double>(largestView)))};
    }
    // No higher resolution than the print has.
    const double pixels = std::min<double>(longestSide, static_cast<double>(std::max(layout.width(), layout.height())));
    return glm::ivec2(glm::max(glm::round(print * (pixels / std::max(print.x, print.y))), glm::dvec2(1)));
}

RenderedViews::RenderedViews(const ParameterValues& values, const PrintLayout& layout, ViewShot base, SweptScene& scene)
    : layout_(layout), base_(std::move(base)), convergence_(values[printTable().convergence]),
      strength_(strengthOf(values)), rig_(rigOf(strength_.value_or(1))), shots_(shotsOf(rig_, base_))
{
    if (values[printTable().turn] != 0) turn(shots_, values[printTable().turn]);
    applySweeps(values[printTable().sweeps], base_.sceneState, shots_, scene);
}

ViewRig RenderedViews::rigOf(double strength) const
{
    return {layout_, base_.sceneState.camera, base_.request.frame.raster.size, {strength, convergence_}};
}

void RenderedViews::fit(const DepthRange& depth)
{
    if (strength_) return;
    rig_ = rigOf(std::min(1.0, rig_.strengthThatHolds(depth)));
    for (std::size_t k = 0; k < shots_.size(); ++k)
        shots_[k].sceneState.camera = shots_[k].request.frame.camera = rig_.camera(static_cast<int>(k));
}

RenderedViews printShots(const ParameterValues& values, const SceneState& sceneState, const FrameRequest& frame,
                         bool draft, SweptScene&& scene)
{
    const PrintLayout layout(printSettings(values, viewCount(values)));
    ViewShot base{sceneState, {}};
    base.request.frame = frame;
    glm::ivec2 size = viewSize(layout, values);
    if (draft && size.x > draftWidth)
        size = {draftWidth,
                std::max(1, static_cast<int>(std::lround(static_cast<double>(draftWidth) * size.y / size.x)))};
    base.request.frame.raster.size = size;
    const int samples = values[printTable().samples];
    base.request.samples = draft ? 1 : samples > 0 ? samples : samplesInTheWindow;
    return {values, layout, std::move(base), scene};
}

SceneDepth sceneDepth(const ParameterValues& values, const SceneState& sceneState, const render::Image& picture)
{
    const PrintTable& table = printTable();
    const PrintLayout layout(printSettings(values, viewCount(values)));
    const DepthRange scene = depthRange(picture);
    ViewRig rig(layout, sceneState.camera, viewSize(layout, values),
                {strengthOf(values).value_or(1), values[table.convergence]});
    const double holds = std::min(1.0, rig.strengthThatHolds(scene));
    if (!strengthOf(values))
        rig = ViewRig(layout, sceneState.camera, viewSize(layout, values), {holds, values[table.convergence]});
    SceneDepth depth{scene, rig.budget(), holds, warningsOf(rig, scene)};
    if (values[table.reverse] && rig.baseline() > 0)
        depth.warnings.emplace_back("In reverse order the depth of rendered views is inside out.");
    return depth;
}

}  // namespace vitrine::printing

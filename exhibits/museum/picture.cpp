#include "exhibits/museum/picture.h"

#include "exhibits/framework/scene/glare.h"
#include "exhibits/museum/exr_metadata.h"
#include "render/failure.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace vitrine {
namespace {

/// Throws Failure if a picture does not fit into half of the machine's memory: writing it takes the same amount again.
void requireMemory(const glm::ivec2& size, std::size_t channels)
{
    const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    const double perPixel = static_cast<double>(channels * sizeof(float));
    const double wanted = static_cast<double>(size.x) * size.y * perPixel;
    if (wanted <= machine / 2) return;
    // Keeps the aspect ratio.
    const double shrink = std::sqrt(machine / 2 / wanted);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(2 * wanted < 1e11 ? 1 : 0);
    text << "A picture of " << size.x << " × " << size.y << " pixels takes " << 2 * wanted / 1e9
         << " GB of memory while it is made and written, and this machine has " << machine / 1e9
         << " GB; ask for no more than " << std::max(1, static_cast<int>(size.x * shrink)) << " × "
         << std::max(1, static_cast<int>(size.y * shrink)) << '.';
    throw Failure(ErrorKind::usage, text.str());
}

constexpr int halosSide = 1024;  ///< Most pixels per side of the picture of which the halos of a larger one are made.
constexpr int apron = 8;         ///< Pixels: two cells of the coarsest image that is upsampled to the picture's size.

}  // namespace

PictureMaker::PictureMaker(const Museum& museum, render::RenderBackend& backend, SceneState sceneState,
                           PictureRequest request)
    : museum_(museum), backend_(backend), sceneState_(std::move(sceneState)), request_(std::move(request))
{
    const glm::ivec2 size = request_.frame.raster.size;
    if (size.x < 1 || size.y < 1)
        throw Failure(ErrorKind::usage, "A picture needs at least 1 × 1 pixels; " + std::to_string(size.x) + " × " +
                                            std::to_string(size.y) + " were asked for.");
    std::vector<std::string> names{"R", "G", "B", "A"};
    if (request_.depth) names.emplace_back("depth.Z");
    if (request_.frame.channels.normal) names.insert(names.end(), {"normal.X", "normal.Y", "normal.Z"});
    if (request_.frame.channels.evaluations) names.emplace_back("evaluations");
    if (request_.frame.channels.albedo) names.insert(names.end(), {"albedo.R", "albedo.G", "albedo.B"});
    if (request_.position) names.insert(names.end(), {"position.X", "position.Y", "position.Z"});
    if (request_.before) names.insert(names.end(), {"backward.u", "backward.v"});
    request_.objects = request_.objects && request_.motion.empty();
    for (const char* channel : {"R", "G", "B", "A"})
        if (request_.objects) names.push_back(cryptomatteLayer + std::string("00.") + channel);
    requireMemory(size, names.size());
    request_.samples = request_.motion.empty() ? std::max(request_.samples, 1) : 1;
    int side = std::max(std::min(request_.largestTile, backend_.largestSide()), 1);
    // A tile is drawn with a margin, for effects that read a pixel's neighbors.
    const bool whole = side >= size.x && side >= size.y;
    if (!whole) side = std::max(std::min(side, backend_.largestSide() - 2 * apron), 1);
    // Texture filtering uses differences within blocks of 2 × 2 pixels, so these must be aligned as in the whole
    // picture.
    if (side > 1) side -= side % 2;
    for (int y = 0; y < size.y; y += side) {
        for (int x = 0; x < size.x; x += side) {
            const glm::ivec2 offset(x, y);
            const glm::ivec2 tile = glm::min(glm::ivec2(side), size - offset);
            const glm::ivec2 low = glm::max(offset - apron, glm::ivec2(0));
            tiles_.push_back({offset, tile, low, glm::min(offset + tile + apron, size) - low});
        }
    }
    picture_ = render::Image(size.x, size.y, static_cast<int>(names.size()));
    picture_.channelNames = std::move(names);
}

std::size_t PictureMaker::stepsOfTile() const
{
    return request_.motion.empty() ? static_cast<std::size_t>(request_.samples) : request_.motion.size() + 1;
}

double PictureMaker::progress() const
{
    return static_cast<double>(stepsDone_) / static_cast<double>(allSteps());
}

bool PictureMaker::finished() const
{
    return stepsDone_ == allSteps();
}

FrameRequest PictureMaker::frameOf(const Tile& tile, int step) const
{
    FrameRequest frame = request_.frame;
    const bool moves = !request_.motion.empty();
    frame.sample = moves ? 0 : step;
    frame.samples = request_.samples;
    frame.movingFrame = moves ? step + 1 : 0;
    if (moves && static_cast<std::size_t>(step) < request_.motion.size()) {
        frame.camera = request_.motion[static_cast<std::size_t>(step)].camera;
        frame.time = request_.motion[static_cast<std::size_t>(step)].time;
    }
    frame.halos = halos_;
    frame.raster.offset = tile.drawnOffset;
    frame.raster.tile = tile.drawnSize;
    // A finished picture depends only on its request, not on frames or tiles drawn before.
    frame.resetHistory = !moves || step == 0;
    frame.finished = true;
    return frame;
}

render::FramePlan PictureMaker::firstPlan()
{
    if (!prepared_) prepared_ = museum_.prepare(sceneState_, request_.frame);
    return museum_.plan(*prepared_, frameOf(tiles_.front(), 0), backend_.persistentState());
}

/// Draws the whole picture, small if it is large, for the halos of its tiles.
void PictureMaker::drawHalos()
{
    if (tiles_.size() < 2 || request_.frame.averageIn != AverageIn::display || !mayHaveHalos(sceneState_.hall()))
        return;
    FrameRequest frame = request_.frame;
    const glm::ivec2 size = frame.raster.size;
    const double scale = std::min(1.0, static_cast<double>(halosSide) / std::max(size.x, size.y));
    frame.raster = {glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1))};
    frame.channels = {};
    frame.sample = frame.movingFrame = 0;
    frame.samples = 1;
    frame.resetHistory = frame.finished = true;
    const render::FramePlan plan = museum_.plan(museum_.prepare(sceneState_, frame), frame, backend_.persistentState());
    if (!plan.find(glareSpreadPass)) return;
    (void)backend_.draw(plan);
    halos_ = halosOf(backend_.read(glareSpreadImage), frame.raster.size);
}

bool PictureMaker::step()
{
    if (finished()) return false;
    if (stepsDone_ < drawingSteps())
        drawStep();
    else
        takeObjects(tiles_[stepsDone_ - drawingSteps()]);
    ++stepsDone_;
    if (finished()) finish();
    return true;
}

void PictureMaker::drawStep()
{
    if (stepsDone_ == 0) drawHalos();
    const auto steps = stepsOfTile();
    const Tile& tile = tiles_[stepsDone_ / steps];
    const std::size_t done = stepsDone_ % steps;
    const bool leadsTo = done < request_.motion.size();  // A frame before the requested one.
    const bool takesChannels = request_.motion.empty() ? done == 0 : !leadsTo;
    FrameRequest frame = frameOf(tile, static_cast<int>(done));
    if (!takesChannels) frame.channels = {};
    if (!leadsTo && !prepared_) prepared_ = museum_.prepare(sceneState_, request_.frame);
    const Prepared before = leadsTo ? museum_.prepare(sceneState_, frame) : Prepared();
    render::FrameReport report =
        backend_.draw(museum_.plan(leadsTo ? before : *prepared_, frame, backend_.persistentState()));
    noteDrawn(museum_, report);
    if (takesChannels && stepsDone_ < steps) report_ = std::move(report);
    if (takesChannels) takeChannels(tile);
    if (done + 1 == steps) takeColor(tile);
}

void PictureMaker::takeChannels(const Tile& tile)
{
    int next = 4;
    render::Image depth;
    if (request_.depth || request_.position || request_.before) {
        depth = backend_.read(depthImage);
        const double nearPlane = render::View{}.nearPlane;
        for (float& d : depth.pixels)
            d = d > 0 ? static_cast<float>(nearPlane / d) : std::numeric_limits<float>::infinity();
    }
    if (request_.depth) copyChannels(depth, tile, 0, 1, next++);
    if (request_.frame.channels.normal) {
        copyChannels(backend_.read(normalImage), tile, 0, 3, next);
        next += 3;
    }
    if (request_.frame.channels.evaluations) copyChannels(backend_.read(evaluationsImage), tile, 0, 1, next++);
    if (request_.frame.channels.albedo) {
        copyChannels(backend_.read(albedoImage), tile, 0, 3, next);
        next += 3;
    }
    if (request_.position) {
        takePosition(tile, depth, next);
        next += 3;
    }
    if (request_.before) takeMotion(tile, depth, next);
}

void PictureMaker::takePosition(const Tile& tile, const render::Image& depth, int to)
{
    const glm::ivec2 size = request_.frame.raster.size;
    const render::View view = render::makeView(request_.frame.camera, {size});
    render::Image positions(depth.width, depth.height, 3);
    for (int y = 0; y < depth.height; ++y)
        for (int x = 0; x < depth.width; ++x) {
            const double far = depth.at(x, y);
            if (!std::isfinite(far)) continue;
            const glm::dvec2 pixel(tile.drawnOffset.x + x + 0.5, tile.drawnOffset.y + tile.drawnSize.y - y - 0.5);
            const glm::dvec3 at = view.eye + far * view.direction(2.0 * pixel / glm::dvec2(size) - 1.0);
            for (int c = 0; c < 3; ++c) positions.at(x, y, c) = static_cast<float>(at[c]);
        }
    copyChannels(positions, tile, 0, 3, to);
}

void PictureMaker::takeMotion(const Tile& tile, const render::Image& depth, int to)
{
    const glm::dvec2 size = request_.frame.raster.size;
    const render::View now = render::makeView(request_.frame.camera, {request_.frame.raster.size});
    const render::View before = render::makeView(request_.before->camera, {request_.frame.raster.size});
    render::Image motion(depth.width, depth.height, 2);
    for (int y = 0; y < depth.height; ++y)
        for (int x = 0; x < depth.width; ++x) {
            const glm::dvec2 pixel(tile.drawnOffset.x + x + 0.5, tile.drawnOffset.y + tile.drawnSize.y - y - 0.5);
            const glm::dvec3 ray = now.direction(2.0 * pixel / size - 1.0);
            const double far = depth.at(x, y);
            // The sky is infinitely far, so only turns of the camera move it.
            const glm::dvec4 seen = std::isfinite(far) ? glm::dvec4(now.eye + far * ray, 1) : glm::dvec4(ray, 0);
            const glm::dvec4 clip = before.clipFromWorld * seen;
            if (!(clip.w > 0)) continue;
            const glm::dvec2 was = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * size;
            for (int c = 0; c < 2; ++c) motion.at(x, y, c) = static_cast<float>(was[c] - pixel[c]);
        }
    copyChannels(motion, tile, 0, 2, to);
}

/// Draws the tile, then each exhibit without anything else. An exhibit is seen where it is as near as what was drawn.
void PictureMaker::takeObjects(const Tile& tile)
{
    FrameRequest frame = frameOf(tile, 0);
    frame.channels = {};
    const auto depthOf = [&](const FrameRequest& request) {
        (void)backend_.draw(museum_.plan(*prepared_, request, backend_.persistentState()));
        return backend_.read(depthImage);
    };
    const auto idOf = [&](std::size_t i) { return cryptomatteId(museum_.subject(i).name()); };
    const render::Image all = depthOf(frame);
    const std::optional<std::size_t> only = frame.alone ? frame.alone : frame.cutOut;
    const float rest = idOf(only.value_or(hallIndex));
    render::Image objects(all.width, all.height, 4);
    const auto mark = [&](const render::Image& depth, float id) {
        constexpr float rounding = 1e-4F;  // Relative difference of a surface's depth between two shaders.
        for (std::size_t i = 0; i < all.pixels.size(); ++i) {
            if (!(depth.pixels[i] > 0) || depth.pixels[i] < all.pixels[i] * (1 - rounding)) continue;
            objects.pixels[4 * i] = id;
            objects.pixels[4 * i + 1] = 1;  // Coverage.
        }
    };
    mark(all, rest);
    for (const MuseumExhibit& each : museum_.exhibits()) {
        if (only || !museum_.isInHall(each.index) || capability<OverFrame>(each.exhibit)) continue;
        frame.cutOut = each.index;
        mark(depthOf(frame), idOf(each.index));
    }
    copyChannels(objects, tile, 0, 4, picture_.channels - 4);
}

void PictureMaker::takeColor(const Tile& tile)
{
    copyChannels(backend_.read("frame"), tile, 0, 4, 0);
}

void PictureMaker::copyChannels(const render::Image& from, const Tile& tile, int first, int count, int to)
{
    const int top = picture_.height - tile.offset.y - tile.size.y;
    const int left = tile.offset.x - tile.drawnOffset.x;
    const int above = tile.drawnOffset.y + tile.drawnSize.y - tile.offset.y - tile.size.y;
    for (int y = 0; y < tile.size.y; ++y)
        for (int x = 0; x < tile.size.x; ++x)
            for (int c = 0; c < count; ++c)
                picture_.at(tile.offset.x + x, top + y, to + c) = from.at(left + x, above + y, first + c);
}

void PictureMaker::finish()
{
    for (int y = 0; y < picture_.height; ++y) {
        for (int x = 0; x < picture_.width; ++x) {
            const float alpha = picture_.at(x, y, 3);
            if (alpha > 0 && alpha < 1)
                for (int c = 0; c < 3; ++c) picture_.at(x, y, c) /= alpha;
        }
    }
}

}  // namespace vitrine

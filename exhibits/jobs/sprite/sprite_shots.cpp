#include "exhibits/jobs/sprite/sprite_shots.h"

#include "exhibits/pixel_art/pixel_passes.h"
#include "exhibits/pixel_art/small_world.h"
#include "exhibits/pixel_art/visitor_model.h"
#include "exhibits/pixel_art/world_builder.h"
#include "render/failure.h"
#include "render/hash.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::jobs {

/// Extent that contains every vertex of every frame from every direction: half the width, and the lowest and highest
/// position.
struct SpriteExtent {
    double across = 0, low = 1e30, high = -1e30;

    void include(const std::vector<pixel_art::WorldPart>& parts, double elevation)
    {
        for (const pixel_art::WorldPart& part : parts)
            for (const render::Vertex& vertex : part.mesh->vertices) {
                const glm::dvec3 p(part.worldFromModel * glm::dvec4(glm::dvec3(vertex.position), 1));
                const double out = std::hypot(p.x, p.z);
                const double up = p.y * std::cos(elevation);
                const double tip = out * std::abs(std::sin(elevation));
                across = std::max(across, out);
                low = std::min(low, up - tip);
                high = std::max(high, up + tip);
            }
    }
};

namespace {

std::vector<pixel_art::WorldPart> pillarWithTorus(double turn)
{
    static const auto pillar = [] {
        pixel_art::WorldBuilder b("pillar");
        const pixel_art::Paint marble{{0.76, 0.70, 0.62}};
        b.object().at(glm::dvec3(0)).prism(8, 0.62, 0.56, 0.16, marble);
        b.object().at(glm::dvec3(0, 0.16, 0)).prism(12, 0.26, 0.22, 0.8, marble, true);
        b.object().at(glm::dvec3(0, 0.96, 0)).prism(8, 0.4, 0.4, 0.14, marble);
        return b.finished();
    }();
    static const auto torus =
        pixel_art::WorldBuilder("torus").object().torus(0.4, 0.13, {{0.95, 0.58, 0.10}}).finished();
    glm::dmat4 m = glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0, 1.75, 0)), turn, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, turn + 1.1, glm::dvec3(1, 0, 0));
    return {{pillar, glm::dmat4(1), 0}, {torus, m, 10}};
}

const pixel_art::PixelArtTable& lookTable()
{
    static const pixel_art::PixelArtTable table;
    return table;
}

pixel_art::PixelCamera spriteCamera(const SpriteExtent& e, const SpriteRequest& request, double elevation,
                                    double azimuth)
{
    pixel_art::PixelCamera camera;
    camera.size = request.size;
    camera.elevation = elevation;
    camera.azimuth = azimuth;
    const double aspect = static_cast<double>(request.size.x) / request.size.y;
    const double margin = static_cast<double>(request.size.y) / std::max(request.size.y - 2, 1);
    camera.tall = std::max({e.high - e.low, 2 * e.across / aspect, 1e-6}) * margin;
    const double middle = 0.5 * (e.high + e.low);
    const glm::dvec3 up(-std::sin(azimuth) * std::sin(elevation), std::cos(elevation),
                        -std::cos(azimuth) * std::sin(elevation));
    camera.target = up * middle;
    camera.distance = 50;
    return camera;
}

/// Copies color, normal and depth of the translucent parts to pixels that no opaque surface covers.
void addTranslucent(render::RenderBackend& backend, SpriteFrame& frame, render::Image& depth)
{
    const render::Image over = backend.read(pixel_art::pixelTranslucentImage);
    const render::Image normal = backend.read(pixel_art::pixelTranslucentNormalImage);
    const render::Image overDepth = backend.read(pixel_art::pixelTranslucentDepthImage);
    const auto channels = static_cast<std::size_t>(overDepth.channels);
    for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
        const float opacity = over.pixels[4 * i + 3];
        if (depth.pixels[i] > 0 || !(opacity > 0)) continue;
        for (std::size_t k = 4 * i; k < 4 * i + 3; ++k) {
            frame.color.pixels[k] = std::min(over.pixels[k] / opacity, 1.0F);
            frame.normal.pixels[k] = normal.pixels[k];
        }
        frame.color.pixels[4 * i + 3] = std::min(opacity, 1.0F);
        depth.pixels[i] = overDepth.pixels[channels * i];
    }
}

/// Reads a frame: coverage separate from color, and depth within the object's own range. `origin` is that of the
/// object, in the small world.
SpriteFrame frameOf(render::RenderBackend& backend, const pixel_art::PixelBlock& block,
                    const pixel_art::PixelShot& shot, const glm::dvec3& origin, int direction)
{
    SpriteFrame frame;
    frame.direction = direction;
    frame.color = backend.read(pixel_art::pixelLitImage);
    frame.normal = pixel_art::normalsOf(backend.read(pixel_art::pixelSurfaceImage));
    render::Image depth = backend.read(pixel_art::pixelDrawnDepthImage);
    for (std::size_t i = 0; i < depth.pixels.size(); ++i) frame.color.pixels[4 * i + 3] = depth.pixels[i] > 0 ? 1 : 0;
    if (pixel_art::hasTranslucent(shot.parts)) addTranslucent(backend, frame, depth);
    frame.depth = render::Image(depth.width, depth.height, 1);
    float nearest = 0, farthest = 1;
    for (const float d : depth.pixels)
        if (d > 0) {
            nearest = std::max(nearest, d);
            farthest = std::min(farthest, d);
        }
    const float span = std::max(nearest - farthest, 1e-9F);
    for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
        const bool seen = depth.pixels[i] > 0;
        frame.normal.pixels[4 * i + 3] = seen ? 1.0F : 0.0F;
        // 0 is reserved for empty pixels.
        if (seen) frame.depth.pixels[i] = (1 + 254 * (depth.pixels[i] - farthest) / span) / 255;
    }
    const glm::dvec4 view = glm::inverse(glm::dmat4(block.worldFromView)) * glm::dvec4(origin, 1);
    const glm::dvec2 half(block.halfExtent);
    const glm::dvec2 ndc = glm::dvec2(view) / half;
    frame.pivot = glm::dvec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * glm::dvec2(shot.camera.size);
    return frame;
}

}  // namespace

int SpriteSubject::animationOf(const SpriteRequest& request) const
{
    const auto& all = model_->animations();
    if (request.animation.empty()) return all.empty() ? -1 : 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name == request.animation) return static_cast<int>(i);
    std::vector<std::string> names;
    for (const auto& animation : all) names.push_back(animation.name);
    throw Failure(ErrorKind::usage, "There is no animation \"" + request.animation + "\"" +
                                        (names.empty() ? "; the file has none."
                                                       : didYouMean(request.animation, names) + " the file has " +
                                                             joined(names, ", ") + "."));
}

double SpriteSubject::duration(const SpriteRequest& request) const
{
    if (!model_) return pixel_art::worldRound;
    const int i = animationOf(request);
    return i < 0 ? 1 : model_->animations()[static_cast<std::size_t>(i)].duration;
}

std::vector<std::string> SpriteSubject::animations() const
{
    std::vector<std::string> names;
    if (model_)
        for (const auto& animation : model_->animations()) names.push_back(animation.name);
    return names;
}

std::vector<std::string> SpriteSubject::warnings() const
{
    if (!model_) return {};
    std::vector<std::string> sentences;
    for (const Message& warning : model_->posed(-1, 0).warnings) sentences.push_back(warning.english());
    return sentences;
}

std::vector<pixel_art::WorldPart> SpriteSubject::parts(const SpriteRequest& request, int i) const
{
    const double share = static_cast<double>(i) / std::max(request.frames, 1);
    if (!model_) return pillarWithTorus(2 * std::numbers::pi * share);
    const render::Model posed = model_->posed(animationOf(request), share * duration(request));
    std::vector<pixel_art::WorldPart> parts;
    int id = 0;
    for (const render::MeshInstance& part : posed.parts)
        parts.push_back({part.mesh, part.modelFromPart, ++id, part.material});
    return parts;
}

struct SpriteShots::Scene {
    std::vector<std::vector<pixel_art::WorldPart>> poses;
    std::vector<glm::dvec3> origins;  ///< Origin of the object in the small world, for each pose.
    SpriteExtent extent;
};

namespace {

/// Returns the box around all vertices.
render::Box exactBounds(const std::vector<pixel_art::WorldPart>& parts)
{
    render::Box box;
    for (const pixel_art::WorldPart& part : parts)
        for (const render::Vertex& vertex : part.mesh->vertices)
            box.include(glm::dvec3(part.worldFromModel * glm::dvec4(glm::dvec3(vertex.position), 1)));
    return box;
}

double largestSide(const render::Box& box)
{
    const glm::dvec3 size = box.high - box.low;
    return std::max({size.x, size.y, size.z});
}

/// Returns the distance that the object travels during the animation if it is removed from the frames; otherwise 0.
glm::dvec3 travel(const std::vector<render::Box>& boxes, const render::Box& end, SpriteMotion motion)
{
    if (motion == SpriteMotion::kept || boxes.front().empty() || end.empty()) return glm::dvec3(0);
    const glm::dvec3 way = end.center() - boxes.front().center();
    double size = largestSide(end);
    for (const render::Box& box : boxes)
        if (!box.empty()) size = std::max(size, largestSide(box));
    return motion == SpriteMotion::inPlace || glm::length(way) > size ? way : glm::dvec3(0);
}

/// Returns the center of rotation, at the height of the center of the box. It lies on the vertical axis through the
/// origin if that axis meets the box, else it is the center of the box.
glm::dvec3 turningPoint(const render::Box& box)
{
    const bool standsOverOrigin = box.low.x <= 0 && box.high.x >= 0 && box.low.z <= 0 && box.high.z >= 0;
    return standsOverOrigin ? glm::dvec3(0, box.center().y, 0) : box.center();
}

}  // namespace

SpriteShots::SpriteShots(ParameterValues look, std::shared_ptr<const SpriteSubject> subject, SpriteRequest request)
    : look_(std::move(look)), subject_(std::move(subject)), request_(std::move(request))
{
    const pixel_art::PixelArtTable& table = lookTable();
    look_.set(table.split, false);
    look_.set(table.snap, false);
    look_.set(table.palette, pixel_art::PaletteName::none);
    look_.set(table.view, pixel_art::PixelView::finished);
    look_.set(table.projection, pixel_art::PixelProjection::orthographic);
    // Sprites can use the drawn normals, unless the settings choose another method.
    if (look_.isInitial(table.method.row)) look_.set(table.method, pixel_art::NormalsBy::trueNormals);
}

SpriteShots::~SpriteShots() = default;

bool SpriteShots::finished() const
{
    return scene_ && progress() >= 1;
}

double SpriteShots::progress() const
{
    return static_cast<double>(frames_.size()) / std::max(request_.directions * request_.frames, 1);
}

void SpriteShots::pose()
{
    auto scene = std::make_unique<Scene>();
    std::vector<render::Box> boxes;
    for (int i = 0; i < request_.frames; ++i) {
        scene->poses.push_back(subject_->parts(request_, i));
        boxes.push_back(exactBounds(scene->poses.back()));
    }
    const glm::dvec3 way = travel(boxes, exactBounds(subject_->parts(request_, request_.frames)), request_.motion);
    render::Box all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].empty()) continue;
        const glm::dvec3 gone = way * (static_cast<double>(i) / request_.frames);
        all.include(boxes[i].low - gone);
        all.include(boxes[i].high - gone);
    }
    if (const Message why = render::whyNothingIsSeen(subject_->name(), all); !why.empty())
        throw Failure(ErrorKind::file, why);
    const glm::dvec3 middle = turningPoint(all);
    SpriteExtent& extent = scene->extent;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        scene->origins.push_back(-middle - way * (static_cast<double>(i) / request_.frames));
        const glm::dmat4 moved = glm::translate(glm::dmat4(1), scene->origins.back());
        for (pixel_art::WorldPart& part : scene->poses[i]) part.worldFromModel = moved * part.worldFromModel;
        extent.include(scene->poses[i], look_[lookTable().elevation]);
    }
    // The model is scaled to a fixed size, because shadows and thresholds are in meters of the small world.
    const double scale = 3 / std::max({extent.across, 0.5 * (extent.high - extent.low), 1e-9});
    for (auto& pose : scene->poses)
        for (pixel_art::WorldPart& part : pose)
            part.worldFromModel = glm::scale(glm::dmat4(1), glm::dvec3(scale)) * part.worldFromModel;
    for (glm::dvec3& origin : scene->origins) origin *= scale;
    extent = {extent.across * scale, extent.low * scale, extent.high * scale};
    scene_ = std::move(scene);
}

void SpriteShots::step(render::RenderBackend& backend)
{
    if (!scene_) {
        pose();
        return;
    }
    const pixel_art::PixelArtTable& table = lookTable();
    const int d = static_cast<int>(frames_.size()) / request_.frames;
    const int i = static_cast<int>(frames_.size()) % request_.frames;
    ParameterValues values = look_;
    const double azimuth = look_[table.azimuth] + 2 * std::numbers::pi * d / request_.directions;
    values.setParameter(table.azimuth.row, std::remainder(azimuth, 2 * std::numbers::pi));
    pixel_art::PixelShot shot{table, values, spriteCamera(scene_->extent, request_, values[table.elevation], azimuth)};
    shot.parts = scene_->poses[static_cast<std::size_t>(i)];
    shot.partsId = render::Hash().addValue(d).addValue(i).value();
    render::FramePlan plan;
    plan.view.raster.size = request_.size;
    plan.allSlices = true;
    const pixel_art::PixelBlock block = pixel_art::planPixelPicture(shot, plan);
    std::vector<std::string> outputs{pixel_art::pixelLitImage, pixel_art::pixelSurfaceImage,
                                     pixel_art::pixelDrawnDepthImage};
    if (pixel_art::hasTranslucent(shot.parts))
        outputs.insert(outputs.end(), {pixel_art::pixelTranslucentImage, pixel_art::pixelTranslucentNormalImage,
                                       pixel_art::pixelTranslucentDepthImage});
    plan.prune(outputs);
    backend.draw(plan);
    frames_.push_back(frameOf(backend, block, shot, scene_->origins[static_cast<std::size_t>(i)], d));
    frames_.back().azimuth = azimuth;
    if (finished() &&
        std::none_of(frames_.begin(), frames_.end(), [](const SpriteFrame& f) { return seenPixels(f) > 0; }))
        throw Failure(ErrorKind::file, "Nothing of " + subject_->name() +
                                           " is to be seen: every pixel of every frame is empty; choose an object with "
                                           "more opacity, or larger frames.");
}

std::vector<SpriteFrame> drawSprite(const ParameterValues& look, const SpriteSubject& subject,
                                    const SpriteRequest& request, render::RenderBackend& backend)
{
    SpriteShots shots(look, std::make_shared<SpriteSubject>(subject), request);
    while (!shots.finished()) shots.step(backend);
    return std::move(shots.frames());
}

}  // namespace vitrine::jobs

#include "exhibits/kit/backdrop.h"

#include "exhibits/framework/scene/exhibit.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <bit>

namespace vitrine {
namespace {

using render::Attachment;

constexpr int blurLevels = 7;  ///< The last level blurs over 64 pixels.

constexpr const char* sharpPass = "kit/backdrop";
constexpr const char* blurredPass = "kit/backdrop/blurred";
constexpr const char* mirroredPass = "kit/backdrop/mirrored";
constexpr const char* mirroredImage = "backdrop.mirrored";
constexpr const char* mirroredWay = "backdrop.mirrored.way";
constexpr const char* sharpImage = "backdrop.radiance";
constexpr const char* blurredImage = "backdrop.blurred";
constexpr const char* backdropDepth = "backdrop.depth";

render::Pass copyPass(const char* name, const char* reason)
{
    render::Pass copy;
    copy.name = name;
    copy.reason = reason;
    copy.phase = render::PassPhase::transparent;
    copy.draws = {render::Draw{}};
    return copy;
}

/// Returns the number of mip levels of an image, down to one pixel.
int largestLevels(glm::ivec2 size)
{
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max({size.x, size.y, 1}))));
}

render::ImageInfo pictureImage(const render::FramePlan& plan, const char* name, int levels)
{
    const auto picture = plan.images().find(radianceImage);
    return {.name = name,
            .format = picture == plan.images().end() ? render::Format::rgba16f : picture->second.format,
            .levels = std::min(levels, largestLevels(plan.view.raster.drawn()))};
}

/// Plans a copy of the picture after all opaque passes.
void planSharp(render::FramePlan& plan)
{
    if (plan.find(sharpPass)) return;
    plan.image(pictureImage(plan, sharpImage, 1));
    plan.image({.name = backdropDepth, .format = render::Format::r32f, .nearest = true});
    render::Pass copy = copyPass(sharpPass, "glass or the floor shows what is drawn");
    copy.shader = {.vertex = "lib/fullscreen.vert", .fragment = "kit/backdrop.frag"};
    copy.inputs = {{UNIT_BACKDROP, std::string(radianceImage)}, {UNIT_BACKDROP_DEPTH, std::string(depthImage)}};
    copy.colors = {Attachment::whole(sharpImage), Attachment::whole(backdropDepth)};
    plan.add(std::move(copy));
}

/// Plans the mip levels of that copy.
void planBlurred(render::FramePlan& plan)
{
    if (plan.find(blurredPass)) return;
    plan.image(pictureImage(plan, blurredImage, blurLevels));
    render::Pass copy = copyPass(blurredPass, "rough glass shows what is behind it");
    copy.shader = {.vertex = "lib/fullscreen.vert", .fragment = "lib/copy.frag"};
    copy.inputs = {{UNIT_SOURCE, std::string(sharpImage)}};
    copy.colors = {Attachment::whole(blurredImage)};
    copy.mipmaps = {blurredImage};
    plan.add(std::move(copy));
}

}  // namespace

void seeThrough(render::Pass& pass, render::FramePlan& plan, bool blurred)
{
    planSharp(plan);
    if (blurred) planBlurred(plan);
    pass.phase = render::PassPhase::transparent;
    pass.shader.defines.emplace_back("BACKDROP");
    pass.inputs.push_back({UNIT_BACKDROP, std::string(blurred ? blurredImage : sharpImage)});
    pass.inputs.push_back({UNIT_BACKDROP_DEPTH, std::string(backdropDepth)});
}

void mirrorPicture(render::Pass& pass, render::FramePlan& plan)
{
    planSharp(plan);
    render::ImageInfo way = pictureImage(plan, mirroredWay, blurLevels);
    way.format = render::Format::r32f;
    plan.image(pictureImage(plan, mirroredImage, blurLevels));
    plan.image(way);
    render::Pass find = copyPass(mirroredPass, "the floor mirrors what the picture shows");
    find.shader = {.vertex = "lib/fullscreen.vert", .fragment = "kit/mirrored.frag"};
    find.inputs = {{UNIT_BACKDROP, std::string(sharpImage)}, {UNIT_BACKDROP_DEPTH, std::string(backdropDepth)}};
    find.colors = {Attachment::whole(mirroredImage), Attachment::whole(mirroredWay)};
    find.mipmaps = {mirroredImage, mirroredWay};
    plan.add(std::move(find));
    pass.phase = render::PassPhase::transparent;
    pass.shader.defines.emplace_back("MIRROR_PICTURE");
    pass.inputs.push_back({UNIT_BACKDROP, mirroredImage});
    pass.inputs.push_back({UNIT_BACKDROP_DEPTH, mirroredWay});
}

std::string depthBehindGlass(const render::FramePlan& plan)
{
    return plan.find(sharpPass) ? backdropDepth : depthImage;
}

}  // namespace vitrine

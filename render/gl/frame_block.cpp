#include "render/gl/frame_block.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <cmath>

namespace vitrine::render::gl {

FrameBlock frameBlock(const View& view, double time, int sample, std::uint32_t seed)
{
    const Raster& raster = view.raster;
    const glm::dvec2 size = glm::max(raster.size, glm::ivec2(1));
    const double day = 86400;
    const double wrapped = std::isfinite(time) ? time - day * std::floor(time / day) : 0;
    FrameBlock block;
    block.clipFromView = glm::mat4(view.clipFromView);
    block.clipFromWorld = glm::mat4(view.clipFromWorld);
    block.worldFromView = glm::mat4(glm::affineInverse(view.viewFromWorld));
    block.eye = glm::vec3(view.eye);
    block.nearPlane = static_cast<float>(view.nearPlane);
    block.size = glm::vec2(size);
    block.inverseSize = glm::vec2(1.0 / size);
    block.tileOrigin = glm::vec2(glm::dvec2(raster.offset) + raster.jitter);
    block.tanHalfFov = glm::vec2(view.tanHalfFov);
    block.tanShift = glm::vec2(view.tanShift);
    block.time = static_cast<float>(wrapped);
    block.sampleIndex = sample;
    block.seed = seed;
    block.pixelAngle = static_cast<float>(2 * view.tanHalfFov.y / size.y);
    return block;
}

TemporalBlock temporalBlock(const Pass& pass, int part, bool valid)
{
    Raster raster = pass.temporal.lastView.raster;
    raster.jitter = glm::dvec2(0);
    TemporalBlock block;
    block.previousClipFromWorld = glm::mat4(withRaster(pass.temporal.lastView, raster).clipFromWorld);
    block.isValid = valid;
    block.slice = part;
    block.sliceCount = pass.sliceCount;
    return block;
}

}  // namespace vitrine::render::gl

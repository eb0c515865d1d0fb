#pragma once

#include "render/gl/resources.h"
#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

/// The framebuffer of one raster pass, bound, cleared as asked and with its viewport, until destroyed.
class Target {
public:
    Target(const Pass&, const Resources&);

private:
    FramebufferName framebuffer_;
};

void applyState(const RasterState&);

/// Binds the writable images of a compute pass, dispatches it and makes its writes visible.
void dispatch(const Pass&, const Resources&);

}  // namespace vitrine::render::gl

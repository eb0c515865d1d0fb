#pragma once

#include "render/gl/resources.h"
#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

/// Binds the framebuffer of one raster pass, with its viewport, and if it `clears` (of work in
/// several parts, only the first one does) clears what the pass wants cleared.
void bindTarget(const Pass&, Resources&, bool clears);

void applyState(const RasterState&);
/// Which faces the next draw leaves out.
void applyCulling(Cull);

/// Draws these columns alone (`Pass::columns`); unset: all.
void limitTo(const std::optional<glm::ivec2>& columns);

/// Binds the writable images of a compute pass, dispatches it and makes its writes visible.
void dispatch(const Pass&, const Resources&);

}  // namespace vitrine::render::gl

#pragma once

#include "render/gl/resources.h"
#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

/// Binds the framebuffer of a raster pass and sets its viewport. If `clears`, clears the attachments that the pass
/// wants cleared; in a sliced pass only the first slice clears.
void bindTarget(const Pass&, Resources&, bool clears);

void applyState(const RasterState&);
/// Sets which faces the next draw culls.
void applyCulling(Cull);

/// Restricts drawing to these columns (`Pass::columns`); unset: no restriction.
void limitTo(const std::optional<glm::ivec2>& columns);
/// The same, also for rows: `rows` are the first one and that behind the last one, counted from the bottom.
void limitTo(const std::optional<glm::ivec2>& columns, glm::ivec2 rows);

/// Binds the writable images of a compute pass, dispatches it and makes its writes visible.
void dispatch(const Pass&, const Resources&);

}  // namespace vitrine::render::gl

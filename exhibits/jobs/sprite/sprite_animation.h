#pragma once

#include "exhibits/jobs/sprite/sprite_sheet.h"
#include "render/files/atomic_write.h"
#include "render/video/video_file.h"

#include <filesystem>
#include <memory>

namespace vitrine::jobs {

/// Returns size, rate and format of the animated picture (`SpriteTable::animated`) of a sheet whose frames last
/// `frameSeconds`. A single frame per direction is shown for a quarter of a second at least.
[[nodiscard]] render::VideoSpec animationSpec(const ParameterValues&, int framesPerDirection, double frameSeconds);

/// Returns frame `i` of the sheet as it is in the animated picture, enlarged to `spec`: RGBA, linear. Without
/// transparency it is over a middle gray.
[[nodiscard]] render::Image animationFrame(const SpriteSheet&, std::size_t i, glm::ivec2 frameSize,
                                           const render::VideoSpec& spec);

/// Writes the animated picture beside `file`. Throws Failure as render::VideoFile.
[[nodiscard]] std::unique_ptr<render::PartFile> stagedAnimation(const SpriteSheet&, const ParameterValues&,
                                                                const render::VideoSpec&,
                                                                const std::filesystem::path& file);

}  // namespace vitrine::jobs

#pragma once

#include "exhibits/jobs/kit/job.h"
#include "render/image/image.h"
#include "render/image/video_codec.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <vector>

namespace vitrine::jobs {

/// Returns a name in the folder for temporary files, with the extension of `out`, for staging a draft.
[[nodiscard]] std::filesystem::path draftFile(const std::filesystem::path& out);
/// Shrinks width and height of a draft, in pixels, so that the longer side of `size` becomes at most `side`. Values of
/// 0 stay.
void shrinkTo(int side, glm::ivec2 size, ParameterValues& draft, Count width, Count height);
/// Returns the size in bytes of a file with this picture, whose format is that of the extension of `out`. Throws
/// Failure as render::stagedPicture does, and if there is no such format.
[[nodiscard]] double pictureBytes(const render::Image&, const std::filesystem::path& out);
/// Returns the size in bytes of a video of these frames. Throws Failure as render::VideoFile does.
[[nodiscard]] double videoBytes(const std::vector<render::Image>& frames, const render::VideoSpec&,
                                const std::filesystem::path& out);

/// Returns the expected size of a file whose picture has `more` times the pixels of a draft of `bytes`. Neighboring
/// pixels of a larger picture are more alike, so that a compressed file grows slower than their number. The extension
/// of `out` decides how much slower.
[[nodiscard]] double grownBytes(double bytes, double more, const std::filesystem::path& out);

/// Returns the fact on an expected size, with two digits: "File about 1.2 MB".
[[nodiscard]] Fact fileAbout(double bytes);

}  // namespace vitrine::jobs

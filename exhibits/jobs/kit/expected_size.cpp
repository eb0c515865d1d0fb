#include "exhibits/jobs/kit/expected_size.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/extension.h"
#include "render/image/image_io.h"
#include "render/video/video_file.h"

#include <algorithm>
#include <cmath>

namespace vitrine::jobs {

std::filesystem::path draftFile(const std::filesystem::path& out)
{
    return std::filesystem::temp_directory_path() / ("vitrine-draft" + render::lowerExtension(out));
}

void shrinkTo(int side, glm::ivec2 size, ParameterValues& draft, Count width, Count height)
{
    const double share = side / static_cast<double>(std::max({size.x, size.y, side}));
    for (const Count length : {width, height})
        if (draft[length] > 0) draft.set(length, std::max(1, static_cast<int>(std::lround(draft[length] * share))));
}

double pictureBytes(const render::Image& picture, const std::filesystem::path& out)
{
    const std::filesystem::path file = draftFile(out);
    const auto format = render::writtenFormat(file);
    if (!format) throw Failure(ErrorKind::usage, out.string() + " is no name of a picture.");
    return static_cast<double>(std::filesystem::file_size(render::stagedPicture(file, picture, *format)->path()));
}

double videoBytes(const std::vector<render::Image>& frames, const render::VideoSpec& spec,
                  const std::filesystem::path& out)
{
    render::VideoFile video(draftFile(out), spec);
    for (const render::Image& frame : frames) video.add(frame);
    return static_cast<double>(std::filesystem::file_size(video.staged()->path()));
}

double grownBytes(double bytes, double more, const std::filesystem::path& out)
{
    // Exponents that pictures of the museum have from 480 × 270 to 1280 × 720 pixels. OpenEXR hardly compresses them.
    const render::PictureFileFormat* format = render::formatNamed(out);
    const double growth = !format                                       ? 0.88
                          : format->isLinear                            ? 1
                          : format->format == render::ImageFormat::jpeg ? 0.78
                                                                        : 0.88;
    return bytes * std::pow(more, growth);
}

Fact fileAbout(double bytes)
{
    const double unit = std::pow(10.0, std::floor(std::log10(std::max(bytes, 1.0))) - 1);
    const double rounded = std::round(bytes / unit) * unit;
    return rounded < 1e6 ? Fact{"File about", std::max(rounded / 1e3, 0.1), "kB"}
                         : Fact{"File about", rounded / 1e6, "MB"};
}

}  // namespace vitrine::jobs

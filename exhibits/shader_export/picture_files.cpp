#include "exhibits/shader_export/picture_files.h"

#include "render/failure.h"
#include "render/files/read_file.h"

#include <algorithm>

namespace vitrine::guest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostPictureBytes = 64U << 20U;

}  // namespace

std::string pictureBytes(const fs::path& shader, const std::string& picture)
{
    const fs::path folder = fs::absolute(shader).parent_path();
    return render::readFileBeneath(folder, picture, mostPictureBytes);
}

std::string besideOutput(const fs::path& shader, const std::string& picture, const fs::path& out, ExportedFiles& files)
{
    const fs::path from = fs::absolute(shader).parent_path(), to = fs::absolute(out).parent_path();
    std::error_code error;
    if (fs::equivalent(from, to, error)) return picture;
    std::string bytes = pictureBytes(shader, picture);
    const fs::path target = to / fs::path(picture).filename();
    if (fs::exists(target, error)) {
        if (render::readFile(target, mostPictureBytes) != bytes)
            throw Failure(ErrorKind::file,
                          message("Cannot copy {1} beside the output: {2} is another picture; choose another folder.",
                                  picture, target));
    } else if (std::none_of(files.files.begin(), files.files.end(),
                            [&](const render::NamedBytes& each) { return each.path == target; })) {
        files.files.push_back({target, std::move(bytes)});
    }
    return target.filename().string();
}

}  // namespace vitrine::guest

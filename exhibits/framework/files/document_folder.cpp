#include "exhibits/framework/files/document_folder.h"

#include "exhibits/framework/files/slug.h"
#include "exhibits/framework/files/state_folder.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/image/image_limits.h"

#include <cerrno>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// Moves a file; copies it if the target is on another file system.
void moveFile(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    fs::rename(from, to, error);
    if (error.value() == EXDEV) {
        writeOwnFile(to, render::readFile(from, render::ImageLimits{}.fileBytes));
        fs::remove(from, error);
    }
    if (error)
        throw Failure(ErrorKind::file,
                      message("Cannot move {1} to {2}: {3}; check your permissions.", from, to, error.message()));
}

}  // namespace

std::vector<fs::path> documentsIn(const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(folder, error))
        if (file.path().extension() == ".json" && !file.path().filename().string().starts_with('.'))
            files.push_back(file.path());
    return files;
}

RemovedDocument removeDocument(const fs::path& path, const fs::path& trash, const std::string& companion)
{
    const fs::path trashed = freePath(trash, path.stem().string());
    moveFile(path, trashed);
    moveCompanion(path, trashed, companion);
    return {path, trashed};
}

fs::path restoreDocument(const RemovedDocument& removed, const std::string& companion)
{
    const fs::path to = freePath(removed.original.parent_path(), removed.original.stem().string());
    moveFile(removed.trashed, to);
    moveCompanion(removed.trashed, to, companion);
    return to;
}

void moveCompanion(fs::path from, fs::path to, const std::string& companion)
{
    std::error_code error;
    if (!fs::exists(from.replace_extension(companion), error)) return;
    try {
        moveFile(from, to.replace_extension(companion));
    } catch (const Failure&) {
        fs::remove(from, error);
    }
}

}  // namespace vitrine

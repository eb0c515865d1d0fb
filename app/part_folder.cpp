#include "app/part_folder.h"

#include "render/failure.h"

#include <unistd.h>

#include <utility>
#include <vector>

namespace vitrine::app {

namespace fs = std::filesystem;

void requireFolderFor(const fs::path& folder, const std::string& mark, const std::string& what)
{
    std::error_code error;
    if (!fs::exists(folder, error)) return;
    if (!fs::is_directory(folder, error))
        throw Failure(Blame::usage, "--out " + folder.string() + ": this is a file; name a folder.");
    if (!fs::is_empty(folder, error) && !fs::exists(folder / mark, error))
        throw Failure(Blame::usage, "--out " + folder.string() + ": this folder holds something else than " + what +
                                        "; name another.");
}

namespace {

/// Moves what lies in one folder and is not in the other over there, but for pictures, which are the program's.
/// Returns whether all of it could be moved.
bool keepForeign(const fs::path& from, const fs::path& to, bool picturesToo)
{
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(from, error), end; !error && entry != end; entry.increment(error))
        if (picturesToo || entry->path().extension() != ".png") found.push_back(entry->path());
    bool moved = !error;
    for (const fs::path& path : found) {
        const fs::path place = to / path.filename();
        if (fs::exists(place, error)) continue;
        fs::rename(path, place, error);
        moved = moved && !error;
    }
    return moved;
}

}  // namespace

PartFolder::PartFolder(fs::path target) : target_(std::move(target)), part_(target_)
{
    if (!part_.has_filename()) part_ = target_ = target_.parent_path();  // "DIR/" is DIR.
    part_ += ".part-" + std::to_string(getpid());
    std::error_code error;
    fs::create_directories(part_ / "pictures", error);
    if (error)
        throw Failure(Blame::file, target_.string() + ": the folder cannot be made (" + error.message() +
                                       "); choose another with --out.");
}

PartFolder::~PartFolder()
{
    std::error_code ignored;
    fs::remove_all(part_, ignored);
}

void PartFolder::publish() const
{
    fs::path old = target_;
    old += ".old-" + std::to_string(getpid());
    std::error_code error;
    const bool replaces = fs::exists(target_, error);
    if (replaces) fs::rename(target_, old, error);
    if (!error) fs::rename(part_, target_, error);
    if (error) {
        std::error_code ignored;
        if (replaces && fs::exists(old, ignored)) fs::rename(old, target_, ignored);
        throw Failure(Blame::file, target_.string() + ": the folder cannot be put in place (" + error.message() +
                                       "); choose another with --out.");
    }
    if (!replaces) return;
    const bool pictures = fs::is_directory(old / "pictures", error);
    if (keepForeign(old, target_, true) && (!pictures || keepForeign(old / "pictures", target_ / "pictures", false)))
        fs::remove_all(old, error);
}

}  // namespace vitrine::app

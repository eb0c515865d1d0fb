#include "exhibits/jobs/kit/part_folder.h"

#include "render/failure.h"

#include <fcntl.h>
#include <stdio.h>

#include <utility>
#include <vector>

namespace vitrine::jobs {

namespace fs = std::filesystem;

void requireFolderFor(const fs::path& folder, const std::string& mark, const std::string& what)
{
    std::error_code error;
    if (!fs::exists(folder, error)) return;
    if (!fs::is_directory(folder, error))
        throw Failure(ErrorKind::usage, "--out " + folder.string() + ": this is a file; name a folder.");
    if (!fs::is_empty(folder, error) && !fs::exists(folder / mark, error))
        throw Failure(ErrorKind::usage, "--out " + folder.string() + ": this folder holds something else than " + what +
                                            "; name another.");
}

namespace {

[[noreturn]] void refuseFolder(const fs::path& out, const std::error_code& why)
{
    throw Failure(ErrorKind::file,
                  out.string() + ": the folder cannot be made (" + why.message() + "); choose another with --out.");
}

/// Moves files of one folder that are missing in the other to it. Pictures are the program's and are moved only if
/// `picturesToo`. Returns whether all moves succeeded.
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

/// Subfolder that marks a folder as incomplete.
constexpr const char* unfinishedMark = ".unfinished";

/// Moves foreign files of the old content to the new one, and removes the rest of the old.
void dissolve(const fs::path& old, const fs::path& target)
{
    std::error_code error;
    const bool pictures = fs::is_directory(old / "pictures", error);
    if (keepForeign(old, target, true) && (!pictures || keepForeign(old / "pictures", target / "pictures", false)))
        fs::remove_all(old, error);
}

/// Cleans up what killed processes left beside the target. Incomplete folders are removed. A complete folder becomes
/// the target if there is none; otherwise it is the target's old content.
void clearBeside(const fs::path& target)
{
    const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::vector<fs::path> left;
    std::error_code error;
    for (const char* kind : {"part", "old"})
        for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
            const std::string name = entry->path().filename().string();
            if (name.starts_with(target.filename().string() + '.' + kind + '-') && render::isLeftBehind(name, kind))
                left.push_back(entry->path());
        }
    for (const fs::path& folder : left) {
        if (fs::exists(folder / unfinishedMark, error))
            fs::remove_all(folder, error);
        else if (!fs::exists(target, error))
            fs::rename(folder, target, error);
        else
            dissolve(folder, target);
    }
}

/// Exchanges two folders in one step. Returns false if the file system does not support it.
bool exchanged(const fs::path& a, const fs::path& b)
{
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

void makeFolders(const fs::path& folder, const fs::path& out)
{
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) refuseFolder(out, error);
}

PartFolder::PartFolder(fs::path target) : target_(std::move(target))
{
    if (!target_.has_filename()) target_ = target_.parent_path();  // "DIR/" is DIR.
    clearBeside(target_);
    part_ = target_;
    part_ += render::partSuffix();
    unfinished_.emplace(part_);
    std::error_code error;
    fs::create_directories(part_ / "pictures", error);
    if (!error) fs::create_directory(part_ / unfinishedMark, error);
    if (error) {
        std::error_code ignored;
        fs::remove_all(part_, ignored);
        refuseFolder(target_, error);
    }
}

PartFolder::~PartFolder()
{
    std::error_code ignored;
    if (unfinished_) fs::remove_all(part_, ignored);
}

void PartFolder::publish()
{
    const auto lock = render::unfinishedLock();
    std::error_code error;
    const bool replaces = fs::exists(target_, error);
    fs::path old = part_;
    std::error_code ignored;
    fs::remove(part_ / unfinishedMark, ignored);
    if (!replaces) {
        fs::rename(part_, target_, error);
    } else if (!exchanged(part_, target_)) {
        old = target_;
        old += render::partSuffix("old");
        fs::rename(target_, old, error);
        if (!error) fs::rename(part_, target_, error);
        if (error && fs::exists(old, ignored)) fs::rename(old, target_, ignored);
    }
    if (error)
        throw Failure(ErrorKind::file, target_.string() + ": the folder cannot be put in place (" + error.message() +
                                           "); choose another with --out.");
    unfinished_.reset();
    if (replaces) dissolve(old, target_);
}

}  // namespace vitrine::jobs

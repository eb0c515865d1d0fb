#pragma once

#include "render/files/unfinished.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::jobs {

/// Throws Failure (ErrorKind::usage) if the folder exists, is not empty, and has no file `mark`. All folders of the
/// program have this file, and nothing else is ever replaced. `what` is for people: "a study".
void requireFolderFor(const std::filesystem::path& folder, const std::string& mark, const std::string& what);

/// Makes a folder and those above it, unless they are there. Throws Failure (ErrorKind::file) naming `out`.
void makeFolders(const std::filesystem::path& folder, const std::filesystem::path& out);

/// Folder beside the target that takes the target's place, or is removed. On file systems that can exchange two names,
/// the target has all of the old content or all of the new at every moment. Foreign files in the target are kept,
/// except for names of the old content, and pictures in pictures/.
class PartFolder {
public:
    /// Makes the folder with pictures/ in it. Cleans up what killed processes of this machine left beside the target.
    /// Throws Failure (ErrorKind::file) if that is impossible.
    explicit PartFolder(std::filesystem::path target);
    ~PartFolder();
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return part_; }
    /// Puts the folder in the target's place. Throws Failure (ErrorKind::file) if that is impossible; the target is
    /// then unchanged.
    void publish();

private:
    std::filesystem::path target_, part_;
    std::optional<render::Unfinished> unfinished_;
};

}  // namespace vitrine::jobs

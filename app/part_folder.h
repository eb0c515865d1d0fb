#pragma once

#include "render/files/unfinished.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::app {

/// Throws Failure (Blame::usage) when the folder is there and neither empty nor holds a file `mark`, which each of the
/// program's own has: nothing else is ever replaced. `what` is for people: "a study".
void requireFolderFor(const std::filesystem::path& folder, const std::string& mark, const std::string& what);

/// A folder beside the target that is gone again unless it took the target's place: the target holds all of the old
/// content or all of the new, at every moment where the file system can exchange two names. What somebody else put into
/// it stays: all but files of the old content's names, and the pictures in pictures/.
class PartFolder {
public:
    /// With a folder pictures/ in it. Clears what processes of this machine left beside the target when they were
    /// killed. Throws Failure (Blame::file) when it cannot be made.
    explicit PartFolder(std::filesystem::path target);
    ~PartFolder();
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return part_; }
    /// Throws Failure (Blame::file) when it cannot take the target's place, which is then as it was.
    void publish();

private:
    std::filesystem::path target_, part_;
    std::optional<render::Unfinished> unfinished_;
};

}  // namespace vitrine::app

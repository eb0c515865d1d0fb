#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>

namespace vitrine::render {

/// The end of the name of a file or folder that this process is making beside its target: ".part-<mark>-<pid>-<n>".
/// The mark stands for this machine and its numbering of processes, so that on a shared disk the parts of other
/// machines are known as such. A new one at each call.
[[nodiscard]] std::string partSuffix(std::string_view kind = "part");

/// Whether a file name ends as `partSuffix` of that kind does, by a process of this machine that is no longer there.
[[nodiscard]] bool isLeftBehind(std::string_view fileName, std::string_view kind = "part");

/// Removes the hidden part files (".<name>.part-...") in `folder` whose processes are no longer there. Looks into each
/// folder once in the life of the program.
void clearLeftBehind(const std::filesystem::path& folder);

/// A file or folder that is being made: `removeUnfinished` removes it while this lives.
class Unfinished {
public:
    enum class Content : std::uint8_t { all, onlyIfEmpty };  ///< Of a folder: whether what lies in it goes, too.

    explicit Unfinished(std::filesystem::path, Content = Content::all);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
};

/// Removes all that is unfinished. From then on every `Unfinished` that begins or ends waits forever,
/// so that nothing is made or put in place any more: the caller ends the program. From any thread but one that holds
/// `unfinishedLock`.
void removeUnfinished() noexcept;

/// While it is held, `removeUnfinished` waits: for steps that belong together, such as two renames.
[[nodiscard]] std::unique_lock<std::recursive_mutex> unfinishedLock();

}  // namespace vitrine::render

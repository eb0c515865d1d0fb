#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Returns a suffix for the name of a file or folder that this process is making beside its target:
/// ".part-<mark>-<pid>-<n>". The mark identifies this machine and its process namespace, so that part files of other
/// machines on a shared disk are recognized. Each call returns a new suffix.
[[nodiscard]] std::string partSuffix(std::string_view kind = "part");

/// Returns whether a file name ends with a `partSuffix` of that kind, of a process of this machine that has ended.
[[nodiscard]] bool isLeftBehind(std::string_view fileName, std::string_view kind = "part");

/// Removes the hidden part files (".<name>.part-...") in `folder` whose processes have ended. Each folder is searched
/// only once per run.
void clearLeftBehind(const std::filesystem::path& folder);

/// A file or folder that is being made; `removeUnfinished` removes it while this object exists.
class Unfinished {
public:
    enum class Content : std::uint8_t { all, onlyIfEmpty };  ///< For a folder: whether it is removed with its content.

    explicit Unfinished(std::filesystem::path, Content = Content::all);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
};

/// Removes everything that is unfinished. Afterwards every `Unfinished` blocks forever when it begins or ends, so that
/// nothing more is created or renamed; the caller must end the program. Call it from any thread that does not hold
/// `unfinishedLock`.
void removeUnfinished() noexcept;

/// While the returned lock is held, `removeUnfinished` waits. It protects steps that belong together, such as two
/// renames.
[[nodiscard]] std::unique_lock<std::recursive_mutex> unfinishedLock();

}  // namespace vitrine::render

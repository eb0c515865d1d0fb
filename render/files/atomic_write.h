#pragma once

#include "render/files/file_ops.h"
#include "render/files/unfinished.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Replaces the content of `path` by `bytes`, or leaves it as it was: afterwards the file holds either all
/// of the old content or all of the new. Keeps the mode of an existing file; of a symbolic link it replaces
/// the file that the link names. Writes `.<name>.part-<mark>-<pid>-<n>` beside it (`partSuffix`), reads that back and
/// compares, renames it, and asks the disk to keep both (fsync of file and folder). Part files that processes of this
/// machine left there when they were killed are removed.
///
/// Throws Failure naming file and cause when any of that fails, after removing the part file. The old
/// content then stands, except when only the last step, the fsync of the folder, failed: the message says so.
void atomicWrite(const std::filesystem::path& path, std::string_view bytes, FileOps& = systemFileOps());

/// The same; makes the folder of `path`, and those above it, where there is none.
void atomicWriteMakingFolder(const std::filesystem::path& path, std::string_view bytes, FileOps& = systemFileOps());

/// A file and what it is to hold.
struct NamedBytes {
    std::filesystem::path path;
    std::string bytes;
};

/// Replaces several files together, each as `atomicWrite` does: afterwards all hold their old content, or all their
/// new. Asks for the space of all first, writes and checks all beside their targets, and only then renames them one
/// after another; where one cannot be renamed, those before it get their old content back, by a hard link that was kept
/// (not on file systems without such links). Throws Failure naming the file and the cause.
void atomicWriteAll(const std::vector<NamedBytes>&, FileOps& = systemFileOps());

class PartFile;

/// A file beside `path` that holds these bytes, read back and compared, to be published. Throws as `atomicWrite`.
[[nodiscard]] std::unique_ptr<PartFile> stagedFile(const std::filesystem::path& path, std::string_view bytes,
                                                   FileOps& = systemFileOps());

/// Publishes files that were written, as `atomicWriteAll` does: after a failure all hold their old content.
void publishAll(std::span<const std::unique_ptr<PartFile>>, FileOps& = systemFileOps());

/// Throws Failure unless the folder of `target` has 1.1 times `bytes` free.
void requireSpace(const std::filesystem::path& target, unsigned long long bytes, FileOps& = systemFileOps());

/// A file that is written beside its target and takes its place in one step.
class PartFile {
public:
    /// Follows symbolic links. Throws Failure when `target` is a folder, a device, a read-only file or a
    /// loop of links. Creates nothing yet.
    explicit PartFile(const std::filesystem::path& target, FileOps& = systemFileOps());
    /// Removes the part file unless it was published.
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return part_; }
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }

    /// Gives the part file the old file's mode, syncs it, puts it in the target's place, syncs the folder.
    void publish();
    /// The steps of that: mode and content reach the disk; the part file takes the target's place; so does the folder.
    void prepare() const;
    void replace();
    void syncFolder() const;

    /// Throws Failure "Cannot write <target>: <doing>: <errno as text>. ...".
    [[noreturn]] void fail(std::string_view doing, int error) const;

private:
    std::filesystem::path target_;
    std::filesystem::path part_;
    FileOps& ops_;
    bool published_ = false;
    Unfinished unfinished_;
};

}  // namespace vitrine::render

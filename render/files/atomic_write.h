#pragma once

#include "render/files/file_ops.h"
#include "render/files/unfinished.h"
#include "render/text/message.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Replaces the content of `path` by `bytes` atomically: afterwards the file holds either all of the old content or all
/// of the new. Keeps the mode of an existing file. For a symbolic link, replaces the file that it refers to. Writes
/// `.<name>.part-<mark>-<pid>-<n>` beside it (`partSuffix`), reads that back and compares, renames it, and syncs both
/// file and folder to disk (fsync). Removes part files in the folder that killed processes of this machine left behind.
/// Throws Failure naming file and cause if any of that fails, after removing the part file. The old content is then
/// unchanged, except if only the last step, the fsync of the folder, failed: the message says so.
void atomicWrite(const std::filesystem::path& path, std::string_view bytes, FileOps& = systemFileOps());

/// The same; creates the folder of `path`, and those above it, if they do not exist.
void atomicWriteMakingFolder(const std::filesystem::path& path, std::string_view bytes, FileOps& = systemFileOps());

/// A file path and the content to write.
struct NamedBytes {
    std::filesystem::path path;
    std::string bytes;
};

/// Replaces several files together, each as `atomicWrite` does: afterwards all hold their old content, or all their
/// new. Checks the free space for all first, writes and verifies all beside their targets, and only then renames them
/// one after another. If one cannot be renamed, those before it get their old content back from a hard link (not on
/// file systems without hard links). Throws Failure naming the file and the cause.
void atomicWriteAll(const std::vector<NamedBytes>&, FileOps& = systemFileOps());

class PartFile;

/// Writes these bytes to a part file beside `path`, reads them back and compares. Publish it later. Throws as
/// `atomicWrite`.
[[nodiscard]] std::unique_ptr<PartFile> stagedFile(const std::filesystem::path& path, std::string_view bytes,
                                                   FileOps& = systemFileOps());

/// Publishes part files together, as `atomicWriteAll` does: after a failure all targets hold their old content.
void publishAll(std::span<const std::unique_ptr<PartFile>>, FileOps& = systemFileOps());

/// Throws Failure unless the folder of `target` has at least 1.1 times `bytes` of free space.
void requireSpace(const std::filesystem::path& target, unsigned long long bytes, FileOps& = systemFileOps());

/// A file that is written beside its target and replaces it in one step.
class PartFile {
public:
    /// Follows symbolic links. Throws Failure if `target` is a folder, a device, a read-only file or a loop of links,
    /// or if its folder is missing or read-only. Creates no file yet.
    explicit PartFile(const std::filesystem::path& target, FileOps& = systemFileOps());
    /// Removes the part file unless it was published.
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return part_; }
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }

    /// Gives the part file the old file's mode, syncs it, replaces the target, and syncs the folder.
    void publish();
    /// The steps of `publish`: sync mode and content; replace the target; sync the folder.
    void prepare() const;
    void replace();
    void syncFolder() const;

    /// Throws Failure "Cannot write <target>: <doing>: <errno as text>. ...".
    [[noreturn]] void fail(const Message& doing, int error) const;

private:
    std::filesystem::path target_;
    std::filesystem::path part_;
    FileOps& ops_;
    bool published_ = false;
    Unfinished unfinished_;
};

}  // namespace vitrine::render

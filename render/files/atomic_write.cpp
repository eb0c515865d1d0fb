#include "render/files/atomic_write.h"

#include "render/failure.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const Message& why)
{
    throw Failure(ErrorKind::file, message("Cannot write {1}: {2}", path, why));
}

Message advice(int error)
{
    switch (error) {
    case ENOSPC:
    case EDQUOT: return message("free some space or choose another disk");
    case EACCES:
    case EPERM:
    case EROFS: return message("choose a folder you may write to");
    case ENOENT: return message("check that the folder exists");
    case ENAMETOOLONG: return message("choose a shorter name");
    default: return message("try another folder or disk");
    }
}

/// Resolves symbolic links to the final file, which need not exist.
fs::path realTarget(const fs::path& path)
{
    fs::path at = path;
    for (int links = 0; links < 40; ++links) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(at, error))) return at;
        const fs::path next = fs::read_symlink(at, error);
        if (error) refuse(path, message("{1}; name the file itself.", error.message()));
        at = next.is_absolute() ? next : at.parent_path() / next;
    }
    refuse(path, message("its symbolic links lead in a circle; name the file itself."));
}

fs::path folderOf(const fs::path& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// RAII file handle. `close` reports errors, which the destructor cannot.
class OpenFile {
public:
    OpenFile(FileOps& ops, const fs::path& path, int flags)
        : ops_(ops), fd_(ops.open(path.c_str(), flags | O_CLOEXEC, 0666))
    {
    }
    ~OpenFile()
    {
        if (fd_ >= 0) ops_.close(fd_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] int get() const { return fd_; }
    [[nodiscard]] bool close()
    {
        const int fd = fd_;
        fd_ = -1;
        return ops_.close(fd) == 0;
    }

private:
    FileOps& ops_;
    int fd_;
};

void writeAll(const PartFile& part, FileOps& ops, std::string_view bytes)
{
    OpenFile file(ops, part.path(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file.get() < 0) part.fail(message("creating a file beside it"), errno);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t wrote = ops.write(file.get(), bytes.data() + done, bytes.size() - done);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) part.fail(message("writing"), wrote < 0 ? errno : ENOSPC);
        done += static_cast<std::size_t>(wrote);
    }
    struct stat status {};
    if (ops.fstat(file.get(), &status) != 0) part.fail(message("checking its size"), errno);
    if (static_cast<std::uint64_t>(status.st_size) != bytes.size()) part.fail(message("checking its size"), EIO);
    if (!file.close()) part.fail(message("closing"), errno);  // `publish` syncs it to disk.
}

void compareAll(const PartFile& part, FileOps& ops, std::string_view bytes)
{
    OpenFile file(ops, part.path(), O_RDONLY);
    if (file.get() < 0) part.fail(message("reading it back"), errno);
    std::array<char, 65536> block{};
    std::size_t done = 0;
    for (;;) {
        const ssize_t got = ops.read(file.get(), block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) part.fail(message("reading it back"), errno);
        if (got == 0) break;
        const std::size_t size = static_cast<std::size_t>(got);
        if (size > bytes.size() - done || std::memcmp(block.data(), bytes.data() + done, size) != 0) {
            part.fail(message("reading it back gave other bytes"), EIO);
        }
        done += size;
    }
    if (done != bytes.size()) part.fail(message("reading it back gave fewer bytes"), EIO);
}

/// Syncs the folder's latest renames to disk. Returns 0, or the errno.
int syncedFolder(const fs::path& folder, FileOps& ops)
{
    OpenFile directory(ops, folder, O_RDONLY | O_DIRECTORY);
    if (directory.get() < 0) return errno;
    // Some file systems cannot sync a folder and return EINVAL. That is no error.
    if (ops.fsync(directory.get()) != 0 && errno != EINVAL) return errno;
    return 0;
}

}  // namespace

namespace {

/// Returns the path of a hidden part file beside the target.
fs::path partOf(const fs::path& target)
{
    const std::string suffix = partSuffix();
    // File names have at most 255 bytes. The system checks the length of the target's own name.
    return folderOf(target) / ("." + target.filename().string().substr(0, 253 - suffix.size()) + suffix);
}

}  // namespace

PartFile::PartFile(const fs::path& target, FileOps& ops)
    : target_(realTarget(target)), part_(partOf(target_)), ops_(ops), unfinished_(part_)
{
    struct stat status {};
    if (::stat(target_.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) refuse(target, message("it is a folder; choose a file name."));
        if (!S_ISREG(status.st_mode)) refuse(target, message("it is not a regular file; choose another name."));
        if (::access(target_.c_str(), W_OK) != 0)
            refuse(target, message("the file is read-only; choose another name."));
    }
    const std::string name = target_.filename().string();
    if (name.empty() || name == "." || name == "..") refuse(target, message("it names no file; choose a file name."));
    if (::access(folderOf(target_).c_str(), W_OK | X_OK) != 0) fail(message("opening its folder to write"), errno);
    clearLeftBehind(folderOf(target_));
}

PartFile::~PartFile()
{
    if (!published_) ops_.unlink(part_.c_str());
}

void PartFile::fail(const Message& doing, int error) const
{
    throw Failure(ErrorKind::file, message("Cannot write {1}: {2} failed ({3}); the old content is untouched; {4}.",
                                           target_, doing, std::strerror(error), advice(error)));
}

void PartFile::prepare() const
{
    OpenFile file(ops_, part_, O_RDWR);
    if (file.get() < 0) fail(message("opening it again"), errno);
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0 && ops_.fchmod(file.get(), old.st_mode & 07777U) != 0) {
        fail(message("keeping its permissions"), errno);
    }
    if (ops_.fsync(file.get()) != 0) fail(message("waiting for the disk"), errno);
    if (!file.close()) fail(message("closing"), errno);
}

void PartFile::replace()
{
    if (ops_.rename(part_.c_str(), target_.c_str()) != 0) fail(message("renaming"), errno);
    published_ = true;
}

void PartFile::syncFolder() const
{
    if (const int error = syncedFolder(folderOf(target_), ops_); error != 0) {
        refuse(target_, message("the new content is in place, but the disk did not confirm it ({1}); save once more.",
                                std::strerror(error)));
    }
}

void PartFile::publish()
{
    prepare();
    replace();
    syncFolder();
}

void requireSpace(const fs::path& target, unsigned long long bytes, FileOps& ops)
{
    const unsigned long long free = ops.freeBytes(folderOf(target).c_str());
    const unsigned long long needed = bytes + bytes / 10;
    if (free >= needed) return;
    refuse(target, message("it needs {1} bytes and the disk has {2} left; free some space or choose another disk.",
                           needed, free));
}

void atomicWrite(const fs::path& path, std::string_view bytes, FileOps& ops)
{
    PartFile part(path, ops);
    writeAll(part, ops, bytes);
    compareAll(part, ops, bytes);
    part.publish();
}

namespace {

/// Hard links to files that are about to be replaced; they keep the old content.
class OldFiles {
public:
    explicit OldFiles(FileOps& ops) : ops_(ops) {}
    ~OldFiles()
    {
        for (const Old& old : kept_)
            if (old.hadFile) ops_.unlink(old.path.c_str());
    }
    OldFiles(const OldFiles&) = delete;
    OldFiles& operator=(const OldFiles&) = delete;

    void keep(const PartFile& part)
    {
        Old old{part.target(), part.path().string() + "o", fs::exists(part.target())};
        if (old.hadFile && ops_.link(part.target().c_str(), old.path.c_str()) != 0) return;
        kept_.push_back(std::move(old));
    }
    void putBack(const PartFile& part)
    {
        for (Old& old : kept_)
            if (old.target == part.target()) {
                if (!old.hadFile)
                    ops_.unlink(old.target.c_str());
                else if (ops_.rename(old.path.c_str(), old.target.c_str()) == 0)
                    old.hadFile = false;
            }
    }

private:
    struct Old {
        fs::path target, path;
        bool hadFile;
    };
    FileOps& ops_;
    std::vector<Old> kept_;
};

}  // namespace

std::unique_ptr<PartFile> stagedFile(const fs::path& path, std::string_view bytes, FileOps& ops)
{
    auto part = std::make_unique<PartFile>(path, ops);
    writeAll(*part, ops, bytes);
    compareAll(*part, ops, bytes);
    return part;
}

void publishAll(std::span<const std::unique_ptr<PartFile>> parts, FileOps& ops)
{
    for (const auto& part : parts) part->prepare();
    const auto lock = unfinishedLock();  // An interrupt then happens before or after all of it.
    OldFiles old(ops);
    for (const auto& part : parts) old.keep(*part);
    std::size_t done = 0;
    try {
        for (; done < parts.size(); ++done) parts[done]->replace();
    } catch (...) {
        while (done > 0) old.putBack(*parts[--done]);
        throw;
    }
    for (const auto& part : parts) part->syncFolder();
}

void atomicWriteAll(const std::vector<NamedBytes>& files, FileOps& ops)
{
    if (files.empty()) return;
    unsigned long long all = 0;
    for (const NamedBytes& file : files) all += file.bytes.size();
    requireSpace(files.front().path, all, ops);
    std::vector<std::unique_ptr<PartFile>> parts;
    for (const NamedBytes& file : files) parts.push_back(stagedFile(file.path, file.bytes, ops));
    publishAll(parts, ops);
}

void atomicWriteMakingFolder(const fs::path& path, std::string_view bytes, FileOps& ops)
{
    std::error_code error;
    fs::create_directories(folderOf(path), error);
    if (error) refuse(path, message("{1}; choose another folder or free some space.", error.message()));
    atomicWrite(path, bytes, ops);
}

}  // namespace vitrine::render

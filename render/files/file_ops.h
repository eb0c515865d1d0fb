#pragma once

#include <sys/types.h>

#include <cstddef>

struct stat;

namespace vitrine::render {

/// System calls for writing a file, virtual so that a test can let each of them fail. Each returns the result of the
/// call of its name, and sets errno.
class FileOps {
public:
    virtual ~FileOps() = default;
    virtual int open(const char* path, int flags, mode_t mode);
    virtual ssize_t write(int fd, const void* bytes, std::size_t size);
    virtual ssize_t read(int fd, void* bytes, std::size_t size);
    virtual int fchmod(int fd, mode_t mode);
    virtual int fstat(int fd, struct stat* status);
    virtual int fsync(int fd);
    virtual int close(int fd);
    virtual int rename(const char* from, const char* to);
    virtual int link(const char* from, const char* to);
    virtual int unlink(const char* path);
    /// Bytes that this user may still write in the folder; the largest number if that is unknown.
    virtual unsigned long long freeBytes(const char* folder);
};

/// Returns the real system calls.
[[nodiscard]] FileOps& systemFileOps();

}  // namespace vitrine::render

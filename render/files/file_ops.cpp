#include "render/files/file_ops.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cstdio>
#include <limits>

namespace vitrine::render {

int FileOps::open(const char* path, int flags, mode_t mode)
{
    return ::open(path, flags, mode);
}
ssize_t FileOps::write(int fd, const void* bytes, std::size_t size)
{
    return ::write(fd, bytes, size);
}
ssize_t FileOps::read(int fd, void* bytes, std::size_t size)
{
    return ::read(fd, bytes, size);
}
int FileOps::fchmod(int fd, mode_t mode)
{
    return ::fchmod(fd, mode);
}
int FileOps::fstat(int fd, struct stat* status)
{
    return ::fstat(fd, status);
}
int FileOps::fsync(int fd)
{
    return ::fsync(fd);
}
int FileOps::close(int fd)
{
    return ::close(fd);
}
int FileOps::rename(const char* from, const char* to)
{
    return ::rename(from, to);
}
int FileOps::link(const char* from, const char* to)
{
    return ::link(from, to);
}
int FileOps::unlink(const char* path)
{
    return ::unlink(path);
}

unsigned long long FileOps::freeBytes(const char* folder)
{
    struct statvfs status {};
    if (::statvfs(folder, &status) != 0) return std::numeric_limits<unsigned long long>::max();
    return static_cast<unsigned long long>(status.f_bavail) * status.f_frsize;
}

FileOps& systemFileOps()
{
    static FileOps ops;
    return ops;
}

}  // namespace vitrine::render

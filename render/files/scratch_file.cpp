#include "render/files/scratch_file.h"

#include "render/failure.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace vitrine::render {

namespace {

/// Returns TMPDIR if it is set. Otherwise /var/tmp, because /tmp is in memory on many systems (Debian 13 among them).
std::filesystem::path scratchFolder()
{
    const std::filesystem::path large = "/var/tmp";
    if (!std::getenv("TMPDIR") && ::access(large.c_str(), W_OK | X_OK) == 0) return large;
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    if (!error) return folder;
    throw Failure(ErrorKind::file,
                  message("There is no folder for temporary files ({1}); let TMPDIR name one that you may write to.",
                          error.message()));
}

}  // namespace

ScratchFile::ScratchFile() : folder_(scratchFolder())
{
    std::string name = (folder_ / "vitrine-XXXXXX").string();
    file_ = Descriptor(::mkostemp(name.data(), O_CLOEXEC));
    if (!file_.open()) fail(message("creating a file there"));
    ::unlink(name.c_str());
}

void ScratchFile::fail(const Message& doing) const
{
    throw Failure(ErrorKind::file,
                  message("Cannot keep the views in {1}: {2} failed ({3}); free some space there, or let "
                          "TMPDIR name a folder with more.",
                          folder_, doing, std::strerror(errno)));
}

void ScratchFile::append(const void* bytes, std::size_t count)
{
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t wrote = ::pwrite(file_.get(), at, count, static_cast<off_t>(size_));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote == 0) errno = ENOSPC;
        if (wrote <= 0) fail(message("writing"));
        at += wrote;
        size_ += static_cast<std::uint64_t>(wrote);
        count -= static_cast<std::size_t>(wrote);
    }
}

void ScratchFile::align()
{
    const std::array<char, mapUnit> zeros{};
    append(zeros.data(), static_cast<std::size_t>((mapUnit - size_ % mapUnit) % mapUnit));
}

const void* ScratchFile::map(std::uint64_t offset, std::size_t count) const
{
    void* begin = ::mmap(nullptr, count, PROT_READ, MAP_SHARED, file_.get(), static_cast<off_t>(offset));
    if (begin == MAP_FAILED) fail(message("mapping"));
    return begin;
}

void releasePages(const void* mapped, std::size_t mappedCount, std::size_t offset, std::size_t count)
{
    // Reading a page loads the others of its unit, too. So whole units are released, or the pages before would stay
    // forever. The range ends at the mapping, because memory beyond it has another owner.
    const auto begin = reinterpret_cast<std::uintptr_t>(mapped);
    const std::uintptr_t from = std::max((begin + offset) / ScratchFile::mapUnit * ScratchFile::mapUnit, begin);
    const std::uintptr_t to =
        std::min((begin + offset + count + ScratchFile::mapUnit - 1) / ScratchFile::mapUnit * ScratchFile::mapUnit,
                 begin + mappedCount);
    ::madvise(reinterpret_cast<void*>(from), to - from, MADV_DONTNEED);
}

void unmapPages(const void* begin, std::size_t count)
{
    ::munmap(const_cast<void*>(begin), count);
}

}  // namespace vitrine::render

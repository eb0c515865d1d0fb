#pragma once

#include "render/files/descriptor.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace vitrine::render {

/// Working data too large for memory, in the folder that TMPDIR names, else in /var/tmp. The file has no name: it is
/// gone when the program ends, however it ends.
class ScratchFile {
public:
    /// Throws Failure naming the folder when no file can be made there.
    ScratchFile();

    [[nodiscard]] std::uint64_t size() const { return size_; }  ///< Bytes.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// Throws Failure naming the folder, the cause (a full disk) and what to do.
    void append(const void* bytes, std::size_t count);

    /// The bytes from `offset` on, which must be a multiple of `mapUnit`, until `unmapPages`; the file need not
    /// live so long. Throws Failure when the system refuses.
    [[nodiscard]] const void* map(std::uint64_t offset, std::size_t count) const;
    /// Fills with zeros up to the next multiple of `mapUnit`.
    void align();
    static constexpr std::uint64_t mapUnit = 65536;

private:
    [[noreturn]] void fail(const char* doing) const;

    std::filesystem::path folder_{};
    Descriptor file_{};
    std::uint64_t size_ = 0;
};

/// Gives `count` bytes from `offset` on, of memory that `ScratchFile::map` returned, back to the system, and those
/// around them up to multiples of `mapUnit`, without forgetting their content: they are read again when they are
/// wanted. At any time, from any thread.
void releasePages(const void* mapped, std::size_t mappedCount, std::size_t offset, std::size_t count);

/// Ends a mapping.
void unmapPages(const void* begin, std::size_t count);

}  // namespace vitrine::render

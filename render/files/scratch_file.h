#pragma once

#include "render/files/descriptor.h"
#include "render/text/message.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace vitrine::render {

/// Temporary data too large for memory, in the folder of TMPDIR, else in /var/tmp. The file has no name, so it
/// disappears when the program ends for any reason.
class ScratchFile {
public:
    /// Throws Failure naming the folder if no file can be created there.
    ScratchFile();

    [[nodiscard]] std::uint64_t size() const { return size_; }  ///< Bytes.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// Appends bytes. Throws Failure naming the folder, the cause (a full disk) and what to do.
    void append(const void* bytes, std::size_t count);

    /// Maps `count` bytes from `offset` on, which must be a multiple of `mapUnit`, into memory. The mapping is valid
    /// until `unmapPages`, even after the file object is destroyed. Throws Failure if the system refuses.
    [[nodiscard]] const void* map(std::uint64_t offset, std::size_t count) const;
    /// Appends zeros up to the next multiple of `mapUnit`.
    void align();
    static constexpr std::uint64_t mapUnit = 65536;

private:
    [[noreturn]] void fail(const Message& doing) const;

    std::filesystem::path folder_{};
    Descriptor file_{};
    std::uint64_t size_ = 0;
};

/// Frees the memory of `count` bytes from `offset` on, in a mapping that `ScratchFile::map` returned, extended to
/// multiples of `mapUnit`. The content stays in the file and is read again when it is accessed. Thread-safe, at any
/// time.
void releasePages(const void* mapped, std::size_t mappedCount, std::size_t offset, std::size_t count);

/// Removes a mapping.
void unmapPages(const void* begin, std::size_t count);

}  // namespace vitrine::render

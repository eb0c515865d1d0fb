#pragma once

#include <cstdint>

namespace vitrine::render {

/// RAM that this process uses, in bytes.
struct ProcessMemory {
    std::int64_t resident = 0;  ///< All resident memory.
    /// Without file-backed pages (programs, libraries), which the system can drop and read again.
    std::int64_t own = 0;
};

/// Reads /proc/self/status; returns zeros if it does not exist.
[[nodiscard]] ProcessMemory processMemory();

/// Configures the heap so that freed memory is returned to the system: blocks from 256 KiB on are mapped separately,
/// and threads share two heaps. glibc otherwise raises its threshold to the largest block ever freed (up to 32 MiB),
/// and pictures then leave holes in the heap. Call it once, at the start of main. Does nothing with other C libraries.
void returnFreedMemory();

/// Returns the heap's free pages to the system now. Call it after something large was freed.
void trimHeap();

}  // namespace vitrine::render

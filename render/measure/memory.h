#pragma once

#include <cstdint>

namespace vitrine::render {

/// Memory of this process that lies in RAM, in bytes.
struct ProcessMemory {
    std::int64_t resident = 0;  ///< All of it.
    std::int64_t own = 0;  ///< Without pages of files (programs, libraries), which the system can drop and read again.
};

/// From /proc/self/status; zeros where there is none.
[[nodiscard]] ProcessMemory processMemory();

/// Makes what is freed go back to the system: blocks from 256 KiB on are mapped one by one, and threads share two
/// heaps. glibc otherwise raises its threshold to the largest block ever freed (up to 32 MiB), and pictures then leave
/// holes in the heap. Called once, at the start of main; does nothing with other C libraries.
void returnFreedMemory();

/// Gives the heap's free pages back now: after something large was let go.
void trimHeap();

}  // namespace vitrine::render

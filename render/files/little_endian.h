#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace vitrine::render {

/// Returns the unsigned number in `count` bytes (at most 4) from `at` on, the lowest byte first; 0 beyond the end.
[[nodiscard]] inline std::uint32_t littleEndian(std::string_view bytes, std::size_t at, std::size_t count = 4)
{
    std::uint32_t x = 0;
    if (at + count > bytes.size()) return 0;
    for (std::size_t i = count; i > 0; --i) x = x << 8U | static_cast<unsigned char>(bytes[at + i - 1]);
    return x;
}

}  // namespace vitrine::render

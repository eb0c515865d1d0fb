#pragma once

#include <cstdint>
#include <cstdlib>

namespace vitrine::test {

/// Returns the whole number in an environment variable; `otherwise` if it is not set.
inline std::uint64_t environmentNumber(const char* name, std::uint64_t otherwise)
{
    const char* text = std::getenv(name);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace vitrine::test

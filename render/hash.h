#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace vitrine::render {

/// FNV-1a, 64 bits (Fowler, Noll, Vo 1991): keys of caches, never a defense.
class Hash {
public:
    Hash& add(std::string_view bytes)
    {
        for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
        return *this;
    }
    template <typename T> Hash& addValue(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        return add(std::string_view(bytes, sizeof(T)));
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

}  // namespace vitrine::render

#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace vitrine::render {

/// FNV-1a, 64 bits (Fowler, Noll, Vo 1991), for cache keys. Not safe against deliberate collisions.
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

/// Hash of many numbers, one 64-bit word at a time. Each word goes through the finalizer of SplitMix64 (Steele, Lea,
/// Flood 2014, "Fast Splittable Pseudorandom Number Generators"), so that each bit affects every bit of the result.
class NumberHash {
public:
    /// `count`: how many numbers will be added.
    explicit NumberHash(std::size_t count) : value_(count) {}
    void add(std::uint64_t number)
    {
        value_ = (value_ ^ number) + 0x9E3779B97F4A7C15ULL;
        value_ = (value_ ^ (value_ >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        value_ = (value_ ^ (value_ >> 27U)) * 0x94D049BB133111EBULL;
        value_ ^= value_ >> 31U;
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_;
};

/// Returns the NumberHash of all numbers; 0 and -0 differ.
[[nodiscard]] inline std::uint64_t hashOfNumbers(std::span<const double> numbers)
{
    NumberHash hash(numbers.size());
    for (const double number : numbers) hash.add(std::bit_cast<std::uint64_t>(number));
    return hash.value();
}

}  // namespace vitrine::render

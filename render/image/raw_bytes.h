#pragma once

#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace vitrine::render {

/// Allocator that leaves new elements uninitialized: memory that is written next needs no zeros before.
template <typename T> struct LeavingAllocator : std::allocator<T> {
    template <typename Other> struct rebind {
        using other = LeavingAllocator<Other>;
    };
    LeavingAllocator() = default;
    template <typename Other> explicit LeavingAllocator(const LeavingAllocator<Other>& /*other*/) noexcept {}

    template <typename Other> void construct(Other* at) noexcept { ::new (static_cast<void*>(at)) Other; }
    template <typename Other, typename... Values> void construct(Other* at, Values&&... values)
    {
        ::new (static_cast<void*>(at)) Other(std::forward<Values>(values)...);
    }
};

/// Byte vector whose `resize` leaves new bytes undefined.
using RawBytes = std::vector<std::uint8_t, LeavingAllocator<std::uint8_t>>;

}  // namespace vitrine::render

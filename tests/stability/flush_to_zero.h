#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace vitrine::test {

/// Returns whether `FlushToZero` has an effect on this machine.
[[nodiscard]] constexpr bool canFlushToZero()
{
#if defined(__SSE2__)
    return true;
#else
    return false;
#endif
}

/// While an object exists, denormal numbers count as zero, as operands and as results, like on GPUs.
class FlushToZero {
public:
#if defined(__SSE2__)
    FlushToZero() : before_(_mm_getcsr())
    {
        _mm_setcsr(before_ | 0x8040U);
    }  // FTZ is bit 15, DAZ bit 6.
    ~FlushToZero()
    {
        _mm_setcsr(before_);
    }
#else
    FlushToZero() = default;
    ~FlushToZero() = default;
#endif
    FlushToZero(const FlushToZero&) = delete;
    FlushToZero& operator=(const FlushToZero&) = delete;

private:
    [[maybe_unused]] unsigned before_ = 0;
};

}  // namespace vitrine::test

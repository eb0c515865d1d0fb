// Preloaded library (LD_PRELOAD): all allocations after the first VITRINE_TEST_ALLOCATIONS fail.

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

// Second names of glibc's functions, because dlsym would allocate.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

constexpr long notAsked = -1, unlimited = -2;

bool fails()
{
    static std::atomic<long> left{notAsked};
    if (left == notAsked) {
        const char* count = std::getenv("VITRINE_TEST_ALLOCATIONS");
        left = count ? std::atol(count) : unlimited;
    }
    if (left == unlimited) return false;
    if (left > 0) {
        --left;
        return false;
    }
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept
{
    return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept
{
    return fails() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept
{
    return fails() ? nullptr : __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
{
    return fails() ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept
{
    if (fails()) return ENOMEM;
    *out = __libc_memalign(alignment, size);
    return *out ? 0 : ENOMEM;
}

}  // extern "C"

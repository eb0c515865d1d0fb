// Preloaded library (LD_PRELOAD): sets the program's real-time clock forward by VITRINE_TEST_CLOCK seconds.

#include <dlfcn.h>
#include <sys/time.h>
#include <time.h>

#include <cstdlib>

namespace {

time_t offset()
{
    const char* seconds = std::getenv("VITRINE_TEST_CLOCK");
    return seconds ? std::atol(seconds) : 0;
}

template <typename Function> Function* next(const char* name)
{
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, struct timespec* out) noexcept
{
    static const auto real = next<int(clockid_t, struct timespec*)>("clock_gettime");
    const int result = real(clock, out);
    if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) out->tv_sec += offset();
    return result;
}

time_t time(time_t* out) noexcept
{
    struct timespec now {};
    ::clock_gettime(CLOCK_REALTIME, &now);
    if (out) *out = now.tv_sec;
    return now.tv_sec;
}

int gettimeofday(struct timeval* out, void* /*zone*/) noexcept
{
    struct timespec now {};
    ::clock_gettime(CLOCK_REALTIME, &now);
    out->tv_sec = now.tv_sec;
    out->tv_usec = now.tv_nsec / 1000;
    return 0;
}
}

#include "render/measure/clock.h"

#include <charconv>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

namespace vitrine::render {
namespace {

double seconds(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double processCpuSeconds()
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

double wallSeconds()
{
    return seconds(CLOCK_MONOTONIC);
}

ThreadTimes threadTimes()
{
    ThreadTimes times;
    std::error_code error;
    for (std::filesystem::directory_iterator at("/proc/self/task", error), end; !error && at != end;
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        int thread = 0;
        std::from_chars(name.data(), name.data() + name.size(), thread);
        // Nanoseconds on a processor, nanoseconds in the queue of one, and the number of turns.
        double running = 0, waiting = 0;
        if (std::ifstream(at->path() / "schedstat") >> running >> waiting)
            times[thread] = {1e-9 * running, 1e-9 * waiting};
    }
    return times;
}

double withoutWaiting(double wall, const ThreadTimes& before, const ThreadTimes& after)
{
    if (before.empty()) return wall;
    double running = 0, waiting = 0;
    for (const auto& [thread, time] : after) {
        const auto known = before.find(thread);
        const ThreadTime start = known != before.end() ? known->second : ThreadTime{};
        running += time.running - start.running;
        waiting += time.waiting - start.waiting;
    }
    return running > 0 ? wall * running / (running + waiting) : wall;
}

}  // namespace vitrine::render

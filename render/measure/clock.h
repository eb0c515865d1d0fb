#pragma once

#include <map>

namespace vitrine::render {

/// Returns the CPU time that this process has used on all its threads, in seconds (CLOCK_PROCESS_CPUTIME_ID). Around a
/// glFinish it is the most stable clock for a software renderer, because other processes do not affect it.
[[nodiscard]] double processCpuSeconds();

/// Returns the monotonic wall clock, in seconds.
[[nodiscard]] double wallSeconds();

/// Time of one thread since its start, in seconds.
struct ThreadTime {
    double running = 0;  ///< On a processor.
    double waiting = 0;  ///< Ready to run, while other threads had all processors.
};
using ThreadTimes = std::map<int, ThreadTime>;

/// Returns the times of all threads of this process by thread id (/proc/self/task). Empty where the kernel does not
/// keep them.
[[nodiscard]] ThreadTimes threadTimes();

/// Returns the part of a time by the wall clock, `wall` seconds, that the threads would have taken if they had never
/// waited for a processor. `before` and `after` are their times at its begin and end. Without these, it is `wall`.
[[nodiscard]] double withoutWaiting(double wall, const ThreadTimes& before, const ThreadTimes& after);

}  // namespace vitrine::render

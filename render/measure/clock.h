#pragma once

namespace vitrine::render {

/// Returns the CPU time that this process has used on all its threads, in seconds (CLOCK_PROCESS_CPUTIME_ID). Around a
/// glFinish it is the most stable clock for a software renderer, because other processes do not affect it.
[[nodiscard]] double processCpuSeconds();

/// Returns the monotonic wall clock, in seconds.
[[nodiscard]] double wallSeconds();

}  // namespace vitrine::render

#pragma once

namespace vitrine::render {

/// CPU time that this process has used on all its threads, seconds (CLOCK_PROCESS_CPUTIME_ID). Around a
/// glFinish it is the steadiest clock for a software renderer: a busy neighbor does not move it.
[[nodiscard]] double processCpuSeconds();

/// Monotonic wall clock, seconds.
[[nodiscard]] double wallSeconds();

}  // namespace vitrine::render

#pragma once

#include <span>
#include <string>

namespace vitrine::render {

/// One drawing of a known load, timed in every way at once. Seconds.
struct ClockSample {
    double load = 1;   ///< In units of the smallest load.
    double query = 0;  ///< By a GL timer query.
    double wall = 0;   ///< By the wall clock around glFinish.
    double cpu = 0;    ///< Of the process, on all its threads, around glFinish.
};

enum class ClockMethod : unsigned char { query, cpu, wall };

/// How times are taken, whether they can be believed, and why.
struct ClockChoice {
    ClockMethod method = ClockMethod::wall;
    bool trusted = false;
    std::string name;            ///< "process CPU time around glFinish".
    std::string why;             ///< One sentence with the numbers that decided.
    double overheadSeconds = 0;  ///< What taking one time costs.
};

/// Chooses a clock from samples of several loads, each several times. A timer query is used on hardware when for
/// every load it is within 20 % of the wall clock and grows with the load within 20 %; the wall clock around
/// glFinish else. On a software renderer it is the process's CPU time, whatever the queries say. The clock that is
/// used is trusted when it grows with the load within 20 %. The quickest run of each load counts: what disturbs a
/// run only makes it slower. Nothing is trusted without two different loads.
[[nodiscard]] ClockChoice chooseClock(std::span<const ClockSample>, bool softwareRenderer, double overheadSeconds);

}  // namespace vitrine::render

#pragma once

#include <span>
#include <string>

namespace vitrine::render {

/// One draw of a known load, measured with all clocks at once. Times in seconds.
struct ClockSample {
    double load = 1;   ///< Multiple of the smallest load.
    double query = 0;  ///< Time of a GL timer query.
    double wall = 0;   ///< Wall time around glFinish.
    double cpu = 0;    ///< CPU time of the process on all its threads, around glFinish.
};

enum class ClockMethod : unsigned char { query, cpu, wall };

/// Selected clock, whether it can be trusted, and why.
struct ClockChoice {
    ClockMethod method = ClockMethod::wall;
    bool trusted = false;
    std::string name;            ///< "process CPU time around glFinish".
    std::string why;             ///< One sentence with the measured numbers that decided.
    double overheadSeconds = 0;  ///< Cost of taking one time.
};

/// Chooses a clock from samples of several loads, each measured several times. On a software renderer it is always the
/// process's CPU time. On hardware it is the timer query, if that agrees with the wall clock within 20 % for every load
/// and is proportional to the load within 20 %. Otherwise it is the wall clock around glFinish. The chosen clock is
/// trusted if it is proportional to the load within 20 %. Only the fastest run of each load counts, because
/// disturbances only make a run slower. Two different loads are required for trust.
[[nodiscard]] ClockChoice chooseClock(std::span<const ClockSample>, bool softwareRenderer, double overheadSeconds);

}  // namespace vitrine::render

#pragma once

#include <cstdint>

namespace vitrine::app {

struct StabilityOptions {
    int presets = 200;  ///< Random settings of each exhibit.
    std::uint64_t firstSeed = 1;
    bool asJson = false;
};

/// Runs the hard cases that need a GPU on this machine's driver and prints what holds: a table, or JSON. Progress
/// goes to standard error where that is a terminal. Returns the exit code: 0 when everything holds, else that of
/// Blame::check. Throws Failure (Blame::openGl) where there is no OpenGL 4.5.
int stabilityReport(const StabilityOptions&);

}  // namespace vitrine::app

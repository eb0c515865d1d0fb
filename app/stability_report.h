#pragma once

#include <cstdint>

namespace vitrine::app {

struct StabilityOptions {
    int presets = 200;   ///< Largest number of random settings for each exhibit.
    double minutes = 5;  ///< Longest time. The rest of the settings is left out when it has passed.
    std::uint64_t firstSeed = 1;
    bool asJson = false;
};

/// Runs the stability tests that need a GPU on this machine's driver and prints the results as a table or JSON.
/// Progress goes to standard error. The time left is shared equally by the exhibits that are left. The table says
/// how many settings each tried, and what was not run. Returns the exit code: 0 if all tests pass, else that of
/// ErrorKind::check. Throws Failure (ErrorKind::openGl) without OpenGL 4.5.
int stabilityReport(const StabilityOptions&);

}  // namespace vitrine::app

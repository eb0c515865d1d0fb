#pragma once

#include <map>
#include <string>
#include <vector>

namespace vitrine::bench {

/// Result of a run of the program.
struct Run {
    int code = -1;       ///< Exit code; 128 + its number if a signal ended the run, SIGALRM if that was the limit.
    double started = 0;  ///< Time of the start (render::wallSeconds).
    double wallSeconds = 0;
    double cpuSeconds = 0;     ///< Processor time of all threads, user and system.
    double peakMegabytes = 0;  ///< Largest resident set in 1e6 bytes.
    std::string out;           ///< Standard output of the program; its standard error is that of this process.
};

/// Runs the program with these arguments and changes to the environment, and waits for at most `longest` seconds.
[[nodiscard]] Run runProgram(const std::vector<std::string>& arguments,
                             const std::map<std::string, std::string>& changes = {}, double longest = 600);

}  // namespace vitrine::bench

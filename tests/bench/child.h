#pragma once

#include <map>
#include <string>
#include <vector>

namespace vitrine::bench {

/// How a run of the program ended.
struct Run {
    int code = -1;       ///< Its exit code; -1 when a signal ended it, or it took longer than it was given.
    double started = 0;  ///< By render::wallSeconds, just before it was started.
    double wallSeconds = 0;
    double cpuSeconds = 0;     ///< Of all its threads, user and system.
    double peakMegabytes = 0;  ///< Largest resident set, in 1e6 bytes.
    std::string out;           ///< What it wrote to standard output; its errors go to ours.
};

/// Runs the program with these arguments and changes to the environment, and waits for at most `longest` seconds.
[[nodiscard]] Run runProgram(const std::vector<std::string>& arguments,
                             const std::map<std::string, std::string>& changes = {}, double longest = 600);

}  // namespace vitrine::bench

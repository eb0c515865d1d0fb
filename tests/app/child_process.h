#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace vitrine::test {

/// Result of a child process.
struct Ended {
    int code = -1;  ///< Exit code; 128 plus the signal if a signal ended it.
    std::string out, err;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs the program with these arguments, without a display, and waits. `changes` are made to the environment; an empty
/// value removes a variable.
[[nodiscard]] Ended vitrine(const std::vector<std::string>& arguments, const Environment& changes = {});

/// Starts the program with these arguments, without waiting. Its output is discarded. Returns its process id.
[[nodiscard]] pid_t startProgram(const std::vector<std::string>& arguments);

/// Returns standard error without progress lines, which appear if the work takes long: lines that end in "%" or with
/// the remaining time.
[[nodiscard]] std::string withoutProgress(const std::string& err);

/// Expects one line on standard error with the program's name, all parts, and a full stop, and nothing on standard
/// output.
void expectOneSentence(const Ended&, const std::vector<std::string>& parts);

}  // namespace vitrine::test

#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace vitrine::test {

/// What a child process left.
struct Ended {
    int code = -1;  ///< Its exit code; 128 and more: the signal that ended it, plus 128.
    std::string out, err;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs the program with these arguments, without a display, and waits. `changes` to the environment: an
/// empty value takes the variable away.
[[nodiscard]] Ended vitrine(const std::vector<std::string>& arguments, const Environment& changes = {});

/// Starts the program with these arguments and does not wait: its process. What it says goes nowhere.
[[nodiscard]] pid_t startProgram(const std::vector<std::string>& arguments);

/// What it said on standard error, but for how far it is, which it says where that takes long: lines that end in "%",
/// or with the time that is left.
[[nodiscard]] std::string withoutProgress(const std::string& err);

/// Expects one line on standard error that says who speaks, contains every part, and ends as a sentence; and
/// nothing on standard output.
void expectOneSentence(const Ended&, const std::vector<std::string>& parts);

}  // namespace vitrine::test

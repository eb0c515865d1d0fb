#pragma once

#include <chrono>
#include <string>

namespace vitrine::app {

/// Lets Ctrl-C (SIGINT) and SIGTERM stop long work in an orderly way instead of ending the program: whoever
/// works asks `stopped()` between steps and undoes what he began. A second Ctrl-C ends the program at once.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    [[nodiscard]] static bool stopped();
    /// Readable once `stopped()`, for whoever waits in poll; while a StopSignal lives.
    [[nodiscard]] static int descriptor();
    /// What a shell expects of a program that was stopped.
    static constexpr int exitCode = 130;
};

/// One line on standard error for work that takes more than a second: "vitrine: rendering views 40 %". On a
/// terminal it is rewritten in place and wiped at the end; in a log it is a new line at every tenth.
class ProgressLine {
public:
    explicit ProgressLine(std::string what);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `part` is 0 to 1. Returns false when the work is to stop.
    bool show(double part);
    /// With the time that is left after it: "40 %, 2:05 left".
    void estimate() { estimates_ = true; }

private:
    std::string what_;
    std::chrono::steady_clock::time_point begun_, shown_;
    bool estimates_ = false;
    bool terminal_ = false;
    int last_ = -1;  ///< What the line says, in percent; -1: there is none.
};

}  // namespace vitrine::app

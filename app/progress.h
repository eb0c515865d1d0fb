#pragma once

#include "app/stop_signal.h"

#include <chrono>
#include <string>

namespace vitrine::app {

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

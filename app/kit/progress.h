#pragma once

#include "app/kit/stop_signal.h"

#include <chrono>
#include <string>
#include <string_view>

namespace vitrine::app {

/// Progress line on standard error, for work that takes more than a second: "vitrine: rendering views 40 %". On a
/// terminal it is updated in place and erased at the end. In a log there is a new line at every tenth.
class ProgressLine {
public:
    explicit ProgressLine(std::string what);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows the progress; `part` is 0 to 1. Returns false if the work is to stop.
    bool show(double part);
    /// Changes the text from the next update on.
    void rename(std::string_view what) { what_ = what; }
    /// Adds the remaining time: "40 %, 2:05 left".
    void estimate() { estimates_ = true; }

private:
    std::string what_;
    std::chrono::steady_clock::time_point begun_, shown_;
    bool estimates_ = false;
    bool terminal_ = false;
    int last_ = -1;  ///< Percentage on display; -1: none yet.
};

}  // namespace vitrine::app

#pragma once

namespace vitrine::app {

/// From now on SIGINT (Ctrl-C) and SIGTERM end the program with `StopSignal::exitCode`, after removing every file and
/// folder that is unfinished (`render::removeUnfinished`). Call it before any other thread is started: all of them
/// leave these signals to one that waits for them. Further calls do nothing.
void endOnStopSignals();

/// While it lives, the first such signal stops work in an orderly way instead: the work asks `stopped()` between steps
/// and undoes what it began. A second signal ends the program as `endOnStopSignals` says.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    [[nodiscard]] static bool stopped();
    /// Readable once `stopped()`, for poll; while a StopSignal lives.
    [[nodiscard]] static int descriptor();
    /// Exit status that a shell expects of a program that was stopped.
    static constexpr int exitCode = 130;
};

}  // namespace vitrine::app

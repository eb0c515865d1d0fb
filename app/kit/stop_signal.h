#pragma once

namespace vitrine::app {

/// Makes SIGINT (Ctrl-C) and SIGTERM end the program with `StopSignal::exitCode`, after removing all unfinished files
/// and folders (`render::removeUnfinished`). Call before any other thread is started: all threads leave these signals
/// to one that waits for them. Further calls do nothing.
void endOnStopSignals();

/// While an object exists, the first such signal requests an orderly stop: the work polls `stopped()` between steps and
/// undoes what it began. A second signal ends the program as described for `endOnStopSignals`.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    [[nodiscard]] static bool stopped();
    /// Returns a descriptor to poll, readable once `stopped()`. Valid while a StopSignal exists.
    [[nodiscard]] static int descriptor();
    /// Exit status that a shell expects of a program that was stopped.
    static constexpr int exitCode = 130;
};

}  // namespace vitrine::app

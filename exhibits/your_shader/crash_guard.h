#pragma once

#include "exhibits/framework/files/recovery.h"
#include "exhibits/your_shader/guest_work.h"
#include "render/files/unfinished.h"

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::guest {

/// Record of the visitors' shaders that a graphics driver gets for the first time: a file that is removed when they
/// have been drawn, or when the process ends normally or is stopped. If a process died before, its file names the
/// shaders, and they are left off until their files are saved again or their programs change. Thread-safe.
class CrashGuard {
public:
    /// Reads the records of processes that died. Creates no file yet.
    explicit CrashGuard(const std::filesystem::path& folder);
    ~CrashGuard() { journal_.cleanExit(); }
    CrashGuard(const CrashGuard&) = delete;
    CrashGuard& operator=(const CrashGuard&) = delete;

    /// Returns the guard of this process; its files are in `stateFolder()`/shaders.
    [[nodiscard]] static CrashGuard& ofProcess();

    /// Returns whether a process died while it first drew this work, which nobody has changed since.
    [[nodiscard]] bool leavesOff(const Work&) const;
    /// Records that the driver gets the programs of this work now. Does nothing if they were drawn before.
    void begin(const Work&);
    /// Records that all works of `begin` have been drawn.
    void drawn();

private:
    struct Entry {
        std::string file;
        std::uint64_t programs = 0;
        std::string saved;  ///< State of the file when the driver got the programs.

        bool operator==(const Entry&) const = default;
    };
    [[nodiscard]] static Entry entryOf(const Work&);
    void read(const AbandonedSession&);
    void write();

    mutable std::mutex mutex_;
    RecoveryJournal journal_;
    std::vector<Entry> left_;                   ///< Entries of processes that died.
    std::vector<Entry> beginning_;              ///< Entries of this process whose works have not been drawn.
    std::set<std::uint64_t> wereDrawn_;         ///< Programs.
    std::optional<render::Unfinished> record_;  ///< Removes the file if the process is stopped by a signal.
};

}  // namespace vitrine::guest

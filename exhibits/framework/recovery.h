#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// What a session that did not end by itself left behind.
struct AbandonedSession {
    std::filesystem::path path;
    pid_t pid = 0;
    std::int64_t modified = 0;  ///< Seconds since 1970.
    std::string text;           ///< As written: exhibition JSON, to be parsed as untrusted.
};

/// The journal of one session: the whole state, so that a crash loses seconds and not work. Files are
/// <folder>/<pid>-<start of the process>.json: a new process that got the same number is told apart.
///
/// When to write is the caller's business.
class RecoveryJournal {
public:
    /// Creates nothing yet. `folder` is usually `stateFolder()`/recovery.
    explicit RecoveryJournal(std::filesystem::path folder);

    /// Replaces the journal of this session. Throws Failure naming file and cause.
    void write(std::string_view text) const;
    /// Removes the journal of this session: it ended as it should.
    void cleanExit() const noexcept;

    /// The journals of processes that are no longer there or are on their way out, the newest first. Unreadable ones
    /// are left out.
    [[nodiscard]] std::vector<AbandonedSession> abandoned() const;
    /// Counts the other running processes with a journal in this folder.
    [[nodiscard]] int othersRunning() const;
    /// Removes one after the user took it or declined it.
    void discard(const AbandonedSession&) const noexcept;
    /// Keeps one under another name, so that it is not offered again. Returns where it is now.
    std::filesystem::path putAside(const AbandonedSession&) const;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
};

}  // namespace vitrine

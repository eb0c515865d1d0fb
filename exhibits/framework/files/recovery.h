#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// State left by a session that did not exit normally.
struct AbandonedSession {
    std::filesystem::path path;
    pid_t pid = 0;
    std::int64_t modified = 0;  ///< Seconds since 1970.
    std::string text;           ///< Exhibition JSON as written; untrusted input.
};

/// Journal of one session: its whole state, so that a crash loses seconds instead of work. Files are
/// `FOLDER/PID-START.json`, where START is the start time of the process; it distinguishes processes that reuse a pid.
///
/// The caller decides when to write.
class RecoveryJournal {
public:
    /// Creates no file yet. `folder` is usually `stateFolder()`/recovery.
    explicit RecoveryJournal(std::filesystem::path folder);

    /// Replaces the journal of this session. Throws Failure with file and cause.
    void write(std::string_view text) const;
    /// Deletes the journal of this session after a normal exit.
    void cleanExit() const noexcept;

    /// Returns the journals of processes that have ended or are ending, the newest first. Unreadable files are skipped.
    [[nodiscard]] std::vector<AbandonedSession> abandoned() const;
    /// Counts the other running processes with a journal in this folder.
    [[nodiscard]] int othersRunning() const;
    /// Removes the journal of an abandoned session, after the user restored or declined the session.
    void discard(const AbandonedSession&) const noexcept;
    /// Renames a journal, so that it is not offered again. Returns the new path.
    std::filesystem::path putAside(const AbandonedSession&) const;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
};

}  // namespace vitrine

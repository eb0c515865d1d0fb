#include "exhibits/framework/files/recovery.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/files/state_folder.h"
#include "render/files/read_file.h"

#include <unistd.h>

#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// Returns the start time of a process in clock ticks since boot (field 22 of /proc/<pid>/stat). Returns nullopt if the
/// process does not exist or has ended. A killed process stays listed until its memory is freed (flag PF_EXITING in
/// field 9) and its parent has waited for it (state Z or X in field 3).
std::optional<std::string> startOf(pid_t pid)
{
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::size_t nameEnd = text.rfind(')');  // The process name may contain blanks and parentheses.
    if (nameEnd == std::string::npos) return std::nullopt;
    std::istringstream rest(text.substr(nameEnd + 1));
    std::string state, field, start;
    unsigned long flags = 0;
    rest >> state;
    for (int i = 4; i < 9; ++i) rest >> field;
    rest >> flags;
    for (int i = 10; i < 22; ++i) rest >> field;
    constexpr unsigned long exiting = 0x4;
    if (!(rest >> start) || state == "Z" || state == "X" || (flags & exiting) != 0) return std::nullopt;
    return start;
}

struct Owner {
    pid_t pid = 0;
    std::string start;
};

std::optional<Owner> ownerOf(const fs::path& path)
{
    const std::string stem = path.stem().string();
    const std::size_t dash = stem.find('-');
    if (path.extension() != ".json" || dash == std::string::npos) return std::nullopt;
    Owner owner;
    const std::from_chars_result end = std::from_chars(stem.data(), stem.data() + dash, owner.pid);
    if (end.ec != std::errc() || end.ptr != stem.data() + dash || owner.pid <= 0) return std::nullopt;
    owner.start = stem.substr(dash + 1);
    return owner;
}

}  // namespace

RecoveryJournal::RecoveryJournal(fs::path folder) : folder_(std::move(folder))
{
    std::string name = std::to_string(::getpid());
    (name += '-') += startOf(::getpid()).value_or("0");
    path_ = folder_ / (name += ".json");
}

void RecoveryJournal::write(std::string_view text) const
{
    writeOwnFile(path_, text);
}

void RecoveryJournal::cleanExit() const noexcept
{
    std::error_code error;
    fs::remove(path_, error);
}

std::vector<AbandonedSession> RecoveryJournal::abandoned() const
{
    std::vector<AbandonedSession> sessions;
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(folder_, error)) {
        const std::optional<Owner> owner = ownerOf(file.path());
        if (!owner || startOf(owner->pid) == owner->start) continue;
        struct stat status {};
        if (::stat(file.path().c_str(), &status) != 0) continue;
        try {
            sessions.push_back(
                {file.path(), owner->pid, status.st_mtime, render::readFile(file.path(), presetLimits.bytes)});
        } catch (const Failure&) {
            continue;  // It may have been deleted, or be unreadable.
        }
    }
    std::sort(sessions.begin(), sessions.end(), [](const auto& a, const auto& b) { return a.modified > b.modified; });
    return sessions;
}

int RecoveryJournal::othersRunning() const
{
    int others = 0;
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(folder_, error)) {
        const std::optional<Owner> owner = ownerOf(file.path());
        if (owner && owner->pid != ::getpid() && startOf(owner->pid) == owner->start) ++others;
    }
    return others;
}

void RecoveryJournal::discard(const AbandonedSession& session) const noexcept
{
    std::error_code error;
    fs::remove(session.path, error);
}

fs::path RecoveryJournal::putAside(const AbandonedSession& session) const
{
    const fs::path aside = folder_ / ("aside-" + session.path.filename().string());
    std::error_code error;
    fs::rename(session.path, aside, error);
    return error ? session.path : aside;
}

}  // namespace vitrine

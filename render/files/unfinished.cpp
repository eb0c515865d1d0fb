#include "render/files/unfinished.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

/// Returns 8 hexadecimal digits that identify this machine and its process namespace.
std::string markOfMachine()
{
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    std::string text = host.data();
    std::ifstream id("/etc/machine-id");
    text.append(std::istreambuf_iterator<char>(id), std::istreambuf_iterator<char>());
    std::error_code ignored;
    text += fs::read_symlink("/proc/self/ns/pid", ignored).string();
    std::uint32_t hash = 2166136261U;  // FNV-1a.
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    std::array<char, 9> digits{};
    std::snprintf(digits.data(), digits.size(), "%08x", hash);
    return digits.data();
}

const std::string& mark()
{
    static const std::string text = markOfMachine();
    return text;
}

bool isGone(pid_t pid)
{
    return ::kill(pid, 0) != 0 && errno == ESRCH;
}

struct Entry {
    const Unfinished* owner;
    fs::path path;
    Unfinished::Content content;
};

/// List of unfinished files. It is never destroyed, because unfinished files may end after static objects are
/// destroyed.
struct Making {
    std::recursive_mutex mutex;
    std::vector<Entry> entries;
};

Making& making()
{
    static auto* const all = new Making;
    return *all;
}

}  // namespace

std::string partSuffix(std::string_view kind)
{
    static std::atomic<unsigned> counter{0};  // Makes names unique if two threads write the same file.
    std::string suffix = ".";
    (((suffix += kind) += '-') += mark()) += '-';
    return (suffix += std::to_string(::getpid()) + '-') += std::to_string(++counter);
}

bool isLeftBehind(std::string_view fileName, std::string_view kind)
{
    std::string begin = ".";
    (((begin += kind) += '-') += mark()) += '-';
    const std::size_t at = fileName.rfind(begin);
    if (at == std::string_view::npos) return false;
    const std::string_view rest = fileName.substr(at + begin.size());
    pid_t pid = 0;
    const std::from_chars_result end = std::from_chars(rest.data(), rest.data() + rest.size(), pid);
    return end.ec == std::errc() && end.ptr != rest.data() + rest.size() && *end.ptr == '-' && pid > 0 && isGone(pid);
}

void clearLeftBehind(const fs::path& folder)
{
    static std::mutex mutex;
    static std::set<fs::path> seen;
    {
        const std::lock_guard lock(mutex);
        if (!seen.insert(folder).second) return;
    }
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.') && entry->is_regular_file(ignored) && isLeftBehind(name))
            fs::remove(entry->path(), ignored);
    }
}

Unfinished::Unfinished(fs::path path, Content content)
{
    const auto lock = unfinishedLock();
    making().entries.push_back({this, std::move(path), content});
}

Unfinished::~Unfinished()
{
    const auto lock = unfinishedLock();
    std::erase_if(making().entries, [this](const Entry& entry) { return entry.owner == this; });
}

void removeUnfinished() noexcept
{
    making().mutex.lock();  // Never unlocked.
    std::error_code ignored;
    for (const Entry& entry : making().entries)
        if (entry.content == Unfinished::Content::all) fs::remove_all(entry.path, ignored);
    for (const Entry& entry : making().entries)
        if (entry.content == Unfinished::Content::onlyIfEmpty) fs::remove(entry.path, ignored);
}

std::unique_lock<std::recursive_mutex> unfinishedLock()
{
    return std::unique_lock(making().mutex);
}

}  // namespace vitrine::render

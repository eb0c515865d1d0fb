#include "render/files/asset_store.h"

#include <sys/stat.h>

#include <algorithm>
#include <exception>
#include <new>
#include <set>

namespace vitrine::render {
namespace {

constexpr std::size_t mostEntries = 32;

std::int64_t nanoseconds(const timespec& time)
{
    return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileState fileState(const std::filesystem::path& path) noexcept
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {true, static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino), nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

FileState folderState(const std::filesystem::path& path) noexcept
{
    try {
        const std::filesystem::path folder = path.parent_path();
        return fileState(folder.empty() ? "." : folder);
    } catch (const std::bad_alloc&) {
        return {};
    }
}

const AssetStore::Entry& AssetStore::find(Key key, const std::function<void(Entry&)>& make)
{
    // Before it is read: what changes meanwhile is read again the next time.
    const FileState file = fileState(key.path);
    const FileState folder = folderState(key.path);
    const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; });
    if (same != entries_.end()) {
        if (same->file == file && (same->failure.empty() || same->folder == folder)) {
            std::rotate(same, same + 1, entries_.end());
            return entries_.back();
        }
        entries_.erase(same);
    }
    Entry fresh{.key = std::move(key), .file = file, .folder = folder};
    try {
        make(fresh);
    } catch (const std::bad_alloc&) {
        fresh.failure = "Cannot read " + fresh.key.path + ": there is not enough memory for it; choose a smaller one.";
    } catch (const std::exception& failure) {
        fresh.failure = failure.what();
    }
    entries_.push_back(std::move(fresh));
    trim();
    return entries_.back();
}

std::uint64_t AssetStore::bytes() const
{
    std::uint64_t sum = 0;
    for (const Entry& e : entries_) sum += e.bytes;
    return sum;
}

void AssetStore::trim()
{
    std::set<std::string> uses;
    std::uint64_t kept = 0;
    std::size_t count = 0;
    std::vector<Entry> stay;
    for (auto e = entries_.rbegin(); e != entries_.rend(); ++e) {
        const bool last = uses.insert(e->key.use).second;
        if (!last && ((e->bytes > 0 && kept + e->bytes > mostBytes_) || count >= mostEntries)) continue;
        kept += e->bytes;
        ++count;
        stay.push_back(std::move(*e));
    }
    std::reverse(stay.begin(), stay.end());
    entries_ = std::move(stay);
}

}  // namespace vitrine::render

#include "render/files/asset_store.h"

#include "render/hash.h"

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
    return {true, static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino),
            nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
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

struct AssetStore::Entry {
    std::string use, key;
    std::uint64_t variant;
    std::type_index type;
    bool ofFile;
    std::weak_ptr<const void> source;
    bool hasSource;
    FileState file, folder;

    std::mutex making;  ///< Held by the one who makes it. Taken before the store's, never after it.
    // Under the store's mutex:
    bool made = false;
    std::shared_ptr<const void> value{};  ///< Null while only others hold it ...
    std::weak_ptr<const void> held{};     ///< ... and it lives as long as they do.
    std::uint64_t bytes = 0;
    std::string failure{};

    Entry(const Request& r, const FileState& ofTheFile, const FileState& ofItsFolder)
        : use(r.use), key(r.key), variant(r.variant), type(r.type), ofFile(r.ofFile), source(r.source),
          hasSource(r.source != nullptr), file(ofTheFile), folder(ofItsFolder)
    {
    }

    [[nodiscard]] bool answers(const Request& r) const
    {
        const bool sameSource = hasSource ? source.lock() == r.source : r.source == nullptr;
        return use == r.use && key == r.key && variant == r.variant && type == r.type && ofFile == r.ofFile &&
               sameSource;
    }
    [[nodiscard]] std::uint64_t id() const
    {
        Hash hash;
        hash.add(use)
            .addValue('\n')
            .add(key)
            .addValue(variant)
            .addValue(file.bytes)
            .addValue(file.inode)
            .addValue(file.modified)
            .addValue(file.changed);
        return hash.value();
    }
    /// Nobody can ask for it again, or it would have to be made anew.
    [[nodiscard]] bool lost() const
    {
        return (hasSource && source.expired()) || (made && failure.empty() && !value && held.expired());
    }
};

Asset<void> AssetStore::find(Request request, const std::function<Anything()>& make)
{
    for (;;) {
        const std::shared_ptr<Entry> entry = entryOf(request);
        const std::lock_guard one(entry->making);
        {
            const std::lock_guard lock(mutex_);
            std::shared_ptr<const void> value = entry->value ? entry->value : entry->held.lock();
            if (value) return {std::move(value), {}, entry->id()};
            if (!entry->failure.empty()) return {nullptr, entry->failure, 0};
            if (entry->made) continue;  // Another thread needed its memory meanwhile.
        }
        return build(*entry, make);
    }
}

std::shared_ptr<AssetStore::Entry> AssetStore::entryOf(const Request& request)
{
    // Before it is read: what changes meanwhile is read again the next time.
    const FileState file = request.ofFile ? fileState(request.key) : FileState{};
    const FileState folder = request.ofFile ? folderState(request.key) : FileState{};
    const std::lock_guard lock(mutex_);
    const auto same =
        std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e->answers(request); });
    if (same != entries_.end()) {
        Entry& entry = **same;
        const bool fresh = entry.file == file && (entry.failure.empty() || entry.folder == folder);
        if (fresh && !entry.lost()) {
            if (!entry.value) entry.value = entry.held.lock();
            std::rotate(same, same + 1, entries_.end());
            return entries_.back();
        }
        entries_.erase(same);
    }
    entries_.push_back(std::make_shared<Entry>(request, file, folder));
    return entries_.back();
}

Asset<void> AssetStore::build(Entry& entry, const std::function<Anything()>& make)
{
    Anything made{Made<char>{}};
    std::string failure;
    try {
        made = make();
    } catch (const std::bad_alloc&) {
        failure = (entry.ofFile ? "Cannot read " + entry.key : "Cannot make " + entry.use) +
                  ": there is not enough memory for it; choose a smaller one.";
    } catch (const std::exception& thrown) {
        failure = thrown.what();
    }
    const std::lock_guard lock(mutex_);
    entry.value = made.value;
    entry.held = made.value;
    entry.bytes = made.bytes;
    entry.failure = failure;
    entry.made = true;
    ++builds_[entry.use];
    trim();
    const std::uint64_t id = made.value ? entry.id() : 0;
    return {std::move(made.value), std::move(failure), id};
}

std::uint64_t AssetStore::bytes() const
{
    const std::lock_guard lock(mutex_);
    std::uint64_t sum = 0;
    for (const auto& e : entries_)
        if (e->value) sum += e->bytes;
    return sum;
}

std::size_t AssetStore::entries() const
{
    const std::lock_guard lock(mutex_);
    return entries_.size();
}

std::int64_t AssetStore::builds(std::string_view use) const
{
    const std::lock_guard lock(mutex_);
    std::int64_t sum = 0;
    for (const auto& [name, count] : builds_)
        if (name.starts_with(use)) sum += count;
    return sum;
}

/// With the mutex locked.
void AssetStore::trim()
{
    std::set<std::string> uses;
    std::uint64_t kept = 0;
    std::size_t count = 0;
    std::vector<std::shared_ptr<Entry>> stay;
    for (auto e = entries_.rbegin(); e != entries_.rend(); ++e) {
        Entry& entry = **e;
        if (entry.lost()) continue;
        const bool last = uses.insert(entry.use).second;
        const bool tooMuch =
            !last && entry.made && ((entry.bytes > 0 && kept + entry.bytes > mostBytes_) || count >= mostEntries);
        if (tooMuch) {
            entry.value.reset();
            if (entry.held.expired()) continue;
        } else {
            if (entry.value) kept += entry.bytes;
            ++count;
        }
        stay.push_back(*e);
    }
    std::reverse(stay.begin(), stay.end());
    entries_ = std::move(stay);
}

}  // namespace vitrine::render

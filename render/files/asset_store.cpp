#include "render/files/asset_store.h"

#include "render/failure.h"
#include "render/hash.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <new>
#include <set>

namespace vitrine::render {
namespace {

constexpr std::size_t mostEntries = 32;

std::int64_t nanoseconds(const timespec& time)
{
    return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

double secondsNow()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
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

void addTo(Hash& hash, const FileState& state)
{
    hash.addValue(state.there).addValue(state.bytes).addValue(state.inode);
    hash.addValue(state.modified).addValue(state.changed);
}

struct AssetStore::Entry {
    std::string use, key;
    std::uint64_t variant;
    std::type_index type;
    bool ofFile;
    std::weak_ptr<const void> source;
    bool hasSource;
    FileState file, folder;

    std::mutex making;  ///< Held by the thread that makes the object. Locked before the store's mutex, never after it.
    // The following members are guarded by the store's mutex.
    bool made = false;
    std::shared_ptr<const void> value{};  ///< Null if the object is kept alive only by others ...
    std::weak_ptr<const void> held{};     ///< ... which this pointer then refers to.
    std::uint64_t bytes = 0;
    Message failure{};
    double lastUse = secondsNow();

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
    /// Returns whether the entry can no longer be found, or its object is gone and would have to be made again.
    [[nodiscard]] bool lost() const
    {
        return (hasSource && source.expired()) || (made && failure.empty() && !value && held.expired());
    }
};

/// State shared by the copies of a store.
struct AssetStore::Shared {
    const std::uint64_t mostBytes;
    std::mutex mutex;                             ///< Guards the members below, but not the making of an entry.
    std::vector<std::shared_ptr<Entry>> entries;  ///< In the order of last use, the latest at the end.
    std::map<std::string, std::int64_t, std::less<>> builds;

    explicit Shared(std::uint64_t most) : mostBytes(most) {}

    /// Returns the entry; null if there is none yet and `begin` is false.
    [[nodiscard]] std::shared_ptr<Entry> entryOf(const Request&, bool begin);
    /// Returns value or failure of an entry; neither if it must be made. Call it with the mutex locked.
    [[nodiscard]] static Asset<void> answer(const Entry&);
    [[nodiscard]] Asset<void> build(Entry&, const std::function<Anything()>& make);
    /// Returns whether an entry is too much beside so many bytes and entries that were used later.
    using TooMuch = std::function<bool(const Entry&, std::uint64_t bytes, std::size_t count)>;
    /// Frees entries that are too much, except the last one of each use. Call it with the mutex locked.
    void trim(const TooMuch&);
};

AssetStore::AssetStore(std::uint64_t mostBytes) : shared_(std::make_shared<Shared>(mostBytes)) {}

AssetStore AssetStore::nonBlocking() const
{
    AssetStore store = *this;
    store.waits_ = false;
    store.pending_.clear();
    return store;
}

Asset<void> AssetStore::find(Request request, const std::function<Anything()>& make)
{
    for (;;) {
        const std::shared_ptr<Entry> entry = shared_->entryOf(request, waits_);
        std::unique_lock<std::mutex> one;
        if (waits_) one = std::unique_lock(entry->making);
        if (entry) {
            const std::lock_guard lock(shared_->mutex);
            Asset<void> found = Shared::answer(*entry);
            if (found.value || !found.failure.empty()) return found;
            if (waits_ && entry->made) continue;  // Another thread freed its memory in the meantime.
        }
        if (!waits_) {
            pending_.push_back({request.use, request.ofFile ? request.key : std::string()});
            return {nullptr, {}, 0, true};
        }
        return shared_->build(*entry, make);
    }
}

Asset<void> AssetStore::Shared::answer(const Entry& entry)
{
    if (std::shared_ptr<const void> value = entry.value ? entry.value : entry.held.lock())
        return {std::move(value), {}, entry.id()};
    return {nullptr, entry.failure, 0};
}

std::shared_ptr<AssetStore::Entry> AssetStore::Shared::entryOf(const Request& request, bool begin)
{
    // Taken before the file is read: a change during reading causes another read next time.
    const FileState file = request.ofFile ? fileState(request.key) : FileState{};
    const FileState folder = request.ofFile ? folderState(request.key) : FileState{};
    const std::lock_guard lock(mutex);
    const auto same = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e->answers(request); });
    if (same != entries.end()) {
        Entry& entry = **same;
        const bool fresh = entry.file == file && (entry.failure.empty() || entry.folder == folder);
        if (fresh && !entry.lost()) {
            if (!entry.value) entry.value = entry.held.lock();
            entry.lastUse = secondsNow();
            std::rotate(same, same + 1, entries.end());
            return entries.back();
        }
        entries.erase(same);
    }
    if (!begin) return nullptr;
    entries.push_back(std::make_shared<Entry>(request, file, folder));
    return entries.back();
}

Asset<void> AssetStore::Shared::build(Entry& entry, const std::function<Anything()>& make)
{
    Anything made{Made<char>{}};
    Message failure;
    try {
        made = make();
    } catch (const std::bad_alloc&) {
        failure = entry.ofFile
                      ? message("Cannot read {1}: there is not enough memory for it; choose a smaller one.", entry.key)
                      : message("Cannot make {1}: there is not enough memory for it; choose a smaller one.", entry.use);
    } catch (const Failure& thrown) {
        failure = thrown.message();
    } catch (const std::exception& thrown) {
        failure = thrown.what();
    }
    const std::lock_guard lock(mutex);
    entry.value = made.value;
    entry.held = made.value;
    entry.bytes = made.bytes;
    entry.failure = failure;
    entry.made = true;
    ++builds[entry.use];
    trim([this](const Entry& each, std::uint64_t bytes, std::size_t count) {
        return (each.bytes > 0 && bytes + each.bytes > mostBytes) || count >= mostEntries;
    });
    const std::uint64_t id = made.value ? entry.id() : 0;
    return {std::move(made.value), std::move(failure), id};
}

void AssetStore::dropUnused(double seconds) const
{
    const std::lock_guard lock(shared_->mutex);
    if (shared_->entries.empty()) return;
    const double oldest = shared_->entries.back()->lastUse - seconds;
    shared_->trim([oldest](const Entry& entry, std::uint64_t, std::size_t) { return entry.lastUse < oldest; });
}

std::uint64_t AssetStore::bytes() const
{
    const std::lock_guard lock(shared_->mutex);
    std::uint64_t sum = 0;
    for (const auto& e : shared_->entries)
        if (e->value) sum += e->bytes;
    return sum;
}

std::size_t AssetStore::entries() const
{
    const std::lock_guard lock(shared_->mutex);
    return shared_->entries.size();
}

std::int64_t AssetStore::builds(std::string_view use) const
{
    const std::lock_guard lock(shared_->mutex);
    std::int64_t sum = 0;
    for (const auto& [name, count] : shared_->builds)
        if (name.starts_with(use)) sum += count;
    return sum;
}

void AssetStore::Shared::trim(const TooMuch& isTooMuch)
{
    std::set<std::string> uses;
    std::uint64_t kept = 0;
    std::size_t count = 0;
    std::vector<std::shared_ptr<Entry>> stay;
    for (auto e = entries.rbegin(); e != entries.rend(); ++e) {
        Entry& entry = **e;
        if (entry.lost()) continue;
        const bool last = uses.insert(entry.use).second;
        if (!last && entry.made && isTooMuch(entry, kept, count)) {
            entry.value.reset();
            if (entry.held.expired()) continue;
        } else {
            if (entry.value) kept += entry.bytes;
            ++count;
        }
        stay.push_back(*e);
    }
    std::reverse(stay.begin(), stay.end());
    entries = std::move(stay);
}

}  // namespace vitrine::render

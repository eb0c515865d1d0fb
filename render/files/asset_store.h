#pragma once

#include "render/text/message.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

namespace vitrine::render {

class Hash;

/// State of a file or folder at one time. Two states are equal if the file was not touched in between.
struct FileState {
    bool there = false;
    std::uint64_t bytes = 0;
    std::uint64_t inode = 0;
    std::int64_t modified = 0;  ///< Nanoseconds since 1970, of the content.
    std::int64_t changed = 0;   ///< Nanoseconds since 1970, of content or permissions.

    bool operator==(const FileState&) const = default;
};
/// Reads the state of a path; follows symbolic links. A path that cannot be examined counts as absent.
[[nodiscard]] FileState fileState(const std::filesystem::path&) noexcept;
/// Reads the state of the folder that contains the path.
[[nodiscard]] FileState folderState(const std::filesystem::path&) noexcept;
/// Adds all members to the hash.
void addTo(Hash&, const FileState&);

/// Object made from a file or from parameters, or the reason why it could not be made.
template <typename T> struct Asset {
    std::shared_ptr<const T> value{};
    Message failure{};  ///< One full sentence, which names the file if there is one; empty if there is a value.
    /// Hash of the source (file state or key): changes when the file changes, and is the same in every run. 0: no
    /// value.
    std::uint64_t id = 0;
    bool pending = false;  ///< Neither value nor failure yet; only from `AssetStore::nonBlocking`.
};

/// An asset that is not loaded or made yet.
struct PendingAsset {
    std::string use;
    std::string path;  ///< The file that it is read from; empty if it is made from parameters.

    bool operator==(const PendingAsset&) const = default;
};

/// Cache of objects made from users' files and from parameters. A file is read again only when it has changed; an
/// object made from parameters is made once for each key. Failures are cached, too: the file is not read again before
/// it changes. After a failure, a change of its folder counts as well, because a missing file beside it may be the
/// cause.
///
/// Older entries are kept for alternating requests (a study beside the window), within `mostBytes` and 32 entries. The
/// last entry of each use always stays, and so does any object that is still referenced elsewhere.
///
/// Thread-safe: several threads may make different objects at the same time. A thread that requests an object which
/// another is making waits for it, except through `nonBlocking()`. Copies refer to the same store.
class AssetStore {
public:
    explicit AssetStore(std::uint64_t mostBytes = 256ULL << 20U);

    /// Returns the same store for a thread that must not block: it reads no file and waits for none. Missing objects
    /// are returned as `pending`, and the returned store lists them.
    [[nodiscard]] AssetStore nonBlocking() const;
    [[nodiscard]] const std::vector<PendingAsset>& pending() const { return pending_; }

    template <typename T> struct Made {
        std::shared_ptr<const T> value;
        std::uint64_t bytes = 0;  ///< Approximate memory in use.
    };

    /// Returns the object that `make` makes from the file or folder at `path`; `make` throws if it cannot. `use` names
    /// the purpose ("hall.environment"); `variant` distinguishes objects that one use makes from the same file. Never
    /// throws.
    template <typename T>
    [[nodiscard]] Asset<T> get(std::string_view use, const std::string& path,
                               const std::function<Made<T>(const std::string&)>& make, std::uint64_t variant = 0)
    {
        return as<T>(
            find({std::string(use), path, variant, typeid(T), true, {}}, [&] { return Anything(make(path)); }));
    }

    /// Returns the object that `make` makes from parameters, which `key` must describe completely, and from the asset
    /// `source` (null: from parameters alone). Never throws.
    template <typename T>
    [[nodiscard]] Asset<T> made(std::string_view use, std::string key, const std::function<Made<T>()>& make,
                                std::shared_ptr<const void> source = {})
    {
        return as<T>(find({std::string(use), std::move(key), 0, typeid(T), false, std::move(source)},
                          [&] { return Anything(make()); }));
    }

    /// Frees entries that were not used in these seconds before the latest use of any entry, except the last one of
    /// each use.
    void dropUnused(double seconds) const;

    /// Total memory of all entries, in bytes.
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] std::size_t entries() const;
    /// Returns how often an object was made, or tried, for uses that begin with `use`.
    [[nodiscard]] std::int64_t builds(std::string_view use = {}) const;

private:
    struct Request {
        std::string use, key;
        std::uint64_t variant;
        std::type_index type;
        bool ofFile;  ///< True: `key` is the path of a file.
        std::shared_ptr<const void> source;
    };
    struct Anything {
        std::shared_ptr<const void> value;
        std::uint64_t bytes = 0;

        template <typename T> explicit Anything(Made<T> made) : value(std::move(made.value)), bytes(made.bytes) {}
    };
    struct Entry;
    struct Shared;
    template <typename T> static Asset<T> as(Asset<void> found)
    {
        return {std::static_pointer_cast<const T>(std::move(found.value)), std::move(found.failure), found.id,
                found.pending};
    }
    [[nodiscard]] Asset<void> find(Request, const std::function<Anything()>& make);

    std::shared_ptr<Shared> shared_;
    bool waits_ = true;
    std::vector<PendingAsset> pending_;
};

}  // namespace vitrine::render

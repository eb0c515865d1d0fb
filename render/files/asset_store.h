#pragma once

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

/// What a path leads to at one moment: equal while nobody touched the file.
struct FileState {
    bool there = false;
    std::uint64_t bytes = 0;
    std::uint64_t inode = 0;
    std::int64_t modified = 0;  ///< Nanoseconds since 1970, of the content.
    std::int64_t changed = 0;   ///< The same, of the content or of who may read it.

    bool operator==(const FileState&) const = default;
};
/// Follows symbolic links. What cannot be asked about is not there.
[[nodiscard]] FileState fileState(const std::filesystem::path&) noexcept;
/// Of the folder that the path lies in.
[[nodiscard]] FileState folderState(const std::filesystem::path&) noexcept;
/// All of it into a key.
void addTo(Hash&, const FileState&);

/// What was made of a file or of parameters, or why nothing could be.
template <typename T> struct Asset {
    std::shared_ptr<const T> value{};
    std::string failure{};  ///< One full sentence; of a file, it names the file. Empty when there is a value.
    std::uint64_t id =
        0;  ///< Of what it was made of: another one when the file is another or changed, on any run. 0: no value.
    bool pending = false;  ///< Neither value nor failure yet: only from `AssetStore::waitless`.
};

/// What somebody has yet to read or to make.
struct PendingAsset {
    std::string use;
    std::string path;  ///< Of the file that it is read from; empty for what is made of parameters.

    bool operator==(const PendingAsset&) const = default;
};

/// What users' files and parameters became, made once for all who ask: a file is read again only when it changed, what
/// is made of parameters is made once for each key. A failure is an entry like any other: the file is not read again
/// before it changes. One that failed counts as changed with its folder, too: what it lacks may be a file beside it.
///
/// Older entries are kept for whoever asks for them in turn (a study beside the window), as far as `mostBytes` and
/// 32 entries allow; the last one of each use always stays, and so does whatever somebody still holds. Any thread may
/// ask at any time: several make different things at once, and who asks for what another is making waits for it, but
/// for those who ask `waitless()`. Copies are the same store.
class AssetStore {
public:
    explicit AssetStore(std::uint64_t mostBytes = 256ULL << 20U);

    /// The same store for a thread that must not wait: it reads no file and waits for none. What is not there yet is
    /// `pending`, and that store names it.
    [[nodiscard]] AssetStore waitless() const;
    [[nodiscard]] const std::vector<PendingAsset>& pending() const { return pending_; }

    template <typename T> struct Made {
        std::shared_ptr<const T> value;
        std::uint64_t bytes = 0;  ///< Of memory that it holds, about.
    };

    /// What `make` makes of the file or folder at `path`; it throws when it cannot. `use` says for what
    /// ("hall.environment"), `variant` tells apart different things that one use makes of one file. Never throws.
    template <typename T>
    [[nodiscard]] Asset<T> get(std::string_view use, const std::string& path,
                               const std::function<Made<T>(const std::string&)>& make, std::uint64_t variant = 0)
    {
        return as<T>(
            find({std::string(use), path, variant, typeid(T), true, {}}, [&] { return Anything(make(path)); }));
    }

    /// What `make` makes of parameters, which `key` spells out, and of `source`, an asset that it is made from (null:
    /// of parameters alone). Never throws.
    template <typename T>
    [[nodiscard]] Asset<T> made(std::string_view use, std::string key, const std::function<Made<T>()>& make,
                                std::shared_ptr<const void> source = {})
    {
        return as<T>(find({std::string(use), std::move(key), 0, typeid(T), false, std::move(source)},
                          [&] { return Anything(make()); }));
    }

    /// Of all entries together.
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] std::size_t entries() const;
    /// How often something was made, or tried, for uses that begin so.
    [[nodiscard]] std::int64_t builds(std::string_view use = {}) const;

private:
    struct Request {
        std::string use, key;
        std::uint64_t variant;
        std::type_index type;
        bool ofFile;  ///< Then `key` is its path.
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

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

/// What was made of a file, or why nothing could be.
template <typename T> struct Asset {
    std::shared_ptr<const T> value{};
    std::string failure{};  ///< One full sentence naming the file; empty when there is a value.
};

/// What users' files became, read once while the files stay as they are. A failure is an entry like any other: the
/// file is not read again before it changes. One that failed counts as changed with its folder, too: what it lacks
/// may be a file beside it.
///
/// Older entries are kept for whoever asks for them in turn (a study beside the window), as far as `mostBytes` and
/// 32 entries allow; the last one of each use always stays. For one thread at a time.
class AssetStore {
public:
    explicit AssetStore(std::uint64_t mostBytes = 256ULL << 20U) : mostBytes_(mostBytes) {}

    template <typename T> struct Made {
        std::shared_ptr<const T> value;
        std::uint64_t bytes = 0;  ///< Of memory that it holds, about.
    };

    /// What `make` makes of the file or folder at `path`; it throws when it cannot. `use` says for what
    /// ("hall.environment"), `variant` tells apart different things that one use makes of one file. Never throws.
    template <typename T>
    [[nodiscard]] Asset<T> get(std::string_view use, const std::string& path, const std::function<Made<T>(const std::string&)>& make, std::uint64_t variant = 0)
    {
        const Entry& entry = find({std::string(use), path, variant, typeid(T)}, [&](Entry& fresh) {
            Made<T> made = make(path);
            fresh.value = std::move(made.value);
            fresh.bytes = made.bytes;
        });
        return {std::static_pointer_cast<const T>(entry.value), entry.failure};
    }

    /// Of all entries together.
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] std::size_t entries() const { return entries_.size(); }

private:
    struct Key {
        std::string use, path;
        std::uint64_t variant;
        std::type_index type;

        bool operator==(const Key&) const = default;
    };
    struct Entry {
        Key key;
        FileState file{}, folder{};
        std::shared_ptr<const void> value{};
        std::uint64_t bytes = 0;
        std::string failure{};
    };
    const Entry& find(Key, const std::function<void(Entry&)>& make);
    void trim();

    std::uint64_t mostBytes_;
    std::vector<Entry> entries_;  ///< The one used last is the last.
};

}  // namespace vitrine::render

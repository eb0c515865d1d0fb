#pragma once

#include "exhibits/framework/preset.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A preset as a list shows it.
struct PresetEntry {
    std::string name;  ///< From the file, or the file's name where it has none.
    std::filesystem::path path;
    bool shipped = false;                            ///< Part of the program: read-only.
    std::optional<std::filesystem::path> thumbnail;  ///< The picture beside it, if there is one.
    std::string problem;                             ///< Why it cannot be opened; empty when its header is good.
    PresetTags tags = {};
};

/// What a file was when it was read, to notice that someone else has changed it.
struct FileStamp {
    std::uintmax_t size = 0;
    std::int64_t modified = 0;  ///< Nanoseconds, of the file system's clock.
    std::uint64_t hash = 0;     ///< FNV-1a of the content.

    bool operator==(const FileStamp&) const = default;
};

/// A preset and the file that it came from or went to.
struct StoredPreset {
    Preset preset;
    std::filesystem::path path;
    FileStamp stamp;
    bool shipped = false;
};

enum class IfChanged : std::uint8_t { report, overwrite };
enum class SaveOutcome : std::uint8_t { saved, changedOnDisk };

/// What `PresetStore::remove` moved away.
struct RemovedPreset {
    std::filesystem::path original;
    std::filesystem::path trashed;
};

/// The presets on disk: the user's own, and those that come with the program.
///
/// Files: <folder>/<exhibit>/<slug>.json with an optional picture <slug>.png beside it. A file that could not
/// be read is never written, moved or renamed. Every function throws Failure naming file and cause, and then
/// has changed nothing.
class PresetStore {
public:
    struct Folders {
        std::filesystem::path user;
        std::filesystem::path shipped;  ///< May be missing.
        std::filesystem::path trash;
    };
    explicit PresetStore(Folders folders) : folders_(std::move(folders)) {}
    /// The user's own in `userPresetFolder()`, the trash in `stateFolder()`/trash.
    [[nodiscard]] static PresetStore standard(std::filesystem::path shipped);

    /// Shipped presets first, each part sorted by name. Files that cannot be opened are listed with their problem.
    [[nodiscard]] std::vector<PresetEntry> list(std::string_view exhibit) const;

    [[nodiscard]] StoredPreset load(const std::filesystem::path&, std::string_view exhibit, const Parameters&) const;

    /// Writes back what `load` or `saveAs` gave. Does nothing and says so when the file has changed on disk
    /// since, unless told to overwrite. A file of an older version is first copied to <slug>.v<n>.bak.
    /// Shipped presets are refused: use `saveAs`.
    [[nodiscard]] SaveOutcome save(StoredPreset&, IfChanged = IfChanged::report) const;
    /// A new file of the user's, named after `preset.name`.
    [[nodiscard]] StoredPreset saveAs(Preset) const;

    /// Changes name, file name and picture; returns the new path.
    std::filesystem::path rename(const std::filesystem::path&, std::string_view name) const;
    /// Changes the tags and nothing else.
    void setTags(const std::filesystem::path&, const PresetTags&) const;
    /// A copy of the user's own, picture included, also of a shipped preset; returns its path.
    std::filesystem::path duplicate(const std::filesystem::path&, std::string_view name) const;

    /// Moves file and picture to the trash.
    [[nodiscard]] RemovedPreset remove(const std::filesystem::path&) const;
    /// Puts them back, under another file name where theirs is taken by now; returns the path.
    std::filesystem::path restore(const RemovedPreset&) const;

    /// Copies a preset file, or the preset that a picture or recording carries, into the user's folder after reading
    /// all of it; of an exhibition, the part of this exhibit. Returns its path.
    std::filesystem::path importFile(const std::filesystem::path&, std::string_view exhibit, const Parameters&) const;
    /// Copies a preset file byte for byte to a place of the user's choice.
    void exportFile(const std::filesystem::path&, const std::filesystem::path& target) const;

    /// Where the picture of a preset is, or would be.
    [[nodiscard]] static std::filesystem::path thumbnailPath(const std::filesystem::path& preset);

private:
    [[nodiscard]] bool isShipped(const std::filesystem::path&) const;
    void refuseShipped(const std::filesystem::path&) const;
    [[nodiscard]] std::filesystem::path copyAs(const std::string& text, const std::filesystem::path& from,
                                               const std::string& exhibit, std::string_view name) const;

    Folders folders_;
};

}  // namespace vitrine

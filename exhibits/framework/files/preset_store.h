#pragma once

#include "exhibits/framework/files/document_folder.h"
#include "exhibits/framework/files/preset.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Entry of a preset in a list.
struct PresetEntry {
    std::string name;  ///< Name in the file; the file name if it has none.
    std::filesystem::path path;
    bool shipped = false;                            ///< True for read-only presets that come with the program.
    std::optional<std::filesystem::path> thumbnail;  ///< Path of the thumbnail, if there is one.
    std::string problem;                             ///< Reason why it cannot be opened; empty if its header is valid.
    PresetTags tags = {};
};

/// State of a file when it was read, to detect changes by other programs.
struct FileStamp {
    std::uintmax_t size = 0;
    std::int64_t modified = 0;  ///< Nanoseconds of the file system's clock.
    std::uint64_t hash = 0;     ///< FNV-1a hash of the content.

    bool operator==(const FileStamp&) const = default;
};

/// A preset and the file that it was read from or written to.
struct StoredPreset {
    Preset preset;
    std::filesystem::path path;
    FileStamp stamp;
    bool shipped = false;
};

enum class IfChanged : std::uint8_t { report, overwrite };
enum class SaveOutcome : std::uint8_t { saved, changedOnDisk };

/// Presets on disk: the user's presets, and those that come with the program (shipped).
///
/// Files: `FOLDER/EXHIBIT/SLUG.json` with an optional thumbnail `SLUG.png` beside it. A file that cannot be read is
/// never written, moved or renamed. Every function throws Failure with file and cause, and then has changed nothing.
class PresetStore {
public:
    struct Folders {
        std::filesystem::path user;
        std::filesystem::path shipped;  ///< May be missing.
        std::filesystem::path trash;
    };
    explicit PresetStore(Folders folders) : folders_(std::move(folders)) {}
    /// Returns a store with the user's presets in `userPresetFolder()` and the trash in `stateFolder()`/trash.
    [[nodiscard]] static PresetStore standard(std::filesystem::path shipped);

    /// Returns the shipped presets, then the user's, each sorted by name. Files that cannot be opened are listed with
    /// their problem.
    [[nodiscard]] std::vector<PresetEntry> list(std::string_view exhibit) const;

    [[nodiscard]] StoredPreset load(const std::filesystem::path&, std::string_view exhibit, const Parameters&) const;

    /// Writes back what `load` or `saveAs` gave. Does nothing and says so when the file has changed on disk
    /// since, unless told to overwrite. Shipped
    /// presets are refused: use `saveAs`.
    [[nodiscard]] SaveOutcome save(StoredPreset&, IfChanged = IfChanged::report) const;
    /// Writes a new file in the user's folder, named after `preset.name`.
    [[nodiscard]] StoredPreset saveAs(Preset) const;

    /// Renames a preset: name, file and thumbnail. Returns the new path.
    std::filesystem::path rename(const std::filesystem::path&, std::string_view name) const;
    /// Changes only the tags of a preset.
    void setTags(const std::filesystem::path&, const PresetTags&) const;
    /// Copies a preset (user's or shipped) and its thumbnail into the user's folder. Returns its path.
    std::filesystem::path duplicate(const std::filesystem::path&, std::string_view name) const;

    /// Moves a preset and its thumbnail to the trash.
    [[nodiscard]] RemovedDocument remove(const std::filesystem::path&) const;
    /// Moves a preset back from the trash, under a new file name if the old one is taken. Returns its path.
    std::filesystem::path restore(const RemovedDocument& removed) const
    {
        return restoreDocument(removed, thumbnailExtension);
    }

    /// Imports a preset file, or the preset embedded in a picture or recording, into the user's folder, after parsing
    /// all of it. Of an exhibition only the part of this exhibit is imported. Returns its path.
    std::filesystem::path importFile(const std::filesystem::path&, std::string_view exhibit, const Parameters&) const;
    /// Copies a preset file byte for byte to `target`.
    void exportFile(const std::filesystem::path&, const std::filesystem::path& target) const;

    /// Returns the path of a preset's thumbnail, which may not exist.
    [[nodiscard]] static std::filesystem::path thumbnailPath(std::filesystem::path preset)
    {
        return preset.replace_extension(thumbnailExtension);
    }

private:
    static constexpr const char* thumbnailExtension = ".png";
    [[nodiscard]] bool isShipped(const std::filesystem::path&) const;
    void refuseShipped(const std::filesystem::path&) const;
    [[nodiscard]] std::filesystem::path copyAs(const std::string& text, const std::filesystem::path& from,
                                               const std::string& exhibit, std::string_view name) const;

    Folders folders_;
};

}  // namespace vitrine

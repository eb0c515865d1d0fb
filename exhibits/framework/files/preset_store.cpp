#include "exhibits/framework/files/preset_store.h"

#include "exhibits/framework/files/slug.h"
#include "exhibits/framework/files/state_folder.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/image/image_limits.h"
#include "render/video/carried_settings.h"

#include <algorithm>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

std::string readText(const fs::path& path)
{
    return render::readFile(path, presetLimits.bytes);
}

FileStamp stampOf(const fs::path& path, std::string_view content)
{
    FileStamp stamp;
    std::error_code error;
    stamp.size = content.size();
    stamp.modified = fs::last_write_time(path, error).time_since_epoch().count();
    stamp.hash = 0xcbf29ce484222325;  // FNV-1a, 64 bits.
    for (const char c : content) stamp.hash = (stamp.hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return stamp;
}

/// Returns whether a file has changed since it was stamped. False also if it was deleted: saving then creates it again
/// and overwrites nobody's work.
bool changedSince(const fs::path& path, const FileStamp& stamp)
{
    std::error_code error;
    if (!fs::exists(path, error)) return false;
    return stampOf(path, readText(path)) != stamp;
}

PresetEntry entryFor(const fs::path& path, bool shipped)
{
    PresetEntry entry;
    entry.path = path;
    entry.shipped = shipped;
    entry.name = path.stem().string();
    std::error_code error;
    if (fs::path picture = PresetStore::thumbnailPath(path); fs::exists(picture, error))
        entry.thumbnail = std::move(picture);
    try {
        const PresetHeader header = presetHeader(render::readJson(path, presetLimits));
        if (!header.name.empty()) entry.name = header.name;
        entry.tags = header.tags;
    } catch (const Failure& failure) {
        entry.problem = failure.what();
    }
    return entry;
}

void appendFolder(const fs::path& folder, bool shipped, std::vector<PresetEntry>& out)
{
    const std::size_t first = out.size();
    for (const fs::path& file : documentsIn(folder)) out.push_back(entryFor(file, shipped));
    std::sort(
        out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
        [](const PresetEntry& a, const PresetEntry& b) { return std::tie(a.name, a.path) < std::tie(b.name, b.path); });
}

/// Returns whether `stem` is `slug`, or `slug` with a "-" and a number that made it unique.
bool standsFor(std::string_view stem, std::string_view slug)
{
    if (!stem.starts_with(slug)) return false;
    stem.remove_prefix(slug.size());
    return stem.empty() ||
           (stem.size() > 1 && stem[0] == '-' && stem.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

}  // namespace

PresetStore PresetStore::standard(fs::path shipped)
{
    return PresetStore({userPresetFolder(), std::move(shipped), stateFolder() / "trash"});
}

std::vector<PresetEntry> PresetStore::list(std::string_view exhibit) const
{
    std::vector<PresetEntry> entries;
    if (!folders_.shipped.empty()) appendFolder(folders_.shipped / exhibit, true, entries);
    appendFolder(folders_.user / exhibit, false, entries);
    return entries;
}

StoredPreset PresetStore::load(const fs::path& path, std::string_view exhibit, const Parameters& table) const
{
    const std::string text = readText(path);
    return {parsePreset(text, path.string(), exhibit, table), path, stampOf(path, text), isShipped(path)};
}

SaveOutcome PresetStore::save(StoredPreset& stored, IfChanged ifChanged) const
{
    if (stored.shipped) refuseShipped(stored.path);
    refuseShipped(stored.path);
    if (ifChanged == IfChanged::report && changedSince(stored.path, stored.stamp)) return SaveOutcome::changedOnDisk;
    const std::string text = presetText(stored.preset);
    writeOwnFile(stored.path, text);
    stored.stamp = stampOf(stored.path, text);
    return SaveOutcome::saved;
}

StoredPreset PresetStore::saveAs(Preset preset) const
{
    const std::string text = presetText(preset);
    const fs::path path = freePath(folders_.user / preset.exhibit, slugFor(preset.name));
    writeOwnFile(path, text);
    return {std::move(preset), path, stampOf(path, text), false};
}

fs::path PresetStore::rename(const fs::path& path, std::string_view name) const
{
    refuseShipped(path);
    const std::string text = renamedPreset(render::readJson(path, presetLimits), name);
    if (standsFor(path.stem().string(), slugFor(name))) {
        writeOwnFile(path, text);
        return path;
    }
    const fs::path to = freePath(path.parent_path(), slugFor(name));
    writeOwnFile(to, text);
    std::error_code error;
    fs::remove(path, error);
    moveCompanion(path, to, thumbnailExtension);
    return to;
}

void PresetStore::setTags(const fs::path& path, const PresetTags& tags) const
{
    refuseShipped(path);
    writeOwnFile(path, taggedPreset(render::readJson(path, presetLimits), tags));
}

fs::path PresetStore::copyAs(const std::string& text, const fs::path& from, const std::string& exhibit,
                             std::string_view name) const
{
    const fs::path to = freePath(folders_.user / exhibit, slugFor(name));
    writeOwnFile(to, text);
    try {
        const std::string picture = render::readFile(thumbnailPath(from), render::ImageLimits{}.fileBytes);
        render::atomicWrite(thumbnailPath(to), picture);
    } catch (const Failure&) {
        // There may be no thumbnail; it is made again when the preset is next shown.
    }
    return to;
}

fs::path PresetStore::duplicate(const fs::path& path, std::string_view name) const
{
    const render::JsonDocument document = render::readJson(path, presetLimits);
    return copyAs(renamedPreset(document, name), path, path.parent_path().filename().string(), name);
}

RemovedDocument PresetStore::remove(const fs::path& path) const
{
    refuseShipped(path);
    return removeDocument(path, folders_.trash, thumbnailExtension);
}

fs::path PresetStore::importFile(const fs::path& path, std::string_view exhibit, const Parameters& table) const
{
    std::string text;
    if (render::mayCarrySettings(path)) {
        std::optional<std::string> embedded = render::carriedSettings(path);
        if (!embedded)
            throw Failure(ErrorKind::file,
                          message("Cannot import {1}: there is no preset in this picture; choose another.", path));
        text = std::move(*embedded);
    } else {
        text = readText(path);
    }
    const bool ofEverything = presetHeader(render::parseJson(text, path.string(), presetLimits)).isExhibition;
    const Preset preset = ofEverything ? presetInExhibition(text, path.string(), exhibit, table)
                                       // The file is parsed only to check that it is valid.
                                       : parsePreset(text, path.string(), exhibit, table);
    if (ofEverything) text = presetText(preset);
    const std::string name = preset.name.empty() ? path.stem().string() : preset.name;
    const fs::path to = freePath(folders_.user / exhibit, slugFor(name));
    writeOwnFile(to, text);
    return to;
}

void PresetStore::exportFile(const fs::path& path, const fs::path& target) const
{
    const std::string text = readText(path);
    (void)presetHeader(render::parseJson(text, path.string(), presetLimits));
    render::atomicWriteMakingFolder(target, text);
}

bool PresetStore::isShipped(const fs::path& path) const
{
    if (folders_.shipped.empty()) return false;
    const fs::path relative = path.lexically_normal().lexically_relative(folders_.shipped.lexically_normal());
    return !relative.empty() && *relative.begin() != "..";
}

void PresetStore::refuseShipped(const fs::path& path) const
{
    if (!isShipped(path)) return;
    throw Failure(ErrorKind::file,
                  message("Cannot change {1}: it is part of Vitrine; save a copy under another name.", path));
}

}  // namespace vitrine

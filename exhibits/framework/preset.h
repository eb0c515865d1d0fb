#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/picture_record.h"
#include "exhibits/framework/preset_tags.h"
#include "exhibits/framework/subject.h"
#include "render/files/strict_json.h"
#include "render/scene/camera.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// The newest version that is read, and written where rows move. Older ones are read, newer ones are refused.
inline constexpr int presetVersion = 2;
/// What is written where none does: programs from before rows could move read it, too.
inline constexpr int presetVersionWithoutMotions = 1;

/// What a preset file may be at most: it is a few kilobytes, and a hostile one must not cost more.
inline constexpr render::JsonLimits presetLimits{
    .bytes = 4U << 20U, .depth = 64, .nodes = 10'000, .stringBytes = 1U << 20U};

/// Named settings of one exhibit. As a file:
///
///     {
///       "format": "vitrine-preset",
///       "version": 1,
///       "app": "0.1.0",
///       "exhibit": "sdf_morph",
///       "name": "Half a mug",
///       "values": {"morph": 0.5},
///       "camera": {"eye": [0.0, 1.0, 2.0], "target": [0.0, 1.0, 0.0], "fov": 0.9}
///     }
///
/// `values` holds only what differs from the initial values, sorted by key, in SI. Where rows move, the version is 2
/// and beside `values` stands "motions", by the same keys: {"morph": {"kind": "sine", "from": 0.1, ...}}, see
/// `jsonFromMotion`. Behind the name may stand tags: "tags": ["night", "water"], see `tagsIn`.
struct Preset {
    std::string exhibit;
    std::string name;  ///< Any UTF-8 text without control characters.
    ParameterValues values;
    std::optional<render::Camera> camera;

    int versionRead = presetVersion;             ///< Of the file it came from.
    render::Json kept = render::Json::object();  ///< The file as read and migrated: its unknown keys are written again.
    std::vector<std::string> notes;              ///< What reading changed or did not know, for people.
    PresetTags tags = {};
};

/// Reads a preset. Keys that this program does not know, at the top, in `values` and in `camera`, are kept
/// with a note; values out of range are clamped with a note ("exposure 99 -> 16 (allowed -16 to 16)");
/// missing values are initial. Throws Failure naming file, line and key for broken JSON, a key that stands
/// twice, a wrong type, an unknown choice, another format or exhibit, or a newer version; nothing of the
/// caller's changes. Keys that may be rows which a file gives the table become pending values of the result.
[[nodiscard]] Preset parsePreset(std::string text, std::string fileName, std::string_view exhibit, const Parameters&);

/// The text of a preset file, with the unknown keys of `kept`. Throws Failure when a number is not finite.
[[nodiscard]] std::string presetText(const Preset&);

/// Values of all subjects by name, in the order of the museum.
using NamedValues = std::vector<std::pair<std::string, ParameterValues>>;

/// Values beside the names of the subjects that they belong to; both in the same order.
[[nodiscard]] NamedValues namedValues(Subjects, std::span<const ParameterValues>);

/// Settings of everything: "format" is "vitrine-exhibition", "exhibit" is the one that was chosen, and the keys of
/// `values` are "sdf_morph.morph", "hall.exposure", ... Inside a picture, "picture" says how it was taken.
struct Exhibition {
    std::string name;
    NamedValues values;
    render::Camera camera;

    render::Json kept = render::Json::object();
    std::vector<std::string> notes;
    std::string chosen = {};  ///< The exhibit whose parameters were on show; empty: not known.
    PresetTags tags = {};
    std::optional<PictureRecord> picture = std::nullopt;
};

/// As `parsePreset`. `initial` names the exhibits and gives their tables; values not in the file get their
/// table's initial ones. Values of exhibits that are not there are kept with a note.
[[nodiscard]] Exhibition parseExhibition(std::string text, std::string fileName, const NamedValues& initial);

[[nodiscard]] std::string exhibitionText(const Exhibition&);

/// The part of an exhibition that is one exhibit's, as a preset: its values, name, tags and the camera. Throws Failure
/// as `parseExhibition`, and where it was made of another exhibit and changes nothing of this one.
[[nodiscard]] Preset presetInExhibition(std::string text, std::string fileName, std::string_view exhibit,
                                        const Parameters&);

/// What kind of file a text is, without reading its values. Throws Failure when it is no preset at all.
struct PresetHeader {
    bool isExhibition = false;
    std::string exhibit;  ///< Of an exhibition: the chosen one, or empty.
    std::string name;
    int version = presetVersion;
    PresetTags tags = {};
};
[[nodiscard]] PresetHeader presetHeader(const render::JsonDocument&);

/// The same file with another name; everything else stays as it was written. Throws Failure as `presetHeader`.
[[nodiscard]] std::string renamedPreset(const render::JsonDocument&, std::string_view name);

}  // namespace vitrine

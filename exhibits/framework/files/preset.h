#pragma once

#include "exhibits/framework/files/picture_record.h"
#include "exhibits/framework/files/preset_tags.h"
#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/framework/table/parameters.h"
#include "render/files/strict_json.h"
#include "render/scene/camera.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// Version of the format that is read and written; files of another one are refused.
inline constexpr int presetVersion = 1;

/// Limits for reading a preset file. A normal file has a few kilobytes; the limits bound the cost of a malicious one.
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
/// `values` holds only what differs from the initial values, sorted by key, in SI. Where parameters move, "motions"
/// stands beside `values`, by the same keys: {"morph": {"kind": "sine", "from": 0.1, ...}}, see
/// `jsonFromMotion`. Behind the name may stand tags: "tags": ["night", "water"], see `tagsIn`.
struct Preset {
    std::string exhibit;
    std::string name;  ///< Any UTF-8 text without control characters.
    ParameterValues values;
    std::optional<render::Camera> camera;

    render::Json kept = render::Json::object();  ///< The file as read: its unknown keys are written again.
    std::vector<std::string> notes;              ///< Sentences on values that reading changed or did not know.
    PresetTags tags = {};
};

/// Reads a preset. Unknown keys at the top level, in `values` and in `camera` are kept, with a note. Values out of
/// range are clamped, with a note ("exposure 99 -> 16 (allowed -16 to 16)"). Missing values get their initial value.
/// Keys that may be parameters added to the table by a file become pending values of the result. Throws Failure with
/// file, line and key for malformed JSON, a duplicate key, a wrong type, an unknown choice, a wrong format or exhibit,
/// or a newer version. Never changes an argument.
[[nodiscard]] Preset parsePreset(std::string text, std::string fileName, std::string_view exhibit, const Parameters&);

/// Returns the text of a preset file, including the unknown keys of `kept`. Throws Failure if a number is not finite.
[[nodiscard]] std::string presetText(const Preset&);

/// Names and values of all subjects, in the order of the museum.
using NamedValues = std::vector<std::pair<std::string, ParameterValues>>;

/// Pairs the names of the subjects with their values; both must be in the same order.
[[nodiscard]] NamedValues namedValues(Subjects, std::span<const ParameterValues>);

/// Settings of the whole museum. As a file: "format" is "vitrine-exhibition", "exhibit" is the selected exhibit, and
/// the keys of `values` are "sdf_morph.morph", "hall.exposure", ... Embedded in a picture, "picture" also stores how it
/// was rendered.
struct Exhibition {
    std::string name;
    NamedValues values;
    render::Camera camera;

    render::Json kept = render::Json::object();
    std::vector<std::string> notes;
    std::string chosen = {};  ///< Exhibit whose parameters were shown; empty: unknown.
    PresetTags tags = {};
    std::optional<PictureRecord> picture = std::nullopt;
};

/// Reads an exhibition like `parsePreset`. `initial` contains the names and tables of the exhibits. Values missing in
/// the file get their initial value. Values of unknown exhibits are kept, with a note.
[[nodiscard]] Exhibition parseExhibition(std::string text, std::string fileName, const NamedValues& initial);

[[nodiscard]] render::Json exhibitionJson(const Exhibition&);
[[nodiscard]] std::string exhibitionText(const Exhibition&);

/// Extracts the preset of one exhibit from an exhibition: its values, name, tags and the camera. Throws Failure like
/// `parseExhibition`, and also if the file was saved from another exhibit and changes nothing of this one.
[[nodiscard]] Preset presetInExhibition(std::string text, std::string fileName, std::string_view exhibit,
                                        const Parameters&);

/// Kind of a preset file, read without its values. Reading throws Failure if the file is not a preset.
struct PresetHeader {
    bool isExhibition = false;
    std::string exhibit;  ///< Name of the exhibit; for an exhibition, of the selected one, or empty.
    std::string name;
    PresetTags tags = {};
};
[[nodiscard]] PresetHeader presetHeader(const render::JsonDocument&);

/// Returns the same file with another name; everything else is unchanged. Throws Failure like `presetHeader`.
[[nodiscard]] std::string renamedPreset(const render::JsonDocument&, std::string_view name);

}  // namespace vitrine

#pragma once

#include "render/files/strict_json.h"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Short words for finding presets, in the order in which they were given.
using PresetTags = std::vector<std::string>;

inline constexpr std::size_t mostPresetTags = 16;
inline constexpr std::size_t mostPresetTagBytes = 40;

/// Returns the tags of a preset or exhibition: "tags": ["night", "water"]; none if the key is missing. Throws Failure
/// naming file, line and key unless it is an array of at most `mostPresetTags` texts. Each has 1 to
/// `mostPresetTagBytes` bytes of UTF-8 without commas, control characters or blanks at its ends; all must differ,
/// ignoring the case of A to Z.
[[nodiscard]] PresetTags tagsIn(const render::JsonDocument&, const render::Json& root);

/// Parses typed tags, separated by commas. Blanks at the ends, empty tags and repeated ones are dropped. Throws Failure
/// (ErrorKind::usage) for an invalid tag, or if there are too many.
[[nodiscard]] PresetTags tagsFromText(std::string_view);

/// Returns the same file with other tags; everything else stays as it was written. Throws Failure as `presetHeader`.
[[nodiscard]] std::string taggedPreset(const render::JsonDocument&, const PresetTags&);

}  // namespace vitrine

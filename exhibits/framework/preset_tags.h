#pragma once

#include "render/files/strict_json.h"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Short words by which presets are found, in the order that they were given.
using PresetTags = std::vector<std::string>;

inline constexpr std::size_t mostPresetTags = 16;
inline constexpr std::size_t mostPresetTagBytes = 40;

/// The tags of a preset or exhibition: "tags": ["night", "water"]; none where the key is not there. Throws Failure
/// naming file, line and key for anything else than an array of at most `mostPresetTags` texts, each of 1 to
/// `mostPresetTagBytes` bytes of UTF-8 without commas, control characters or blanks at its ends, none of which stands
/// twice (upper and lower case of A to Z are one).
[[nodiscard]] PresetTags tagsIn(const render::JsonDocument&, const render::Json& root);

/// What somebody typed, separated by commas: blanks at the ends, empty ones and repeated ones are left out. Throws
/// Failure (Blame::usage) saying what is no tag, or that there are too many.
[[nodiscard]] PresetTags tagsFromText(std::string_view);

/// The same file with other tags; everything else stays as it was written. Throws Failure as `presetHeader`.
[[nodiscard]] std::string taggedPreset(const render::JsonDocument&, const PresetTags&);

}  // namespace vitrine

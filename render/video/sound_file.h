#pragma once

#include "render/image/sound.h"

#include <filesystem>

namespace vitrine::render {

/// Extensions of the sounds that are read, as `ParameterInfo::extensions` has them: "wav flac".
inline constexpr const char* soundEndings = "wav flac";

/// Reads a WAV or FLAC file. Sounds that are longer than `longestSound` are refused; of more than `mostSoundChannels`
/// channels, the first ones are read. Throws Failure naming the file.
[[nodiscard]] Sound readSound(const std::filesystem::path&);

}  // namespace vitrine::render

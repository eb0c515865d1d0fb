#pragma once

#include "render/image/video_codec.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::render {

/// Returns whether the name is that of a picture or a recording, which may contain settings. Other files are settings
/// files themselves.
[[nodiscard]] bool mayCarrySettings(const std::filesystem::path&);
/// Extensions of the files that can carry settings, in the form of `ParameterInfo::extensions`: "png jpg mp4".
[[nodiscard]] std::string carriedSettingsEndings();

/// Returns the settings text inside a picture (`embeddedPreset`) or a recording (its comment, as `VideoFile` writes
/// it); nothing if there is none. The text is untrusted. Throws Failure naming the file if it cannot be read.
[[nodiscard]] std::optional<std::string> carriedSettings(const std::filesystem::path&);

/// The same for a recording in this format, whatever its name.
[[nodiscard]] std::optional<std::string> carriedSettings(const std::filesystem::path&, VideoFormat);

}  // namespace vitrine::render

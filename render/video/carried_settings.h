#pragma once

#include "render/video/video_codec.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::render {

/// Whether a file of this name is a picture or a recording, which may carry settings; other files are settings
/// themselves.
[[nodiscard]] bool mayCarrySettings(const std::filesystem::path&);

/// The settings text that a picture (`embeddedPreset`) or a recording (its comment, as `VideoFile` writes it) carries;
/// nothing where it carries none. It is text from a file: parse it as untrusted. Throws Failure naming the file when it
/// cannot be read.
[[nodiscard]] std::optional<std::string> carriedSettings(const std::filesystem::path&);

/// The same of a recording in this format, whatever its name.
[[nodiscard]] std::optional<std::string> carriedSettings(const std::filesystem::path&, VideoFormat);

}  // namespace vitrine::render

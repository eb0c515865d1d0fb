#pragma once

#include "app/picture_options.h"

#include <string>

namespace vitrine::app {

/// The text of a preset: the file itself, or what a picture, a recording or the description of a print carries. Throws
/// Failure naming the file.
[[nodiscard]] std::string presetTextOf(const std::string& file);

/// Reads a preset of the subject, an exhibition, or what a picture or recording carries into the scene state, and how
/// that picture was taken.
/// Throws Failure naming file, line and key; the scene state is then unchanged.
/// A shipped preset of the subject may be given by its name: "old-gold".
/// Returns a sentence where the picture is of something else, so that only its settings were taken; else nothing.
std::string applyPreset(const Museum&, const std::string& given, RequestedPicture&);

}  // namespace vitrine::app

#pragma once

#include "app/kit/picture_options.h"

#include <string>

namespace vitrine::app {

/// Returns the text of a preset: the content of a preset file, or the preset inside a picture, a recording or the
/// description of a print. Throws Failure naming the file.
[[nodiscard]] std::string presetTextOf(const std::string& file);

/// Applies a preset, an exhibition, or the preset inside a picture or recording to the requested picture, together with
/// the record of how that picture was taken. `given` is a path, or the name of a shipped preset of the subject:
/// "old-gold". Returns a sentence if the picture shows another subject, so that only its settings were taken; empty
/// otherwise. Throws Failure naming file, line and key; the scene state is then unchanged.
std::string applyPreset(const Museum&, const std::string& given, RequestedPicture&);

}  // namespace vitrine::app

#pragma once

#include "exhibits/museum/picture.h"

#include <optional>
#include <string>

namespace vitrine::jobs {

/// Returns the channels beyond color that a text names, separated by commas. Throws Failure (ErrorKind::usage) for
/// another name.
[[nodiscard]] PictureRecord channelsNamed(const std::string& text);
/// Adds channels to a request. Throws Failure (ErrorKind::usage) for motion without a frame before.
void addChannels(const PictureRecord& named, const std::optional<FrameBefore>& before, PictureRequest&);

}  // namespace vitrine::jobs

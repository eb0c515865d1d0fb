#pragma once

#include "render/files/strict_json.h"

#include <filesystem>
#include <string>

namespace vitrine::printing {

/// Description of a print, and doubts about it.
struct PrintDescription {
    render::JsonDocument document;
    /// One or two full sentences if the file beside the print describes another print; otherwise empty.
    std::string doubt{};
};

/// Returns the description inside a print, which was written with its pixels. The file beside it is used if the print
/// has lost its own. Throws Failure naming the file if there is neither.
[[nodiscard]] PrintDescription printDescription(const std::filesystem::path&);

}  // namespace vitrine::printing

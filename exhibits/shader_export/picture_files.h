#pragma once

#include "exhibits/shader_export/exported_shader.h"

#include <filesystem>
#include <string>

namespace vitrine::guest {

/// Returns the path, relative to the output, of a picture that the shader names relative to its own folder. A picture
/// in another folder is added to the files, beside the output. Throws Failure if it cannot be read, if it lies outside
/// of the shader's folder, or if another file of its name lies beside the output.
[[nodiscard]] std::string besideOutput(const std::filesystem::path& shader, const std::string& picture,
                                       const std::filesystem::path& out, ExportedFiles&);

/// Returns the bytes of a picture file, which must lie in the shader's folder or below. Throws Failure.
[[nodiscard]] std::string pictureBytes(const std::filesystem::path& shader, const std::string& picture);

}  // namespace vitrine::guest

#pragma once

#include <filesystem>
#include <string>

namespace vitrine::render {

/// Returns the extension in lower case: ".png" for "Picture.PNG"; empty if there is none. Converts ASCII letters only.
[[nodiscard]] inline std::string lowerExtension(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace vitrine::render

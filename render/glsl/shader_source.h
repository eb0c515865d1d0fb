#pragma once

#include "render/glsl/shader_key.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Shader text with its includes resolved. `files[n]` is the file for the source number n of `#line`; see `firstError`.
struct ShaderText {
    std::string text;
    std::vector<std::string> files;
};

/// Reads the files under shaders/: from disk in a debug build, from the executable otherwise.
class ShaderSource {
public:
    /// Uses the program's own shaders: embedded, or the folder of a debug build.
    ShaderSource();
    /// Reads every file from this folder.
    explicit ShaderSource(std::filesystem::path folder);

    /// Returns the text of one file, named as `list` does, or nothing if there is none: a folder is no file, and no
    /// name leads out of shaders/. Throws Failure as `readFileBeneath` does.
    [[nodiscard]] std::optional<std::string> read(std::string_view file) const;

    /// Returns the complete text of a shader: `#version 450 core`, one `#define` per entry of `defines`, the prelude,
    /// then the file. Every `#include "path"` (relative to shaders/) is replaced by its text, once per file. An entry
    /// of `generated` takes precedence over a file of the same path. Throws Failure (ErrorKind::shader) for a missing
    /// file or an include nested deeper than 16.
    [[nodiscard]] ShaderText load(std::string_view file, const std::vector<std::string>& defines,
                                  std::string_view prelude = {}, const ShaderSources* generated = nullptr) const;

    /// Returns whether files can change while the program runs.
    [[nodiscard]] bool onDisk() const { return folder_.has_value(); }
    [[nodiscard]] const std::optional<std::filesystem::path>& folder() const { return folder_; }
    /// Returns the paths of all files, relative to shaders/.
    [[nodiscard]] std::vector<std::string> list() const;

private:
    std::optional<std::filesystem::path> folder_;
};

/// Error message of a driver about a shader, parsed from its log.
struct ShaderMessage {
    std::string file;
    int line = 0;
    std::string text;
};

/// Finds file, line and text of the first error in a compiler's log. Understands the formats of Mesa
/// ("2:17(5): error: …"), NVIDIA ("2(17) : error C…") and Intel/AMD ("ERROR: 2:17: …").
[[nodiscard]] ShaderMessage firstError(std::string_view log, const std::vector<std::string>& files);

}  // namespace vitrine::render

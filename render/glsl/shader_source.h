#pragma once

#include "render/plan/shader_key.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// A shader with its includes resolved. `files[n]` is the file that `#line … n` means; `firstError` knows how.
struct ShaderText {
    std::string text;
    std::vector<std::string> files;
};

/// Reads the files under shaders/: from disk in a debug build, from the program itself otherwise.
class ShaderSource {
public:
    /// The program's own shaders: embedded, or the folder of a debug build.
    ShaderSource();
    /// Every file from this folder.
    explicit ShaderSource(std::filesystem::path folder);

    /// The text of one file, or nothing.
    [[nodiscard]] std::optional<std::string> read(std::string_view file) const;

    /// `#version 450 core`, one `#define` per entry of `defines`, the prelude, then the file with every
    /// `#include "path"` (relative to shaders/) replaced by its text, once per file. What `generated` has under a
    /// path comes before the file of that path. Throws Failure (Blame::shader) for a missing file or an include nested
    /// deeper than 16.
    [[nodiscard]] ShaderText load(std::string_view file, const std::vector<std::string>& defines,
                                  std::string_view prelude = {}, const ShaderSources* generated = nullptr) const;

    /// Whether files can change under a running program.
    [[nodiscard]] bool onDisk() const { return folder_.has_value(); }
    [[nodiscard]] const std::optional<std::filesystem::path>& folder() const { return folder_; }
    /// All files, by path relative to shaders/.
    [[nodiscard]] std::vector<std::string> list() const;

private:
    std::optional<std::filesystem::path> folder_;
};

/// A driver's complaint about a shader, as found in its log.
struct ShaderMessage {
    std::string file;
    int line = 0;
    std::string text;
};

/// Finds file, line and text of the first error in a compiler's log; understands the forms of Mesa
/// ("2:17(5): error: …"), NVIDIA ("2(17) : error C…") and Intel/AMD ("ERROR: 2:17: …").
[[nodiscard]] ShaderMessage firstError(std::string_view log, const std::vector<std::string>& files);

}  // namespace vitrine::render

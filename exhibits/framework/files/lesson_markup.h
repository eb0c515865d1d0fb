#pragma once

#include "render/text/message.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Most lines of a shader that a lesson shows at once.
inline constexpr std::size_t mostShaderLines = 16;

/// How the parts of a lesson's text become HTML that are not the same everywhere.
struct LessonMarkup {
    /// Returns the HTML of a parameter, `[row:NAME]`.
    std::function<std::string(std::string_view name)> parameter;
    /// Returns the HTML of a picture in the lesson's folder, with its alternative text; both are not escaped.
    std::function<std::string(const std::string& file, const std::string& alternative)> picture;
    std::filesystem::path folder;  ///< Folder of the lesson.
};

/// Error in a lesson's text.
struct LessonMarkupProblem {
    std::size_t at = 0;  ///< Place in the text, in bytes.
    Message what;
};

/// Converts a lesson's text (Markdown) to HTML: paragraphs, lists, emphasis, `code`, blocks of code, links, pictures,
/// and formulas between $ signs, which become MathML (`mathMlOfTex`). HTML tags in the text are shown as they are
/// written. Errors are added to `problems`: links that are not http or https, pictures that are not in the lesson's
/// folder, and formulas that cannot be read, which stay as they are written.
[[nodiscard]] std::string lessonHtml(std::string_view text, const LessonMarkup&,
                                     std::vector<LessonMarkupProblem>* problems = nullptr);

/// Part of a shader that a lesson shows, written as the first line of a block of code: "glsl fur/shells.frag 10-20", or
/// with the name of a function instead of the lines.
struct ShaderPart {
    std::string text;      ///< Lines of the shader; empty if there is a problem.
    Message problem = {};  ///< Empty: none.
};

/// Reads a part of a shader of the program. `words`: file below shaders/, whose folder is an exhibit or "lib", and
/// lines or function. `exhibits`: names of all exhibits.
[[nodiscard]] ShaderPart shaderPart(std::string_view words, const std::vector<std::string>& exhibits);

}  // namespace vitrine

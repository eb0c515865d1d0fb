#pragma once

#include "exhibits/your_shader/guest_reader.h"
#include "exhibits/your_shader/guest_shader.h"
#include "render/glsl/lexer.h"

#include <optional>
#include <string>
#include <string_view>

// Functions that the readers of all forms use.
namespace vitrine::guest {

/// Reads a shader: the description made so far, and the files beside it.
struct Reading {
    Shader shader;
    const FileBeside& beside;
    std::size_t includes = 0;

    /// Adds a file and returns its index.
    std::uint32_t addFile(const std::string& name, std::string text);
    /// Adds a remark.
    void note(std::uint32_t file, int line, std::string_view word, Message sentence);
};

/// Returns the error at a word of a line of a file.
[[nodiscard]] Refused refused(const Reading&, std::uint32_t file, int line, std::string_view word, Message sentence);

/// Returns the code of a file, with its `#include "name"` lines replaced by the files that they name. Throws Refused.
[[nodiscard]] Code withIncludes(Reading&, std::uint32_t file, std::size_t depth = 0);

/// Refuses macros that expand to more than Limits::macroTokens tokens, which would fill the memory of the compiler.
void refuseMacroBombs(const Reading&);

/// Settings of a slider in a comment: `0.1 .. 2, default 0.5, exact 1, m, "Size"`, or `color, default 1 0.5 0, "Tint"`.
/// Everything but the range or the word may be left out; numbers of a vector stand behind each other. Without a
/// default, `input.initial` counts if it is not empty. `components` is the number of values of the input. Returns
/// whether the comment has this form; a comment that begins so but goes on differently is refused with the word that is
/// wrong. Throws Refused.
bool readRangeComment(std::string_view comment, std::size_t components, Input& input, const Reading&,
                      std::uint32_t file, int line);

/// Refuses what cannot be the name of a variable.
void requireName(const Reading&, const std::string& name, std::uint32_t file, int line);

/// Adds an input, checking its name and the number of inputs. A name that is used twice is refused.
void addInput(Reading&, Input, std::uint32_t file, int line);

/// Returns the text without quotes around it.
[[nodiscard]] std::string unquoted(std::string_view text);

/// Returns the value of a number of GLSL: ".5", "1.", "2.0f"; nothing for other words.
[[nodiscard]] std::optional<double> glslNumber(std::string_view glsl);

/// Returns the number of components of a GLSL type: 1 to 4; 0 for other types.
[[nodiscard]] std::size_t componentsOf(std::string_view glslType);

void readIsf(Reading&, std::uint32_t file);
void readShadertoyText(Reading&, std::uint32_t file);
void readShadertoyJson(Reading&, std::uint32_t file);
void readPlain(Reading&, std::uint32_t file);

/// Returns whether the first comment of a text holds a JSON object.
[[nodiscard]] bool isIsf(std::string_view text);

}  // namespace vitrine::guest

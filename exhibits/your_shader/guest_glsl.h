#pragma once

#include "exhibits/your_shader/guest_shader.h"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::guest {

/// GLSL 4.50 of one pass, for glslang. Source numbers of `#line` are indices of `Shader::files`; `ownSource` marks
/// lines that are not the visitor's.
struct PassText {
    static constexpr std::uint32_t ownSource = 9999;
    std::string vertex, fragment;
};

/// Picture that a pass may read. Its texture unit is its index in `picturesOf`.
struct PictureUse {
    enum class Source : std::uint8_t { input, target, import, channel };
    Source source = Source::input;
    std::size_t index = 0;  ///< Index of the input, pass, import or channel.
    std::string name;       ///< As the visitor wrote it.
    std::string glslType;
};

/// Returns the pictures that a pass declares, in the order of their texture units.
[[nodiscard]] std::vector<PictureUse> picturesOf(const Shader&, const Pass&);

/// Returns the number of triangles that a pass is drawn with, as instances of three vertices each: two for a vertex
/// shader of the visitor, else one that is larger than the picture.
[[nodiscard]] int trianglesOf(const Shader&);

/// A variable that a plain fragment shader expects of its vertex shader.
struct Varying {
    std::string type, name;
};
/// Returns the variables that the code declares with `in` or `varying`, each name once.
[[nodiscard]] std::vector<Varying> varyingsOf(const Code&);

/// Returns whether an input is a picture.
[[nodiscard]] bool isPicture(const Input&);

/// Returns the text of a pass: the visitor's code with today's names for what old GLSL called differently, behind the
/// declarations of its inputs. Lines and line numbers stay those of the visitor.
[[nodiscard]] PassText passText(const Shader&, const Pass&);

/// Returns the name under which a visitor's variable stands in the program: "sample" is reserved today.
[[nodiscard]] std::string programName(std::string_view visitorsName);

/// Returns the name that the visitor wrote.
[[nodiscard]] std::string_view visitorsName(std::string_view programName);

/// Returns the findings of glslang's log, in the visitor's numbering: at most Limits::findings.
[[nodiscard]] std::vector<Finding> findingsOf(const Shader&, std::string_view log);

/// Returns the text of SPIRV-Cross with a counter in the head of every loop: after `GUEST_ROUNDS` rounds in all loops
/// together, every loop ends. GUEST_ROUNDS is a define of the program. Returns an empty text if a loop has a form that
/// SPIRV-Cross does not write.
[[nodiscard]] std::string withLoopGuard(const std::string& glsl);

}  // namespace vitrine::guest

#pragma once

#include "render/text/message.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// A visitor's shader, as its readers describe it. Nothing here depends on the form in which the shader came.
namespace vitrine::guest {

/// Upper limits for a visitor's shader. Each is refused with a sentence.
struct Limits {
    static constexpr std::size_t textBytes = 1U << 20U;  ///< Size of one file.
    static constexpr std::size_t inputs = 256;
    static constexpr std::size_t inputsOfAKind = 64;
    static constexpr std::size_t passes = 32;
    static constexpr std::size_t imports = 16;
    static constexpr std::size_t includeDepth = 8;
    static constexpr std::size_t includes = 64;
    static constexpr std::size_t expressionBytes = 256;
    static constexpr std::size_t choices = 256;
    static constexpr std::size_t macroTokens = 100'000;
    static constexpr int side = 8192;      ///< Width and height of a buffer, in pixels.
    static constexpr int cubeSide = 1024;  ///< Width and height of the faces of Cube A, in pixels, as on Shadertoy.
    static constexpr std::size_t findings = 20;
};

/// Form in which a shader is written.
enum class Form : std::uint8_t {
    isf,        ///< Interactive Shader Format: JSON in the first comment, then `main`.
    shadertoy,  ///< `mainImage`, as text or as Shadertoy's JSON.
    plain,      ///< `main` with uniforms of glslViewer, The Book of Shaders or GLSL Sandbox.
};

/// Error or remark about a shader, in the visitor's numbering.
struct Finding {
    std::string file;
    int line = 1, column = 1;  ///< From 1; columns in bytes.
    Message sentence;          ///< With its full stop.
    bool isError = true;       ///< False: the shader is drawn nevertheless.
};

/// Kind of an input that the visitor of the hall can set.
enum class InputType : std::uint8_t {
    real,
    toggle,
    integer,
    choice,
    color,
    point,
    vector,
    event,
    image,
    audio,
    spectrum
};

struct InputChoice {
    int value = 0;
    std::string label;
};

/// An input of a shader: a parameter, or a picture.
struct Input {
    std::string name;  ///< Name of the variable, as the visitor wrote it.
    InputType type = InputType::real;
    std::string glslType;  ///< "float", "vec4", "sampler2D".
    std::string label;
    /// Limits and initial value, one number for each component; empty for pictures and buttons. The upper limit of a
    /// sound is its number of columns.
    std::vector<double> low, high, initial;
    std::optional<double> exact;       ///< Value that counts as exact, of an accuracy setting.
    std::vector<InputChoice> choices;  ///< Choices of an input of type `choice`, in the order shown.
    std::string unit;                  ///< "m", "deg"; empty for plain numbers.
    std::string source;                ///< Source of a picture: its file or its page on the site.
};

/// Variable that the program fills for each frame.
struct BuiltIn {
    std::string name;  ///< "TIME", "iResolution", "u_mouse".
    std::string glslType;
    std::size_t count = 0;  ///< Length of an array; 0: no array.
};

/// Variable with the number of the face that a pass of a cube map draws, as `DrawnPass::face`.
inline constexpr const char* cubeFaceName = "guest_cube_face";

/// Code that stands in one file without a gap.
struct CodePiece {
    std::uint32_t file = 0;  ///< Index in `Shader::files`.
    int line = 1;            ///< Line of the first character.
    std::string text;
};
using Code = std::vector<CodePiece>;

struct SourceFile {
    std::string name;  ///< As messages show it.
    std::string text;  ///< As it was read, with line ends "\n".
};

/// Buffer that a pass reads by a name of its own: Shadertoy's iChannel0.
struct Channel {
    std::string name;      ///< "iChannel0".
    std::string glslType;  ///< "sampler2D", "samplerCube" or "sampler3D".
    std::string kind;      ///< "buffer", "texture", "keyboard", "cubemap", "volume".
    std::string source;    ///< Target of the pass, or file.
    std::string filter, wrap;
    bool flipped = false;
};

/// One drawing of the shader.
struct Pass {
    std::string name;    ///< "Buffer A", "pass 1".
    std::string target;  ///< Buffer that it draws into; empty: the picture.
    bool isPersistent = false;
    bool isFloat = false;
    bool isCube = false;        ///< Shadertoy's Cube A: `mainCubemap` draws the six faces of a cube map.
    std::string width, height;  ///< Size expressions (`passSize`); empty: the size of the picture.
    Code code;
    std::vector<std::string> defines;
    std::vector<Channel> channels;
};

struct Import {
    std::string name;
    std::string path;  ///< Beside the shader.
};

/// A visitor's shader.
struct Shader {
    Form form = Form::plain;
    std::string version;  ///< "2", "1" of ISF; else empty.
    std::string title, description, credit;
    std::vector<std::string> categories;
    std::vector<Input> inputs;
    std::vector<BuiltIn> builtIns;
    std::vector<Import> imports;
    std::vector<Pass> passes;  ///< In drawing order; at least one.
    Code vertexCode;           ///< Empty: a triangle that covers the picture.
    std::vector<SourceFile> files;
    std::vector<Finding> notes;  ///< Remarks; no errors.

    /// Returns the input of a name, or null.
    [[nodiscard]] const Input* inputNamed(const std::string& name) const
    {
        for (const Input& input : inputs)
            if (input.name == name) return &input;
        return nullptr;
    }
};

/// Error of reading a shader, with its place.
class Refused {
public:
    explicit Refused(Finding finding) : finding_(std::move(finding)) {}
    [[nodiscard]] const Finding& finding() const { return finding_; }

private:
    Finding finding_;
};

}  // namespace vitrine::guest

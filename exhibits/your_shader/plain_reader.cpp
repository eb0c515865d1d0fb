#include "exhibits/your_shader/reading.h"

#include "render/files/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::guest {
namespace {

/// Uniforms that the dialects of plain shaders share. A trailing number is ignored: u_tex0, u_tex1.
bool isBuiltIn(std::string_view name)
{
    static constexpr std::string_view names[] = {"u_time",  "u_delta",     "u_resolution", "u_mouse",
                                                 "u_frame", "u_date",  // glslViewer, The Book of Shaders
                                                 "time",    "mouse",       "resolution",   "surfaceSize",
                                                 "iTime",   "iResolution", "iMouse"};  // GLSL Sandbox, others
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Buffers of glslViewer and GLSL Sandbox, which are no pictures of the visitor.
bool isBuffer(std::string_view name)
{
    return name == "backbuffer" || name.starts_with("u_buffer") || name.starts_with("u_doubleBuffer");
}

/// Finds the uniforms of a plain shader. They become inputs, or variables that the program fills.
class Uniforms {
public:
    Uniforms(Reading& reading, std::uint32_t file)
        : reading_(reading), file_(file), text_(reading.shader.files[file].text), tokens_(text_)
    {
    }

    void read()
    {
        int depth = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const std::string_view word = tokens_.text(i);
            if (tokens_[i].directive != 0) {
                if (word == "#" && tokens_.text(i + 1) == "define") define(i);
                continue;
            }
            depth += (word == "{") - (word == "}");
            if (depth == 0 && word == "uniform") i = uniform(i);
            if (depth == 0 && word == "const") constant(i);
        }
    }

private:
    /// Reads `uniform TYPE NAME [= VALUE], NAME...;`. Returns the index of its last token.
    std::size_t uniform(std::size_t i)
    {
        std::size_t end = i;
        while (end < tokens_.size() && tokens_.text(end) != ";") ++end;
        std::size_t at = i + 1;
        while (render::isPrecision(tokens_.text(at))) ++at;
        const std::string type(tokens_.text(at));
        bool expectsName = true;
        for (++at; at < end; ++at) {
            if (expectsName && tokens_[at].kind == render::Token::Kind::word) declare(type, at, end);
            expectsName = tokens_.text(at) == ",";
        }
        return std::min(end, tokens_.size());
    }
    void declare(const std::string& type, std::size_t at, std::size_t end)
    {
        const std::string name(tokens_.text(at));
        Shader& shader = reading_.shader;
        const bool known = std::any_of(shader.builtIns.begin(), shader.builtIns.end(),
                                       [&](const BuiltIn& each) { return each.name == name; });
        if (known || shader.inputNamed(name)) return;  // Declared again, in another branch of #ifdef.
        const int line = tokens_[at].line;
        const std::size_t count = componentsOf(type);
        if (count > 0 && (isBuiltIn(name) || (name.ends_with("Resolution") && type == "vec2"))) {
            shader.builtIns.push_back({name, type});
            return;
        }
        Input input;
        input.name = name;
        input.glslType = type;
        const bool isPicture = type == "sampler2D" || type == "samplerCube" || type == "sampler3D";
        if (count == 0 && !isPicture)
            throw refused(
                reading_, file_, line, name,
                message("The uniform “{1}” has the type “{2}”, which no slider can set; use a number, a vector, "
                        "bool or sampler2D.",
                        name, type));
        if (tokens_.text(at + 1) == "[")
            throw refused(
                reading_, file_, line, name,
                message("The uniform “{1}” is an array, which no slider can set; use single uniforms.", name));
        input.type = isPicture         ? InputType::image
                     : count > 1       ? InputType::vector
                     : type == "bool"  ? InputType::toggle
                     : type == "float" ? InputType::real
                                       : InputType::integer;
        if (isPicture) {
            if (isBuffer(name)) input.source = "buffer";
        } else {
            setRange(input, count, end, line);
        }
        addInput(reading_, std::move(input), file_, line);
    }
    void setRange(Input& input, std::size_t count, std::size_t end, int line)
    {
        const std::string_view comment = tokens_.commentBehind(end);
        if (!comment.empty() && readRangeComment(comment, count, input, reading_, file_, line)) return;
        if (comment.starts_with("color") && count >= 3) input.type = InputType::color;
        input.low.assign(count, 0);
        input.high.assign(count, 1);
        input.initial.assign(count, input.type == InputType::color ? 1 : 0);
        if (input.type == InputType::real)
            reading_.note(
                file_, line, input.name,
                message("“{1}” has no range; write one behind it, such as // 0 .. 2, default 1.", input.name));
    }

    /// Reads `#define NAME NUMBER // RANGE`.
    void define(std::size_t i)
    {
        const std::size_t end = tokens_.lineEnd(i);
        const bool negative = tokens_.text(i + 3) == "-";
        const std::size_t number = i + (negative ? 4 : 3);
        if (end == number + 1) sliderOf(tokens_.text(i + 2), "", i + 2, number);
    }
    /// Reads `const TYPE NAME = NUMBER; // RANGE`.
    void constant(std::size_t i)
    {
        const bool negative = tokens_.text(i + 4) == "-";
        const std::size_t number = i + (negative ? 5 : 4);
        if (tokens_.text(i + 3) == "=" && tokens_.text(number + 1) == ";")
            sliderOf(tokens_.text(i + 2), std::string(tokens_.text(i + 1)), i + 2, number + 1);
    }
    /// Makes a number with a range behind it an input. A number without one stays as it is.
    void sliderOf(std::string_view name, std::string type, std::size_t at, std::size_t last)
    {
        const std::string_view comment = tokens_.commentBehind(last);
        if (comment.empty() || tokens_.size() <= last) return;
        const std::string_view digits = tokens_.text(tokens_.text(last) == ";" ? last - 1 : last);
        if (type.empty()) type = digits.find_first_of(".eE") == std::string_view::npos ? "int" : "float";
        if (type != "int" && type != "float") return;
        Input input;
        input.name = name;
        input.glslType = type;
        input.type = type == "int" ? InputType::integer : InputType::real;
        if (const std::optional<double> number = numberBefore(last)) input.initial.assign(1, *number);
        if (readRangeComment(comment, 1, input, reading_, file_, tokens_[at].line))
            addInput(reading_, std::move(input), file_, tokens_[at].line);
    }
    /// Returns the number that ends at a token, or before it if it is a semicolon.
    [[nodiscard]] std::optional<double> numberBefore(std::size_t last) const
    {
        const std::size_t at = tokens_.text(last) == ";" ? last - 1 : last;
        const std::optional<double> number = glslNumber(tokens_.text(at));
        return number && tokens_.text(at - 1) == "-" ? -*number : number;
    }

    Reading& reading_;
    std::uint32_t file_;
    const std::string text_;
    const render::Tokens tokens_;
};

/// Returns the buffers that glslViewer draws before the picture: BUFFER_0, DOUBLE_BUFFER_0, ...
std::vector<Pass> bufferPasses(const Reading& reading, const Code& code)
{
    std::map<std::string, Pass> passes;
    for (const SourceFile& source : reading.shader.files) {
        const render::Tokens tokens(source.text);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const std::string word(tokens.text(i));
            const bool twice = word.starts_with("DOUBLE_BUFFER_");
            if (tokens[i].directive == 0 || (!twice && !word.starts_with("BUFFER_"))) continue;
            const std::string number = word.substr(word.rfind('_') + 1);
            const std::string target = (twice ? "u_doubleBuffer" : "u_buffer") + number;
            passes[word] = {.name = word,
                            .target = target,
                            .isPersistent = twice,
                            .isFloat = true,
                            .code = code,
                            .defines = {word}};
        }
    }
    std::vector<Pass> ordered;
    for (auto& [word, pass] : passes) ordered.push_back(std::move(pass));
    return ordered;
}

}  // namespace

void readPlain(Reading& reading, std::uint32_t file)
{
    Shader& shader = reading.shader;
    shader.form = Form::plain;
    const Code code = withIncludes(reading, file);
    for (std::uint32_t each = file; each < shader.files.size(); ++each) Uniforms(reading, each).read();
    shader.passes = bufferPasses(reading, code);
    if (shader.passes.size() >= Limits::passes)
        throw refused(reading, file, 1, "",
                      message("The shader has more than {1} passes; remove some.", Limits::passes));
    const bool readsItself = shader.inputNamed("backbuffer") != nullptr;
    shader.passes.push_back({.name = "Image", .isPersistent = readsItself, .code = code});
}

}  // namespace vitrine::guest

#include "exhibits/your_shader/reading.h"

#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/files/text_position.h"
#include "render/text/trimmed.h"

#include <algorithm>
#include <cmath>

namespace vitrine::guest {
namespace {

/// Returns the lines `first` to before `last` of a text, with their line ends.
std::string linesOf(std::string_view text, int first, int last)
{
    std::size_t begin = first == 1 ? 0 : text.size(), end = 0;
    for (int line = 1; line < last && end < text.size(); ++line) {
        const std::size_t newline = text.find('\n', end);
        end = newline == std::string_view::npos ? text.size() : newline + 1;
        if (line + 1 == first) begin = end;
    }
    return begin < end ? std::string(text.substr(begin, end - begin)) : "";
}

/// Parts of a comment between commas; a comma in quotes is none.
std::vector<std::string_view> partsOf(std::string_view comment)
{
    std::vector<std::string_view> parts;
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= comment.size(); ++i) {
        if (i < comment.size() && comment[i] == '"') quoted = !quoted;
        if (i < comment.size() && (comment[i] != ',' || quoted)) continue;
        parts.push_back(render::trimmed(comment.substr(begin, i - begin), " \t"));
        begin = i + 1;
    }
    return parts;
}

std::vector<double> numbersIn(std::string_view text)
{
    std::vector<double> numbers;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        const std::optional<double> number = render::parseNumber(text.substr(0, end));
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
        text = render::trimmed(text.substr(end), " \t");
    }
    return numbers;
}

/// Returns one number for each component: the given ones, or one for all; empty if the count is another.
std::vector<double> forEach(std::vector<double> numbers, std::size_t components)
{
    if (numbers.size() == 1) numbers.resize(components, numbers.front());
    if (numbers.size() != components) numbers.clear();
    return numbers;
}

/// Ends of a range, a number for each component.
struct Ends {
    std::vector<double> low, high;
};

/// Reads "0.1 .. 2". Empty ends: the text has another form.
Ends rangeIn(std::string_view text, std::size_t components)
{
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return {};
    return {forEach(numbersIn(render::trimmed(text.substr(0, dots), " \t")), components),
            forEach(numbersIn(render::trimmed(text.substr(dots + 2), " \t")), components)};
}

}  // namespace

std::string unquoted(std::string_view text)
{
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return std::string(text.substr(1, text.size() - 2));
    return std::string(text);
}

std::uint32_t Reading::addFile(const std::string& name, std::string text)
{
    shader.files.push_back({name, std::move(text)});
    return static_cast<std::uint32_t>(shader.files.size() - 1);
}

void Reading::note(std::uint32_t file, int line, std::string_view word, Message sentence)
{
    if (shader.notes.size() >= Limits::findings) return;
    Finding finding = refused(*this, file, line, word, std::move(sentence)).finding();
    finding.isError = false;
    shader.notes.push_back(std::move(finding));
}

Refused refused(const Reading& reading, std::uint32_t file, int line, std::string_view word, Message sentence)
{
    const SourceFile& source = reading.shader.files[file];
    return Refused({.file = source.name,
                    .line = line,
                    .column = render::columnOf(source.text, line, word),
                    .sentence = std::move(sentence)});
}

Code withIncludes(Reading& reading, std::uint32_t file, std::size_t depth)
{
    Code code;
    const std::string text = reading.shader.files[file].text;
    const render::Tokens tokens(text);
    int line = 1;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (tokens[i].directive == 0 || tokens.text(i) != "#" || tokens.text(i + 1) != "include") continue;
        const std::string path = unquoted(tokens.text(i + 2));
        const int here = tokens[i].line;
        if (tokens[i + 2].kind != render::Token::Kind::text || path.empty())
            throw refused(reading, file, here, "include",
                          message("An include names a file in quotes: #include \"name.glsl\"."));
        if (depth >= Limits::includeDepth)
            throw refused(
                reading, file, here, "include",
                message("Files include each other more than {1} deep; remove the circle.", Limits::includeDepth));
        if (++reading.includes > Limits::includes)
            throw refused(reading, file, here, "include",
                          message("The shader includes more than {1} files; join some of them.", Limits::includes));
        code.push_back({file, line, linesOf(text, line, here)});
        std::string included;
        try {
            included = render::withPlainLineEnds(reading.beside(path));
        } catch (const Failure& failure) {
            throw refused(reading, file, here, tokens.text(i + 2), failure.message());
        }
        const Code below = withIncludes(reading, reading.addFile(path, std::move(included)), depth + 1);
        code.insert(code.end(), below.begin(), below.end());
        line = here + 1;
        i = tokens.lineEnd(i) - 1;
    }
    code.push_back({file, line, linesOf(text, line, static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 2)});
    return code;
}

bool readRangeComment(std::string_view comment, std::size_t components, Input& input, const Reading& reading,
                      std::uint32_t file, int line)
{
    const std::vector<std::string_view> parts = partsOf(comment);
    const bool isColor = parts.front() == "color" && components >= 3;
    Ends ends = isColor ? Ends{std::vector<double>(components, 0), std::vector<double>(components, 1)}
                        : rangeIn(parts.front(), components);
    if (ends.low.empty() || ends.high.empty()) return false;
    for (std::size_t i = 0; i < components; ++i)
        if (ends.low[i] >= ends.high[i])
            throw refused(reading, file, line, parts.front(),
                          message("The range of “{1}” is empty; write the lower number first.", input.name));
    if (isColor) input.type = InputType::color;
    std::vector<double> initial = !input.initial.empty() ? input.initial : isColor ? ends.high : ends.low;
    for (const std::string_view part : std::vector(parts.begin() + 1, parts.end())) {
        const std::size_t blank = std::min(part.find(' '), part.size());
        const std::string_view key = part.substr(0, blank);
        std::vector<double> numbers = numbersIn(render::trimmed(part.substr(blank), " \t"));
        if (isColor && components == 4 && numbers.size() == 3) numbers.push_back(1);  // Opaque.
        if (part.size() >= 2 && part.front() == '"' && part.back() == '"')
            input.label = unquoted(part);
        else if (key == "default" && !forEach(numbers, components).empty())
            initial = forEach(numbers, components);
        else if (key == "exact" && numbers.size() == 1 && components == 1)
            input.exact = numbers.front();
        else if (!part.empty() && blank == part.size() && part.size() <= 8)
            input.unit = part;
        else
            throw refused(
                reading, file, line, part,
                message("“{1}” is unknown here; after the range of “{2}” follow default, exact, a unit or a label "
                        "in quotes.",
                        part, input.name));
    }
    for (std::size_t i = 0; i < components; ++i)
        if (initial[i] < ends.low[i] || initial[i] > ends.high[i])
            throw refused(reading, file, line, "default",
                          message("The default of “{1}” is outside of its range; change one of them.", input.name));
    input.low = std::move(ends.low);
    input.high = std::move(ends.high);
    input.initial = std::move(initial);
    return true;
}

void requireName(const Reading& reading, const std::string& name, std::uint32_t file, int line)
{
    constexpr std::size_t longest = 128;
    const render::Tokens tokens(name);
    if (tokens.size() != 1 || tokens[0].kind != render::Token::Kind::word || tokens.text(0) != name ||
        name.size() > longest)
        throw refused(reading, file, line, name,
                      message("“{1}” is no name of a variable; use letters, digits and _.", name));
}

void addInput(Reading& reading, Input input, std::uint32_t file, int line)
{
    Shader& shader = reading.shader;
    requireName(reading, input.name, file, line);
    if (shader.inputNamed(input.name))
        throw refused(reading, file, line, input.name,
                      message("There are two inputs “{1}”; rename one of them.", input.name));
    const auto ofKind = std::count_if(shader.inputs.begin(), shader.inputs.end(),
                                      [&](const Input& other) { return other.type == input.type; });
    if (shader.inputs.size() >= Limits::inputs || static_cast<std::size_t>(ofKind) >= Limits::inputsOfAKind)
        throw refused(reading, file, line, input.name,
                      message("The shader has more than {1} inputs of one kind, or more than {2} in all; remove some.",
                              Limits::inputsOfAKind, Limits::inputs));
    if (input.label.empty()) input.label = input.name;
    shader.inputs.push_back(std::move(input));
}

std::optional<double> glslNumber(std::string_view glsl)
{
    if (glsl.ends_with('f') || glsl.ends_with('F')) glsl.remove_suffix(1);
    if (glsl.ends_with('.')) glsl.remove_suffix(1);
    const std::optional<double> number = render::parseNumber((glsl.starts_with('.') ? "0" : "") + std::string(glsl));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::size_t componentsOf(std::string_view type)
{
    if (type == "float" || type == "int" || type == "bool" || type == "uint") return 1;
    for (const std::string_view vector : {"vec", "ivec", "bvec", "uvec"})
        if (type.size() == vector.size() + 1 && type.starts_with(vector) && type.back() >= '2' && type.back() <= '4')
            return static_cast<std::size_t>(type.back() - '0');
    return 0;
}

}  // namespace vitrine::guest

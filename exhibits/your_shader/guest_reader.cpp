#include "exhibits/your_shader/guest_reader.h"

#include "exhibits/your_shader/reading.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/files/text_position.h"

#include <filesystem>

namespace vitrine::guest {
namespace {

namespace fs = std::filesystem;

/// Returns whether a function of this name is defined.
bool defines(const render::Tokens& tokens, std::string_view name)
{
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view word = tokens.text(i);
        if (tokens[i].directive != 0) continue;
        depth += (word == "{") - (word == "}");
        if (depth == 0 && word == name && tokens.text(i + 1) == "(") return true;
    }
    return false;
}

void refuseWhat(const Reading& reading, const std::string& text)
{
    if (const auto zero = render::zeroByteIn(text))
        throw Refused({reading.shader.files.front().name, zero->line, zero->column,
                       message("Here is a zero byte, which no text has; remove it.")});
    if (text.find_first_not_of(" \t\n") == std::string::npos)
        throw refused(reading, 0, 1, "", message("The file is empty; write a shader into it."));
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw refused(reading, 0, 1, "", message("The file is UTF-16; save it as UTF-8."));
}

/// Reads the text by its form.
void readForm(Reading& reading, const std::string& text, const std::string& name)
{
    refuseWhat(reading, text);
    const char first = text[text.find_first_not_of(" \t\n")];
    const render::Tokens tokens(text);
    if (first == '{' || first == '[') return readShadertoyJson(reading, 0);
    if (isIsf(text)) {
        readIsf(reading, 0);
        const fs::path vertexName = fs::path(name).replace_extension(".vs");
        std::string vertexText;
        try {
            vertexText = render::withPlainLineEnds(reading.beside(vertexName.filename().string()));
        } catch (const Failure& failure) {
            std::error_code error;
            if (!fs::exists(vertexName, error)) return;  // Most shaders have none.
            throw refused(reading, 0, 1, "", failure.message());
        }
        const std::uint32_t file = reading.addFile(vertexName.string(), std::move(vertexText));
        reading.shader.vertexCode = withIncludes(reading, file);
        return;
    }
    if (defines(tokens, "mainImage") && !defines(tokens, "main")) return readShadertoyText(reading, 0);
    if (defines(tokens, "main")) return readPlain(reading, 0);
    throw refused(
        reading, 0, 1, "",
        message("This is not a shader: it has neither main() nor mainImage(), and no JSON in its first comment; "
                "write one of them."));
}

}  // namespace

ReadShader readShader(std::string text, const std::string& name, const FileBeside& beside)
{
    Reading reading{.shader = {}, .beside = beside};
    text = render::withPlainLineEnds(std::move(text));
    reading.addFile(name, text);
    reading.shader.title = fs::path(name).stem().string();
    try {
        if (text.size() > Limits::textBytes)
            throw refused(reading, 0, 1, "",
                          message("The file has more than {1} bytes; shorten it.", Limits::textBytes));
        readForm(reading, text, name);
        refuseMacroBombs(reading);
    } catch (const Refused& refusal) {
        return {.shader = nullptr, .errors = {refusal.finding()}};
    }
    return {.shader = std::make_shared<const Shader>(std::move(reading.shader)), .errors = {}};
}

ReadShader readShaderFile(const fs::path& path)
{
    std::string text;
    try {
        text = render::readFile(path, Limits::textBytes);
    } catch (const Failure& failure) {
        return {
            .shader = nullptr, .errors = {{.file = path.string(), .sentence = failure.message()}}, .fileRead = false};
    }
    return readShaderText(std::move(text), path);
}

ReadShader readShaderText(std::string text, const fs::path& path)
{
    const FileBeside beside = [&](const std::string& reference) {
        return render::readFileBeneath(path.parent_path().empty() ? "." : path.parent_path(), reference,
                                       Limits::textBytes);
    };
    return readShader(std::move(text), path.string(), beside);
}

}  // namespace vitrine::guest

#include "render/glsl/shader_source.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/glsl/embedded.h"

#include <algorithm>
#include <charconv>
#include <regex>
#include <set>
#include <sstream>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

/// Mesa (22.3) reports errors inside an expression with source number 0, whatever `#line` said (its YYLLOC_DEFAULT
/// drops the source). So the line number encodes the file, too: line n of file i is i * linesPerFile + n.
constexpr int linesPerFile = 100000;

constexpr std::uint64_t mostBytes = 1U << 20U;  // of one file

/// Replaces includes depth-first, each file once. Writes `#line` directives, so that messages name the right file and
/// line.
class Resolver {
public:
    Resolver(const ShaderSource& source, const ShaderSources* generated) : source_(source), generated_(generated) {}

    void append(const std::string& file, const std::string& from, int depth)
    {
        if (!seen_.insert(file).second) return;
        if (depth > 16)
            throw Failure(ErrorKind::shader,
                          "shaders/" + file + ": #include is nested deeper than 16 files; break the circle.");
        const std::optional<std::string> text = read(file);
        if (!text)
            throw Failure(ErrorKind::shader, "shaders/" + file + " is missing" +
                                                 (from.empty() ? "" : ", included from shaders/" + from) +
                                                 "; restore it or correct the path.");
        const std::size_t index = result_.files.size();
        result_.files.push_back(file);
        line(1, index);
        std::istringstream lines(*text);
        int number = 0;
        for (std::string current; std::getline(lines, current);) {
            ++number;
            if (const std::optional<std::string> included = includedFile(current)) {
                append(*included, file, depth + 1);
                line(number + 1, index);
            } else {
                result_.text += current + '\n';
            }
        }
    }

    ShaderText take() { return std::move(result_); }
    std::string& text() { return result_.text; }

private:
    [[nodiscard]] std::optional<std::string> read(const std::string& file) const
    {
        if (generated_)
            if (const auto found = generated_->textByPath().find(file); found != generated_->textByPath().end())
                return found->second;
        return source_.read(file);
    }

    static std::optional<std::string> includedFile(const std::string& line)
    {
        const std::size_t hash = line.find_first_not_of(" \t");
        if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) return std::nullopt;
        const std::size_t open = line.find('"', hash);
        const std::size_t close = open == std::string::npos ? open : line.find('"', open + 1);
        if (close == std::string::npos) return std::nullopt;
        return line.substr(open + 1, close - open - 1);
    }

    void line(int number, std::size_t index)
    {
        result_.text += "#line " + std::to_string(static_cast<int>(index) * linesPerFile + number) + ' ' +
                        std::to_string(index) + '\n';
    }

    const ShaderSource& source_;
    const ShaderSources* generated_;
    ShaderText result_;
    std::set<std::string> seen_;
};

}  // namespace

ShaderSource::ShaderSource()
{
#ifdef VITRINE_SHADER_DIR
    if (std::error_code error; fs::is_directory(VITRINE_SHADER_DIR, error)) folder_ = VITRINE_SHADER_DIR;
#endif
}

ShaderSource::ShaderSource(fs::path folder) : folder_(std::move(folder)) {}

std::optional<std::string> ShaderSource::read(std::string_view file) const
{
    if (!folder_) {
        const auto all = embeddedShaders();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const EmbeddedShader& s) { return s.file == file; });
        if (found == all.end()) return std::nullopt;
        return std::string(found->text);
    }
    std::error_code error;
    if (!whyRefused(file).empty() || fs::path(file).lexically_normal() != file ||
        !fs::is_regular_file(*folder_ / file, error))
        return std::nullopt;
    return readFileBeneath(*folder_, file, mostBytes);
}

ShaderText ShaderSource::load(std::string_view file, const std::vector<std::string>& defines, std::string_view prelude,
                              const ShaderSources* generated) const
{
    Resolver resolver(*this, generated);
    resolver.text() = "#version 450 core\n";
    for (const std::string& define : defines) resolver.text() += "#define " + define + '\n';
    resolver.text() += prelude;
    resolver.append(std::string(file), "", 0);
    return resolver.take();
}

std::vector<std::string> ShaderSource::list() const
{
    std::vector<std::string> files;
    if (!folder_) {
        for (const EmbeddedShader& shader : embeddedShaders()) files.emplace_back(shader.file);
        return files;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(*folder_))
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), *folder_).generic_string());
    std::sort(files.begin(), files.end());
    return files;
}

ShaderMessage firstError(std::string_view log, const std::vector<std::string>& files)
{
    static const std::regex mesa(R"((\d+):(\d+)(?:\(\d+\))?: (error: .*))");
    static const std::regex nvidia(R"((\d+)\((\d+)\) : (error .*))");
    static const std::regex intel(R"(ERROR: (\d+):(\d+): (.*))");
    std::istringstream lines{std::string(log)};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (first.empty()) first = line;
        std::smatch match;
        if (!std::regex_search(line, match, intel) && !std::regex_search(line, match, mesa) &&
            !std::regex_search(line, match, nvidia))
            continue;
        const int number = std::stoi(match[2]);
        const auto index = number >= linesPerFile ? static_cast<std::size_t>(number / linesPerFile)
                                                  : static_cast<std::size_t>(std::stoul(match[1]));
        return {index < files.size() ? files[index] : std::string(), number % linesPerFile, match[3]};
    }
    return {files.empty() ? std::string() : files.front(), 0, first};
}

}  // namespace vitrine::render

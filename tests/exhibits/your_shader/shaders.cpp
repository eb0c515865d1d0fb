#include "tests/exhibits/your_shader/shaders.h"

#include "render/failure.h"

namespace vitrine::test {

guest::CheckedShader checked(const std::string& text, const Beside& beside)
{
    static guest::ShaderCompiler compiler;
    const guest::FileBeside find = [&](const std::string& path) {
        const auto found = beside.find(path);
        if (found == beside.end()) throw Failure(ErrorKind::file, message("There is no file {1}.", path));
        return found->second;
    };
    return guest::translate(guest::readShader(text, "own.fs", find), compiler);
}

std::string errorsOf(const guest::CheckedShader& shader)
{
    std::string all;
    for (const guest::Finding& finding : shader.errors)
        all += finding.file + ':' + std::to_string(finding.line) + ':' + std::to_string(finding.column) + ": " +
               finding.sentence.english() + '\n';
    return all;
}

std::string isf(const std::string& head, const std::string& body)
{
    return "/*{" + head + "}*/\nvoid main() {\n" + body + "\n}\n";
}

}  // namespace vitrine::test

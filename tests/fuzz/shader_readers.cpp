#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/guest_reader.h"
#include "render/failure.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/readers.h"

#include <string>

namespace vitrine::fuzz {

bool readShader(std::string_view bytes)
{
    const auto noFile = [](const std::string& path) -> std::string {
        throw Failure(ErrorKind::file, "There is no file " + path + ".");
    };
    const guest::ReadShader read = guest::readShader(std::string(bytes), "fuzz.fs", noFile);
    require(read.shader != nullptr || !read.errors.empty(), "a refusal says why");
    for (const guest::Finding& finding : read.errors)
        require(finding.line >= 1 && finding.column >= 1 && !finding.sentence.empty(), "a finding has its place");
    // Damaged text is passed although the loop guard only reads output of SPIRV-Cross: it must not crash.
    static_cast<void>(guest::withLoopGuard(std::string(bytes)));
    if (!read.shader) return false;
    static_cast<void>(guest::findingsOf(*read.shader, bytes));
    require(!read.shader->passes.empty(), "a shader has passes");
    for (const guest::Input& input : read.shader->inputs) {
        require(input.low.size() == input.high.size(), "a range has two ends");
        for (std::size_t i = 0; i < input.low.size(); ++i)
            require(input.low[i] <= input.initial[i] && input.initial[i] <= input.high[i],
                    "values are in their ranges");
    }
    for (const guest::Pass& pass : read.shader->passes) {
        const guest::PassText text = guest::passText(*read.shader, pass);
        require(text.fragment.find('\0') == std::string::npos, "a text has no zero byte");
        require(text.fragment.starts_with("#version 450"), "a text has its version");
    }
    return true;
}

}  // namespace vitrine::fuzz

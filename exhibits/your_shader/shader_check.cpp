#include "exhibits/your_shader/shader_check.h"

#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/guest_work.h"
#include "render/failure.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <map>

namespace vitrine::guest {
namespace {

/// Returns the reason why a program is too large; empty if it is not.
Message tooLarge(const ProgramCounts& counts)
{
    if (counts.recursive) return message("A function calls itself, which GLSL does not have; use a loop.");
    if (counts.instructions > ProgramLimits::instructions)
        return message(
            "The shader has {1} instructions when every call is replaced by its function, more than the {2} that "
            "drivers can take; let functions call each other less often.",
            counts.instructions, ProgramLimits::instructions);
    if (counts.localBytes > ProgramLimits::localBytes)
        return message(
            "The variables of the shader need {1} bytes for each pixel, more than {2}; make the arrays smaller.",
            counts.localBytes, ProgramLimits::localBytes);
    if (counts.samplers > ProgramLimits::samplers)
        return message("A pass reads {1} pictures, more than the {2} that OpenGL has; use fewer.", counts.samplers,
                       ProgramLimits::samplers);
    return {};
}

/// Translates the passes of one shader. Passes with the same text share their program.
class Translation {
public:
    Translation(CheckedShader& checked, ShaderCompiler& compiler, bool forWeb = false)
        : checked_(checked), compiler_(compiler), forWeb_(forWeb)
    {
    }

    void run()
    {
        for (const Pass& pass : checked_.shader->passes) {
            const PassText text = passText(*checked_.shader, pass);
            const auto known = done_.find(text.fragment);
            const bool good = known != done_.end() || translate(text, pass);
            if (!good) return checked_.programs.clear();
            checked_.programs.push_back(known != done_.end() ? known->second : done_[text.fragment]);
        }
    }

private:
    /// Places an error at the beginning of the pass's own code.
    bool fail(const Pass& pass, Message sentence)
    {
        const SourceFile& file = checked_.shader->files[pass.code.empty() ? 0 : pass.code.back().file];
        checked_.errors.push_back({.file = file.name, .sentence = std::move(sentence)});
        return false;
    }
    bool translate(const PassText& text, const Pass& pass)
    {
        ShaderCompiler::Result result = compiler_.compile({text.vertex, text.fragment, forWeb_});
        if (!result.problem.empty()) return fail(pass, std::move(result.problem));
        processorSeconds_ += result.processorSeconds;
        if (processorSeconds_ > compiler_.limits().secondsOfAllPasses)
            return fail(pass,
                        message("The shader could not be read: the GLSL compiler needs more than {1} s of processor "
                                "time for its passes together; make them shorter.",
                                render::shortNumber(compiler_.limits().secondsOfAllPasses)));
        CompilerAnswer& answer = result.answer;
        if (!answer.log.empty()) {
            checked_.errors = findingsOf(*checked_.shader, answer.log);
            if (checked_.errors.empty()) fail(pass, message("The GLSL compiler says: {1}.", answer.log.substr(0, 200)));
            return false;
        }
        if (Message why = tooLarge(answer.counts); !why.empty()) return fail(pass, std::move(why));
        if (!answer.problem.empty() && forWeb_)
            return fail(pass, message("WebGL 2 has no program like this: {1}", answer.problem.substr(0, 200)));
        if (!answer.problem.empty())
            return fail(pass, message("The shader cannot be translated: {1}; make it simpler.", answer.problem));
        PassProgram program{withLoopGuard(answer.vertex), withLoopGuard(answer.fragment), answer.counts};
        if (program.vertex.empty() || program.fragment.empty())
            return fail(pass, message("A loop has a form that cannot be bounded; write it as a plain for loop."));
        done_[text.fragment] = std::move(program);
        return true;
    }

    CheckedShader& checked_;
    ShaderCompiler& compiler_;
    const bool forWeb_;
    double processorSeconds_ = 0;
    std::map<std::string, PassProgram> done_;
};

}  // namespace

CheckedShader translate(ReadShader read, ShaderCompiler& compiler)
{
    CheckedShader checked{
        .shader = std::move(read.shader), .errors = std::move(read.errors), .fileRead = read.fileRead};
    if (checked.shader) Translation(checked, compiler).run();
    return checked;
}

WebPrograms translateForWeb(std::shared_ptr<const Shader> shader, ShaderCompiler& compiler)
{
    CheckedShader checked{.shader = std::move(shader), .programs = {}, .errors = {}};
    Translation(checked, compiler, true).run();
    return {std::move(checked.programs), std::move(checked.errors)};
}

CheckedShader checkShaderFile(const std::filesystem::path& path, ShaderCompiler& compiler)
{
    CheckedShader checked = translate(readShaderFile(path), compiler);
    if (checked.isGood()) static_cast<void>(makeWork(checked, path, checked.errors));
    return checked;
}

}  // namespace vitrine::guest

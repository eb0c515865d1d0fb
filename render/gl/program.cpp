#include "render/gl/program.h"

#include "render/failure.h"
#include "render/gl/context.h"
#include "render/gl/program_binaries.h"
#include "render/glsl/block_copies.h"
#include "render/measure/clock.h"

#include <algorithm>
#include <iterator>

namespace vitrine::render::gl {
namespace {

std::string infoLog(GLuint name, bool program)
{
    GLint length = 0;
    program ? glGetProgramiv(name, GL_INFO_LOG_LENGTH, &length) : glGetShaderiv(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    program ? glGetProgramInfoLog(name, length, &written, log.data())
            : glGetShaderInfoLog(name, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

}  // namespace

std::string describe(const ShaderKey& key)
{
    std::string text = !key.compute.empty() ? key.compute : key.fragment.empty() ? key.vertex : key.fragment;
    if (key.defines.empty()) return text;
    text += " [";
    for (const std::string& define : key.defines) text += (text.back() == '[' ? "" : ", ") + define;
    return text + ']';
}

bool buildsInParallel()
{
    return epoxy_has_gl_extension("GL_KHR_parallel_shader_compile");
}

void allowBuildThreads()
{
    if (buildsInParallel()) glMaxShaderCompilerThreadsKHR(0xFFFFFFFF);
}

PendingProgram::PendingProgram(const ShaderSource& source, const ShaderKey& key)
{
    const double start = wallSeconds();
    hand(source, key);
    built_.seconds = wallSeconds() - start;
}

void PendingProgram::hand(const ShaderSource& source, const ShaderKey& key)
{
    std::vector<std::pair<GLenum, ShaderText>> texts;
    try {
        // llvmpipe ends all loops of an invocation after that many iterations; software renderers are taken for it.
        const bool software = currentContextInfo().software;
        const std::string prelude = (software ? "#define LOOP_LIMIT 65535\n" : "") + key.prelude;
        const auto add = [&](GLenum type, const std::string& file) {
            if (!file.empty()) texts.emplace_back(type, source.load(file, key.defines, prelude, key.sources.get()));
        };
        add(GL_VERTEX_SHADER, key.vertex);
        add(GL_FRAGMENT_SHADER, key.fragment);
        add(GL_COMPUTE_SHADER, key.compute);
        const bool copies =
            std::any_of(texts.begin(), texts.end(), [](const auto& t) { return asksForCopies(t.second.text); });
        if (software && copies)
            for (auto& [type, text] : texts) text.text = copyingBlocks(text.text);
    } catch (const Failure& failure) {
        built_.problem = {describe(key), 0, failure.what()};
        return;
    }
    for (const auto& [type, text] : texts) {
        everything_ += text.text;
        std::copy(text.files.begin(), text.files.end(), std::back_inserter(built_.files));
    }
    ProgramName program(glCreateProgram());
    glObjectLabel(GL_PROGRAM, program.name(), -1, describe(key).substr(0, 200).c_str());
    if (loadProgramBinary(program.name(), everything_)) {
        built_.program = std::move(program);
        built_.fromCache = true;
        return;
    }
    for (auto& [type, text] : texts) {
        Stage stage{ShaderName(glCreateShader(type)), std::move(text)};
        const char* characters = stage.source.text.c_str();
        glShaderSource(stage.shader.name(), 1, &characters, nullptr);
        glCompileShader(stage.shader.name());
        glAttachShader(program.name(), stage.shader.name());
        stages_.push_back(std::move(stage));
    }
    glProgramParameteri(program.name(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    glLinkProgram(program.name());
    program_ = std::move(program);
}

bool PendingProgram::done() const
{
    if (!program_) return true;
    GLint complete = GL_TRUE;
    if (buildsInParallel()) glGetProgramiv(program_.name(), GL_COMPLETION_STATUS_KHR, &complete);
    return complete == GL_TRUE;
}

BuiltProgram PendingProgram::take()
{
    const double start = wallSeconds();
    if (program_) finish();
    built_.seconds += wallSeconds() - start;
    return std::move(built_);
}

void PendingProgram::finish()
{
    for (const Stage& stage : stages_) {
        GLint good = GL_FALSE;
        glGetShaderiv(stage.shader.name(), GL_COMPILE_STATUS, &good);
        if (good == GL_TRUE) continue;
        built_.problem = firstError(infoLog(stage.shader.name(), false), stage.source.files);
        return;
    }
    GLint good = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &good);
    if (good != GL_TRUE) {
        built_.problem = firstError(infoLog(program_.name(), true), stages_.back().source.files);
        return;
    }
    for (const Stage& stage : stages_) glDetachShader(program_.name(), stage.shader.name());
    saveProgramBinary(program_.name(), everything_);
    built_.program = std::move(program_);
}

void PendingProgram::abandon()
{
    program_.abandon();
    built_.program.abandon();
    for (Stage& stage : stages_) stage.shader.abandon();
}

BuiltProgram buildProgram(const ShaderSource& source, const ShaderKey& key)
{
    return PendingProgram(source, key).take();
}

}  // namespace vitrine::render::gl

#include "render/gl/program.h"

#include "render/failure.h"
#include "render/gl/program_binaries.h"

#include <algorithm>
#include <iterator>

namespace vitrine::render::gl {
namespace {

struct Stage {
    GLenum type;
    ShaderText source;
};

std::string infoLog(GLuint name, bool program)
{
    GLint length = 0;
    program ? glGetProgramiv(name, GL_INFO_LOG_LENGTH, &length) : glGetShaderiv(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    program ? glGetProgramInfoLog(name, length, &written, log.data()) : glGetShaderInfoLog(name, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

ShaderName compile(const Stage& stage, ShaderMessage& problem)
{
    ShaderName shader(glCreateShader(stage.type));
    const char* text = stage.source.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint good = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    problem = firstError(infoLog(shader.name(), false), stage.source.files);
    return {};
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

BuiltProgram buildProgram(const ShaderSource& source, const ShaderKey& key)
{
    BuiltProgram built;
    std::vector<Stage> stages;
    try {
        const auto add = [&](GLenum type, const std::string& file) {
            if (!file.empty()) stages.push_back({type, source.load(file, key.defines, key.prelude)});
        };
        add(GL_VERTEX_SHADER, key.vertex);
        add(GL_FRAGMENT_SHADER, key.fragment);
        add(GL_COMPUTE_SHADER, key.compute);
    } catch (const Failure& failure) {
        built.problem = {describe(key), 0, failure.what()};
        return built;
    }
    std::string everything;
    for (const Stage& stage : stages) {
        everything += stage.source.text;
        std::copy(stage.source.files.begin(), stage.source.files.end(), std::back_inserter(built.files));
    }

    ProgramName program(glCreateProgram());
    glObjectLabel(GL_PROGRAM, program.name(), -1, describe(key).substr(0, 200).c_str());
    if (loadProgramBinary(program.name(), everything)) {
        built.program = std::move(program);
        built.fromCache = true;
        return built;
    }
    std::vector<ShaderName> shaders;
    for (const Stage& stage : stages) {
        ShaderName shader = compile(stage, built.problem);
        if (!shader) return built;
        glAttachShader(program.name(), shader.name());
        shaders.push_back(std::move(shader));
    }
    glProgramParameteri(program.name(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    glLinkProgram(program.name());
    GLint good = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good != GL_TRUE) {
        built.problem = firstError(infoLog(program.name(), true), stages.back().source.files);
        return built;
    }
    for (const ShaderName& shader : shaders) glDetachShader(program.name(), shader.name());
    saveProgramBinary(program.name(), everything);
    built.program = std::move(program);
    return built;
}

}  // namespace vitrine::render::gl

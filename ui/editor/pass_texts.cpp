#include "ui/editor/pass_texts.h"

#include "render/failure.h"
#include "render/glsl/shader_source.h"
#include "render/plan/frame_plan.h"

#include <set>
#include <sstream>
#include <utility>

namespace vitrine::ui {
namespace {

/// Returns the text with a comment in place of each `#line`, which is made for compilers.
std::string withFileNames(const render::ShaderText& shader)
{
    std::istringstream lines(shader.text);
    std::string text;
    std::set<std::size_t> begun;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("#line ")) {
            text += line + '\n';
            continue;
        }
        std::istringstream numbers(line.substr(6));
        std::size_t number = 0, file = 0;
        if (!(numbers >> number >> file) || file >= shader.files.size()) continue;
        text += "// " + shader.files[file] + (begun.insert(file).second ? "\n" : ", continued\n");
    }
    return text;
}

}  // namespace

std::vector<PassText> passTexts(const Museum& museum, const SceneState& state, const FrameRequest& request,
                                std::size_t subject)
{
    const std::string prefix = std::string(museum.subject(subject).name()) + '/';
    const render::FramePlan plan = museum.plan(museum.prepare(state, request), request);
    static const render::ShaderSource source;
    std::vector<PassText> texts;
    std::set<std::string> known;
    for (const render::Pass& pass : plan.passes()) {
        if (!pass.name.starts_with(prefix)) continue;
        const render::ShaderKey& key = pass.shader;
        for (const auto& [stage, file] : {std::pair("fragment", key.fragment), std::pair("compute", key.compute),
                                          std::pair("vertex", key.vertex)}) {
            if (file.empty()) continue;
            std::string text;
            try {
                text = withFileNames(source.load(file, key.defines, key.prelude, key.sources.get()));
            } catch (const Failure& failure) {
                text = "// " + failure.message().english() + '\n';
            }
            if (known.insert(text).second) texts.push_back({pass.name.substr(prefix.size()), stage, std::move(text)});
        }
    }
    return texts;
}

}  // namespace vitrine::ui

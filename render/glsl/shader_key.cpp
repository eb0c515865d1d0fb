#include "render/glsl/shader_key.h"

#include "render/hash.h"

#include <tuple>
#include <utility>

namespace vitrine::render {

ShaderSources::ShaderSources(std::map<std::string, std::string> textByPath) : textByPath_(std::move(textByPath))
{
    Hash hash;
    for (const auto& [path, text] : textByPath_) hash.add(path).addValue(path.size()).add(text).addValue(text.size());
    hash_ = hash.value();
}

bool ShaderKey::operator==(const ShaderKey& other) const
{
    if (std::tie(vertex, fragment, compute, defines, prelude) !=
        std::tie(other.vertex, other.fragment, other.compute, other.defines, other.prelude))
        return false;
    if (sources == other.sources) return true;
    return sources && other.sources && sources->textByPath() == other.sources->textByPath();
}

}  // namespace vitrine::render

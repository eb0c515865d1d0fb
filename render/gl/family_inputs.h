#pragma once

#include "render/plan/frame_plan.h"

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vitrine::render::gl {

/// Inputs that fit only one set of generated sources: the blocks that these declare, the textures that they sample, and
/// the constant buffers that they read.
struct FamilyInputs {
    std::uint64_t sources = 0;
    std::map<int, Bytes> blocks;
    std::vector<Bytes> objects;  ///< One for each draw.
    std::vector<SampledTexture> textures;
    std::vector<BufferUse> buffers;

    FamilyInputs() = default;
    explicit FamilyInputs(const Pass& pass) : sources(pass.shader.sources->hash()), blocks(pass.blocks)
    {
        for (const Draw& draw : pass.draws) objects.push_back(draw.object);
        for (const SampledTexture& input : pass.inputs)
            if (!std::holds_alternative<std::string>(input.source)) textures.push_back(input);
        for (const BufferUse& use : pass.buffers)
            if (!std::holds_alternative<std::string>(use.source)) buffers.push_back(use);
    }
};

/// Inputs of the last draw with the last good program of each family.
class LastInputs {
public:
    /// Returns the inputs if they were made for other sources than the pass's. Null if the pass has no family, or if
    /// the sources are the same.
    [[nodiscard]] const FamilyInputs* ofOthers(const Pass& pass) const
    {
        if (pass.shader.programFamily.empty() || !pass.shader.sources) return nullptr;
        const auto found = byFamily_.find(pass.shader.programFamily);
        const bool other = found != byFamily_.end() && found->second.sources != pass.shader.sources->hash() &&
                           found->second.objects.size() == pass.draws.size();
        return other ? &found->second : nullptr;
    }
    /// Stores the inputs of a pass that was drawn with its own program.
    void keep(const Pass& pass)
    {
        if (!pass.shader.programFamily.empty() && pass.shader.sources)
            byFamily_[pass.shader.programFamily] = FamilyInputs(pass);
    }

private:
    std::map<std::string, FamilyInputs> byFamily_;
};

}  // namespace vitrine::render::gl

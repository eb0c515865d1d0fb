#pragma once

#include "render/plan/frame_plan.h"

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vitrine::render::gl {

/// What belongs to a program of generated sources, and is of no use to one of others: the blocks that they declare, the
/// pictures that they sample, and the constant buffers that they read.
struct SlotInputs {
    std::uint64_t sources = 0;
    std::map<int, Bytes> blocks;
    std::vector<Bytes> objects;  ///< By draw.
    std::vector<SampledTexture> textures;
    std::vector<BufferUse> buffers;

    SlotInputs() = default;
    explicit SlotInputs(const Pass& pass) : sources(pass.shader.sources->hash()), blocks(pass.blocks)
    {
        for (const Draw& draw : pass.draws) objects.push_back(draw.object);
        for (const SampledTexture& input : pass.inputs)
            if (!std::holds_alternative<std::string>(input.source)) textures.push_back(input);
        for (const BufferUse& use : pass.buffers)
            if (!std::holds_alternative<std::string>(use.source)) buffers.push_back(use);
    }
};

/// The inputs with which the last good program of each slot was drawn.
class LastInputs {
public:
    /// Null where the pass has no slot, or its own inputs are for the same sources.
    [[nodiscard]] const SlotInputs* ofOthers(const Pass& pass) const
    {
        if (pass.shader.slot.empty() || !pass.shader.sources) return nullptr;
        const auto found = bySlot_.find(pass.shader.slot);
        const bool other = found != bySlot_.end() && found->second.sources != pass.shader.sources->hash() &&
                           found->second.objects.size() == pass.draws.size();
        return other ? &found->second : nullptr;
    }
    /// It was drawn with its own program.
    void keep(const Pass& pass)
    {
        if (!pass.shader.slot.empty() && pass.shader.sources) bySlot_[pass.shader.slot] = SlotInputs(pass);
    }

private:
    std::map<std::string, SlotInputs> bySlot_;
};

}  // namespace vitrine::render::gl

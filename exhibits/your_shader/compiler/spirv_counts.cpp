#include "exhibits/your_shader/compiler/spirv_counts.h"

#include <spirv.hpp>

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <vector>

namespace vitrine::guest {
namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();

/// Numbers beyond 32 bits do not grow further.
std::uint64_t bounded(std::uint64_t number)
{
    return std::min(number, most);
}

/// A module read once from the front: SPIR-V declares everything but functions before its use.
class Module {
public:
    void read(std::span<const std::uint32_t> words)
    {
        constexpr std::size_t head = 5;
        for (std::size_t at = head; at < words.size();) {
            const std::size_t length = words[at] >> 16U;
            if (length == 0 || length > words.size() - at) return;
            instruction(static_cast<spv::Op>(words[at] & 0xffffU), words.subspan(at, length));
            at += length;
        }
    }

    [[nodiscard]] ProgramCounts counts()
    {
        counts_.instructions = expanded(entry_);
        return counts_;
    }

private:
    struct Function {
        std::uint64_t instructions = 0;
        std::vector<std::uint32_t> called{};
        std::uint64_t expanded = 0;
        enum class State : std::uint8_t { fresh, open, done } state = State::fresh;
    };
    struct Type {
        std::uint64_t bytes = 0;
        std::uint64_t samplers = 0;
    };

    void instruction(spv::Op op, std::span<const std::uint32_t> w)
    {
        if (function_) ++function_->instructions;
        const auto at = [&](std::size_t i) { return i < w.size() ? w[i] : 0U; };
        switch (op) {
        case spv::OpEntryPoint: entry_ = at(2); break;
        case spv::OpTypeBool: types_[at(1)] = {4, 0}; break;
        case spv::OpTypeInt:
        case spv::OpTypeFloat: types_[at(1)] = {at(2) / 8, 0}; break;
        case spv::OpTypeVector:
        case spv::OpTypeMatrix: types_[at(1)] = {bounded(types_[at(2)].bytes * at(3)), 0}; break;
        case spv::OpTypeSampledImage: types_[at(1)] = {0, 1}; break;
        case spv::OpConstant: constants_[at(2)] = at(3); break;
        case spv::OpTypeArray: array(at(1), types_[at(2)], constants_[at(3)]); break;
        case spv::OpTypeStruct: structure(w); break;
        case spv::OpTypePointer: types_[at(1)] = types_[at(3)]; break;
        case spv::OpVariable: variable(types_[at(1)], static_cast<spv::StorageClass>(at(3))); break;
        case spv::OpFunction: function_ = &functions_[at(2)]; break;
        case spv::OpFunctionCall:
            if (function_) function_->called.push_back(at(3));
            break;
        case spv::OpFunctionEnd: function_ = nullptr; break;
        default: break;
        }
    }
    void array(std::uint32_t id, const Type& element, std::uint64_t length)
    {
        types_[id] = {bounded(element.bytes * length), bounded(element.samplers * length)};
    }
    void structure(std::span<const std::uint32_t> w)
    {
        Type sum;
        for (const std::uint32_t member : w.subspan(std::min<std::size_t>(2, w.size()))) {
            sum.bytes = bounded(sum.bytes + types_[member].bytes);
            sum.samplers = bounded(sum.samplers + types_[member].samplers);
        }
        types_[w.size() > 1 ? w[1] : 0] = sum;
    }
    void variable(const Type& type, spv::StorageClass storage)
    {
        if (storage == spv::StorageClassFunction || storage == spv::StorageClassPrivate)
            counts_.localBytes = bounded(counts_.localBytes + type.bytes);
        if (storage == spv::StorageClassUniformConstant) counts_.samplers = bounded(counts_.samplers + type.samplers);
    }

    /// Returns the size of a function with its calls expanded. Not recursive: a chain of calls may be long.
    std::uint64_t expanded(std::uint32_t entry)
    {
        std::vector<std::uint32_t> open{entry};
        while (!open.empty()) {
            Function& function = functions_[open.back()];
            if (function.state == Function::State::fresh) {
                function.state = Function::State::open;
                for (const std::uint32_t id : function.called) {
                    const Function& below = functions_[id];
                    counts_.recursive = counts_.recursive || below.state == Function::State::open;
                    if (below.state == Function::State::fresh) open.push_back(id);
                }
                continue;
            }
            open.pop_back();
            if (function.state == Function::State::done) continue;
            function.state = Function::State::done;
            function.expanded = function.instructions;
            for (const std::uint32_t id : function.called)
                function.expanded = bounded(function.expanded + functions_[id].expanded);
        }
        return functions_[entry].expanded;
    }

    std::unordered_map<std::uint32_t, Type> types_;
    std::unordered_map<std::uint32_t, std::uint64_t> constants_;
    std::unordered_map<std::uint32_t, Function> functions_;
    Function* function_ = nullptr;
    std::uint32_t entry_ = 0;
    ProgramCounts counts_;
};

}  // namespace

ProgramCounts spirvCounts(std::span<const std::uint32_t> words)
{
    Module module;
    module.read(words);
    return module.counts();
}

}  // namespace vitrine::guest

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::render {

/// GLSL made at run time: text by the path under which `#include` finds it, before it looks for a file of that path.
/// Immutable, so that plans and programs share it.
class ShaderSources {
public:
    explicit ShaderSources(std::map<std::string, std::string> textByPath);

    [[nodiscard]] const std::map<std::string, std::string>& textByPath() const { return textByPath_; }
    [[nodiscard]] std::uint64_t hash() const { return hash_; }

private:
    std::map<std::string, std::string> textByPath_;
    std::uint64_t hash_ = 0;
};

/// Shader files under shaders/ and the permutation to build: {"SHADOW_METHOD 2", "GLASS"}.
struct ShaderKey {
    std::string vertex = {};
    std::string fragment = {};
    std::string compute = {};
    std::vector<std::string> defines = {};
    std::string prelude = {};  ///< GLSL before the files: the parameter block derived from a table.
    std::shared_ptr<const ShaderSources> sources = {};
    /// Programs that take each other's place, by a name of their own: while a new one is built in the background, or
    /// when it does not build, the last good one of the slot is drawn, and where that was made of other `sources`,
    /// with the blocks, pictures and constant buffers that it was last drawn with. Empty: the frame waits, and fails
    /// with the program.
    std::string slot = {};
    /// Drawn meanwhile in place of the last good one of the slot: a slower program that takes the same inputs.
    std::shared_ptr<const ShaderKey> meanwhile = {};
    /// A faster program that takes the same inputs and draws the same picture, for a look that rests: built in the
    /// background once this one is there, and drawn with from then on. A key without it gives up one of its slot that
    /// is still being built. Pictures that wait for programs do without. Its `slot` is not looked at.
    std::shared_ptr<const ShaderKey> better = {};
    std::string about = {};  ///< Of a better program: what it is, for the ledger.

    /// Whether they build the same program.
    bool operator==(const ShaderKey&) const;
};

}  // namespace vitrine::render

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::render {

/// GLSL generated at run time, by the path in `#include`. It takes precedence over a file of the same path. Immutable,
/// so that plans and programs share it.
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
    std::string prelude = {};  ///< GLSL placed before the files: the parameter block generated from a table.
    std::shared_ptr<const ShaderSources> sources = {};
    /// Name of a family of programs that can replace each other. While a new program is built in the background, or
    /// if it fails to build, the last good program of the family is used. If that was built from other `sources`, it is
    /// used with the blocks, textures and constant buffers of its last draw. Empty: the frame waits for the program,
    /// and fails if it does not build.
    std::string programFamily = {};
    /// Fallback program: slower, with the same inputs. Used instead of the family's last good program while this
    /// program is being built, or if it fails to build.
    std::shared_ptr<const ShaderKey> meanwhile = {};
    /// Specialized program: faster, with the same inputs and the same picture. It is built in the background once this
    /// program exists, and used from then on. A later key of the family without it cancels a build in progress. Frames
    /// that wait for programs do not use it. Its `programFamily` is ignored.
    std::shared_ptr<const ShaderKey> specialized = {};
    std::string about = {};  ///< Description of a `specialized` program, for the frame report.

    /// Returns whether both keys build the same program.
    bool operator==(const ShaderKey&) const;
};

}  // namespace vitrine::render

#pragma once

#include "render/scene/gltf.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::render {

/// A glTF file with its animations, skins and morph targets; it can be posed at any time. Immutable and thread-safe.
class AnimatedModel {
public:
    struct Animation {
        std::string name;     ///< Name in the file, or "animation 0".
        double duration = 0;  ///< Time of the last key, in seconds.
    };

    /// Loads a file. Throws Failure as `loadGltf` does, also if an animation or skin refers to something missing.
    [[nodiscard]] static AnimatedModel load(const std::filesystem::path&, const GltfLimits& = {});
    /// The same for the content of a file named `path`.
    [[nodiscard]] static AnimatedModel parse(const std::string& bytes, const std::filesystem::path&,
                                             const GltfLimits& = {});

    [[nodiscard]] const std::vector<Animation>& animations() const;
    /// Returns the model at `seconds` in animation `i`, clamped to its first and last key. -1: the rest pose, with the
    /// file's default morph weights. Skins use up to eight joints per vertex (JOINTS_0 and JOINTS_1). Interpolation is
    /// STEP, LINEAR or CUBICSPLINE. Normals are deformed, too; flat normals are used if the file has none. Unsupported
    /// features are listed in `warnings`.
    [[nodiscard]] Model posed(int i, double seconds) const;

private:
    struct Parts;
    explicit AnimatedModel(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
    std::shared_ptr<const Parts> parts_;
};

}  // namespace vitrine::render

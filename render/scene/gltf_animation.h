#pragma once

#include "render/scene/gltf.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::render {

/// A glTF file with its animations, skins and morph targets, to be posed at any moment. Immutable; any thread may pose.
class AnimatedModel {
public:
    struct Animation {
        std::string name;     ///< As in the file, or "animation 0".
        double duration = 0;  ///< Seconds, to the last key.
    };

    /// Throws Failure as `loadGltf` does, and where an animation or a skin names what is not there.
    [[nodiscard]] static AnimatedModel load(const std::filesystem::path&, const GltfLimits& = {});
    /// The same from the bytes of a file named `path`.
    [[nodiscard]] static AnimatedModel parse(const std::string& bytes, const std::filesystem::path&,
                                             const GltfLimits& = {});

    [[nodiscard]] const std::vector<Animation>& animations() const;
    /// The model `seconds` into animation `i`; before its first and after its last key it is as there. -1: the rest
    /// pose, with the weights that the file gives its morph targets. Skins take up to eight joints a vertex (JOINTS_0
    /// and JOINTS_1). Interpolation is STEP, LINEAR or CUBICSPLINE. Normals are bent along; where a file has none, they
    /// are flat. What is not supported is in `warnings`.
    [[nodiscard]] Model posed(int i, double seconds) const;

private:
    struct Parts;
    explicit AnimatedModel(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
    std::shared_ptr<const Parts> parts_;
};

}  // namespace vitrine::render

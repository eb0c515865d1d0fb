#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "exhibits/pixel_art/small_world.h"
#include "render/files/asset_store.h"
#include "render/scene/gltf_animation.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::pixel_art {

/// Pose of a model that is shown.
struct ModelPose {
    int animation = -1;  ///< Index; -1: the pose in the file without animation.
    double seconds = 0;  ///< Time within the animation, which repeats.
    std::string still;   ///< Why the pose does not change while time runs, half a sentence; empty if it changes.
};

/// Returns the pose for these values. `now` is the exhibit's time in whole steps since the beginning, seconds.
[[nodiscard]] ModelPose poseOf(const PixelArtTable&, const ParameterValues&,
                               const std::vector<render::AnimatedModel::Animation>&, double now);

/// The user's model in a pose. Immutable.
struct PosedModel {
    std::shared_ptr<const render::Model> model;  ///< Null if the file cannot be read; `failure` then says why.
    render::Box framed;                          ///< Box that the picture shows: the model at rest and in motion.
    ModelPose pose;
    std::vector<Message> warnings;  ///< Features of the file that are not drawn, sentences.
    Message failure;
    std::uint64_t id = 0;  ///< Hash of file and pose.
};

/// Returns the posed model. The file is read once, and each pose is made once for all callers.
[[nodiscard]] PosedModel posedModel(const PixelArtTable&, const ParameterValues&, double now, render::AssetStore&);

}  // namespace vitrine::pixel_art

#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "exhibits/pixel_art/small_world.h"
#include "render/files/asset_store.h"
#include "render/scene/gltf_animation.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vitrine {

/// Which of a model's poses is shown.
struct ModelPose {
    int animation = -1;  ///< Index; -1: as the file stands.
    double seconds = 0;  ///< Into the animation, which begins again when it is over.
    std::string still;   ///< Why the pose stays as it is while time runs, half a sentence; empty: it does not.
};

/// Of these values; `now` is the exhibit's time in whole steps, seconds, from the beginning on.
[[nodiscard]] ModelPose poseOf(const PixelArtTable&, const ParameterValues&,
                               const std::vector<render::AnimatedModel::Animation>&, double now);

/// A visitor's model in a pose. Immutable.
struct PosedModel {
    std::shared_ptr<const render::Model> model;  ///< Null: it cannot be read, and `failure` says why.
    render::Box framed;                          ///< What the picture holds: the model as it stands and as it moves.
    ModelPose pose;
    std::vector<std::string> warnings;  ///< What the file asks for and is not drawn, sentences.
    std::string failure;
    std::uint64_t id = 0;  ///< Of file and pose.
};

/// The file is read once, and a pose is made once for all who show it.
[[nodiscard]] PosedModel posedModel(const PixelArtTable&, const ParameterValues&, double now, render::AssetStore&);

}  // namespace vitrine

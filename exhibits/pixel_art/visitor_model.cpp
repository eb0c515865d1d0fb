#include "exhibits/pixel_art/visitor_model.h"

#include "render/hash.h"
#include "render/scene/held_bytes.h"

#include <algorithm>
#include <cmath>

namespace vitrine::pixel_art {
namespace {

constexpr int framedMoments = 8;  ///< Number of poses of an animation that are examined to find its extent.

/// A file, and its model at rest.
struct VisitorFile {
    render::AnimatedModel animated;
    render::Model rest;
};

render::AssetStore::Made<VisitorFile> readVisitorFile(const std::string& path)
{
    const render::AnimatedModel animated = render::AnimatedModel::load(path);
    auto made = std::make_shared<VisitorFile>(VisitorFile{animated, animated.posed(-1, 0)});
    return {made, 2 * render::heldBytes(made->rest)};
}

render::Box framedBy(const VisitorFile& file, int animation)
{
    render::Box all = file.rest.bounds;
    if (animation < 0) return all;
    const double duration = file.animated.animations()[static_cast<std::size_t>(animation)].duration;
    for (int i = 0; i < framedMoments; ++i) {
        const render::Box box = file.animated.posed(animation, duration * (i + 1) / framedMoments).bounds;
        if (box.empty()) continue;
        all.include(box.low);
        all.include(box.high);
    }
    return all;
}

}  // namespace

ModelPose poseOf(const PixelArtTable& t, const ParameterValues& values,
                 const std::vector<render::AnimatedModel::Animation>& animations, double now)
{
    ModelPose pose;
    const double speed = values[t.animationSpeed];
    pose.animation = std::min(values[t.animation], static_cast<int>(animations.size())) - 1;
    if (pose.animation >= 0) {
        const double duration = animations[static_cast<std::size_t>(pose.animation)].duration;
        const double rest = duration > 0 ? std::fmod(now * speed, duration) : 0;
        pose.seconds = std::isfinite(rest) ? rest : 0;
    }
    pose.still = animations.empty()         ? "the model has no animation"
                 : values[t.animation] == 0 ? "no animation of the model is chosen"
                 : !(speed > 0)             ? "the speed of the model's animation is 0"
                 : !values[t.animate]       ? "time does not run"
                                            : "";
    return pose;
}

PosedModel posedModel(const PixelArtTable& t, const ParameterValues& values, double now, render::AssetStore& assets)
{
    PosedModel made;
    const auto file = assets.get<VisitorFile>("pixel_art.model", values[t.model], readVisitorFile);
    made.failure = file.failure;
    if (!file.value) return made;
    const ModelPose pose = poseOf(t, values, file.value->animated.animations(), now);
    const auto framed = assets.made<render::Box>(
        "pixel_art.framed", std::to_string(pose.animation),
        [&]() -> render::AssetStore::Made<render::Box> {
            return {std::make_shared<render::Box>(framedBy(*file.value, pose.animation)), sizeof(render::Box)};
        },
        file.value);
    const auto posed = assets.made<render::Model>(
        "pixel_art.pose", std::to_string(pose.animation) + ' ' + std::to_string(pose.seconds),
        [&]() -> render::AssetStore::Made<render::Model> {
            auto model = std::make_shared<render::Model>(file.value->animated.posed(pose.animation, pose.seconds));
            const std::uint64_t bytes = render::heldBytes(*model);
            return {std::move(model), bytes};
        },
        file.value);
    if (!framed.value || !posed.value) {
        made.failure = framed.failure.empty() ? posed.failure : framed.failure;
        return made;
    }
    made.failure = render::whyNothingIsSeen(values[t.model], *framed.value);
    if (!made.failure.empty()) return made;
    made.model = posed.value;
    made.framed = *framed.value;
    made.pose = pose;
    made.warnings = file.value->rest.warnings;
    made.id = render::Hash().addValue(file.id).addValue(pose.animation).addValue(pose.seconds).value();
    return made;
}

}  // namespace vitrine::pixel_art

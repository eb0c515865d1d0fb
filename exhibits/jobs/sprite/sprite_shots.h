#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/jobs/sprite/sprite_sheet.h"
#include "render/plan/render_backend.h"
#include "render/scene/gltf_animation.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::pixel_art {
struct WorldPart;
}

namespace vitrine::jobs {

/// Name of the exhibit whose style sprites are drawn in.
inline constexpr const char* spriteLookName = "pixel_art";

/// Views and frames of an object to draw.
struct SpriteRequest {
    int directions = 8;  ///< Evenly spaced around the object; the first is the azimuth of the pixel art.
    int frames = 1;      ///< Per direction, evenly spaced over the animation.
    glm::ivec2 size{64, 64};
    std::string animation;  ///< By name; empty: the first one.
    SpriteMotion motion = SpriteMotion::automatic;
};

/// An object of which sprites are made. Immutable.
class SpriteSubject {
public:
    /// Makes the built-in object: the torus over its pillar, which tumbles.
    SpriteSubject() = default;
    /// Reads a glTF file with its animations. Throws Failure like `AnimatedModel::load`.
    explicit SpriteSubject(const std::filesystem::path& file)
        : model_(render::AnimatedModel::load(file)), name_(file.string())
    {
    }

    /// Returns its name for messages.
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Returns the parts in frame `i` of `n`. Throws Failure (ErrorKind::usage) if the animation does not exist.
    [[nodiscard]] std::vector<pixel_art::WorldPart> parts(const SpriteRequest&, int i) const;
    /// Returns the length of the animation in seconds.
    [[nodiscard]] double duration(const SpriteRequest&) const;
    /// Returns whether its frames differ; those of the built-in object always do.
    [[nodiscard]] bool animated() const { return !model_ || !animations().empty(); }
    /// Returns the names of its animations, in the order of the file.
    [[nodiscard]] std::vector<std::string> animations() const;
    /// Returns sentences on features of the file that are not supported.
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    [[nodiscard]] int animationOf(const SpriteRequest&) const;
    std::optional<render::AnimatedModel> model_;
    std::string name_ = "the torus over its pillar";
};

/// Draws the frames one by one, direction by direction, with settings of the exhibit `spriteLookName`. It uses the
/// camera's elevation, the light and the lines of these settings; the projection is orthographic, as large as all
/// frames fit. Normals are the drawn ones, unless the settings choose another method. It turns about the vertical axis
/// through its origin if that axis meets its box, else about the one through its center. The pivot is the origin, which
/// may be outside of the frame.
class SpriteShots {
public:
    SpriteShots(ParameterValues look, std::shared_ptr<const SpriteSubject>, SpriteRequest);
    ~SpriteShots();

    /// Draws the next frame; the first step computes the poses of all frames. Throws Failure: ErrorKind::usage if the
    /// animation does not exist, ErrorKind::file if all frames are empty. Always call it with the same backend.
    void step(render::RenderBackend&);
    [[nodiscard]] bool finished() const;
    /// Returns the fraction that is done, 0 to 1.
    [[nodiscard]] double progress() const;
    [[nodiscard]] std::vector<SpriteFrame>& frames() { return frames_; }

private:
    struct Scene;
    void pose();

    ParameterValues look_;
    std::shared_ptr<const SpriteSubject> subject_;
    SpriteRequest request_;
    std::unique_ptr<Scene> scene_;
    std::vector<SpriteFrame> frames_;
};

/// Draws all frames.
[[nodiscard]] std::vector<SpriteFrame> drawSprite(const ParameterValues& look, const SpriteSubject&,
                                                  const SpriteRequest&, render::RenderBackend&);

}  // namespace vitrine::jobs

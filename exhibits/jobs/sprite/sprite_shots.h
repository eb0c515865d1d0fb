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

namespace vitrine {

struct WorldPart;

/// Name of the exhibit whose style sprites are drawn in.
inline constexpr const char* spriteLookName = "pixel_art";

/// Views and frames to draw of an object.
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
    /// The program's own: the torus over its pillar, which tumbles.
    SpriteSubject() = default;
    /// A glTF file, animated by itself. Throws Failure as `AnimatedModel::load`.
    explicit SpriteSubject(const std::filesystem::path& file)
        : model_(render::AnimatedModel::load(file)), name_(file.string())
    {
    }

    /// As messages have it.
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Frame `i` of `n`. Throws Failure (Blame::usage) where there is no such animation.
    [[nodiscard]] std::vector<WorldPart> parts(const SpriteRequest&, int i) const;
    /// Of a whole round, by the animation's own length, seconds.
    [[nodiscard]] double duration(const SpriteRequest&) const;
    /// Whether its frames differ: the program's own object always tumbles.
    [[nodiscard]] bool animated() const { return !model_ || !animations().empty(); }
    /// Names of its animations, in the file's order.
    [[nodiscard]] std::vector<std::string> animations() const;
    /// What its file asks for and is not drawn, sentences.
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    [[nodiscard]] int animationOf(const SpriteRequest&) const;
    std::optional<render::AnimatedModel> model_;
    std::string name_ = "the torus over its pillar";
};

/// Draws frames one by one, direction by direction, in a look (values of `spriteLookName`): its camera's elevation,
/// light and lines; orthographic, as large as all frames fit, by drawn normals unless the look has a method other than
/// its initial one. It is turned about its origin where it stands over that, else about its middle; the pivot is the
/// origin, which may lie outside of the frame.
class SpriteShots {
public:
    SpriteShots(ParameterValues look, std::shared_ptr<const SpriteSubject>, SpriteRequest);
    ~SpriteShots();

    /// The next frame, or the poses of all, which come first. Throws Failure (Blame::usage) where there is no such
    /// animation, and (Blame::file) where nothing is to be seen in any frame. Always on the same backend.
    void step(render::RenderBackend&);
    [[nodiscard]] bool finished() const;
    /// The part that is done, 0 to 1.
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

/// All frames at once.
[[nodiscard]] std::vector<SpriteFrame> drawSprite(const ParameterValues& look, const SpriteSubject&,
                                                  const SpriteRequest&, render::RenderBackend&);

}  // namespace vitrine

#pragma once

#include "exhibits/your_shader/guest_blocks.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader_table.h"
#include "render/image/sound.h"
#include "render/image/texture.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::guest {

/// Picture or sound of an input: from a file, with its state, or the planned picture of another exhibit.
struct LoadedPicture {
    std::shared_ptr<const render::Texture> texture;
    std::uint64_t id = 0;
    std::shared_ptr<const render::Sound> sound = {};
    std::optional<ShownPicture> shown = {};  ///< Replaces `texture`.
};

/// Everything needed to plan the picture of a work.
struct WorkShot {
    const Work& work;
    const YourShaderTable& table;   ///< Table of `values`.
    const ParameterValues& values;  ///< With the inputs of the work.
    const std::vector<LoadedPicture>& ofInputs;
    const std::vector<LoadedPicture>& files;
    glm::ivec2 size{1};  ///< Size of the picture, in pixels.
    double time = 0;     ///< Seconds.
    bool inHall = false;
};

/// Planned picture of a work.
struct WorkPicture {
    std::string image;
    /// Images and states that the pass which shows the picture must read, so that they are kept for the next step.
    std::vector<std::string> reads;
    std::vector<std::string> floats;  ///< Float images that are kept, the first ones.
};

/// Largest number of `WorkPicture::floats`.
inline constexpr std::size_t mostMarkedImages = 2;
/// Largest number of a step that is computed.
inline constexpr std::int64_t lastStep = 36'000;
/// Largest number of steps in one frame of the window while time runs.
inline constexpr std::int64_t stepsPerFrame = 8;

/// Plans the passes that draw the picture. Returns nothing, and says why in the plan, if it cannot be drawn.
///
/// The picture of a work that reads what it drew before is that of step N = floor(time * rate), computed from empty
/// buffers. Each of its buffers has two images, which the steps use in turn, so that a step can be repeated. `kept`
/// says which step the images hold. The plan has the steps after it, or all if it is a later one.
[[nodiscard]] std::optional<WorkPicture> planWork(const WorkShot&, const render::PersistentState& kept,
                                                  render::FramePlan&);

}  // namespace vitrine::guest

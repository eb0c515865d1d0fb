#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader_table.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <string_view>

// Uniform blocks of a visitor's shader, in the layout that guest_glsl.h declares.
namespace vitrine::guest {

/// Time that a step shows.
struct StepTime {
    double seconds = 0;
    double delta = 0;  ///< Since the step before; 0 in the first one.
    double rate = 60;  ///< Steps a second.
    std::int64_t frame = 0;
};

/// Mouse in the picture: positions from 0 to 1, origin at the lower left.
struct Mouse {
    glm::dvec2 position{0.5};
    bool isDown = false;
    std::optional<glm::dvec2> pressedAt;  ///< Position at which the button was pressed last.
};

/// Pass and its image, of which a cube map is drawn face by face.
struct DrawnPass {
    std::size_t pass = 0;
    glm::ivec2 size{1};
    int face = 0;  ///< In the order of OpenGL: +x, -x, +y, -y, +z, -z.
};

/// Returns the size of a picture that a pass reads, by the shader's name for it; (1, 1) if it is unknown.
using PictureSize = std::function<glm::ivec2(std::string_view name)>;

/// Returns the block of a shader's inputs.
[[nodiscard]] render::Bytes inputBytes(const Work&, const YourShaderTable&, const ParameterValues&, const StepTime&,
                                       const PictureSize&);

/// Returns the block of the variables that the program fills: time, sizes, mouse, date. The date is noon of
/// 1 January 2026 and the time, so that the same settings give the same picture on every day.
[[nodiscard]] render::Bytes frameBytes(const Work&, const DrawnPass&, const StepTime&, const Mouse&,
                                       const PictureSize&);

}  // namespace vitrine::guest

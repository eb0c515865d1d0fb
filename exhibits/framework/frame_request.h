#pragma once

#include "exhibits/framework/exhibit.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine {

/// What the supersamples of a picture are averaged in: tone-mapped light for the eye, radiance for files
/// of linear light.
enum class AverageIn : std::uint8_t { display, radiance };

/// One picture to plan.
struct FrameRequest {
    render::Camera camera;
    render::Raster raster;
    double time = 0;  ///< Seconds.
    std::uint32_t seed = 1;
    int sample = 0;   ///< This is sample number `sample` (from 0) ...
    int samples = 1;  ///< ... of so many.
    /// Above 0: the so-manieth frame, from 1, of a picture in motion, whose pixels are averaged with those of the
    /// frames before it, as the hall's table says. 0: the picture rests. Of one sample only.
    int movingFrame = 0;
    AverageIn averageIn = AverageIn::display;
    Channels channels;
    bool transparent = false;  ///< No sky or environment behind what is drawn: alpha 0 there.
    std::optional<std::size_t>
        alone;  ///< Only this exhibit (by its index in Museum::subjects()), in the environment's light.
    std::optional<std::size_t> cutOut;  ///< Only this exhibit, where it stands, in the hall's light: alpha 0 around it.
    glm::dmat4 exhibitTransform{1};     ///< For `alone` or `subject`: scale and rotation about its own origin.
    std::optional<std::size_t> subject;
    bool runEverything = false;
    bool cut = false;       ///< The camera jumped: nothing of the frame before is of use.
    bool finished = false;  ///< It is not drawn again: work of several frames is done in this one, and no program that
                            ///< is still being built is stood in for.
    bool needsFiles =
        false;  ///< A file that the look names and that cannot be read is a Failure, not a complaint of the plan.
    bool rests =
        false;  ///< Its values have not changed for a while: programs may be built for them alone (ShaderKey::better).
    /// No more than so many of those in view, the nearest ones: what opens shows something soon, and adds to it.
    int mostExhibits = std::numeric_limits<int>::max();
    bool waitless = false;  ///< Prepared by a thread that must not wait: without what nobody has read or made yet.
    /// Seconds since each exhibit's button was pressed, in the order of Museum::subjects(); may be shorter.
    std::vector<double> sincePressed;
};

/// How finely a picture is drawn: rows of the hall's table that are no part of what is shown.
struct PictureQuality {
    int supersamples = 16;
    double resolutionScale = 1;
    int historyFrames = 1;  ///< Over which a picture in motion is averaged; 1: every frame stands alone.
};
inline constexpr std::string_view supersamplesRow = "supersamples";
inline constexpr std::string_view resolutionScaleRow = "resolutionScale";
inline constexpr std::string_view temporalAntialiasingRow = "temporalAntialiasing";
inline constexpr std::string_view historyFramesRow = "historyFrames";

/// Of the hall's values; as it is where its table has no such rows.
[[nodiscard]] PictureQuality pictureQuality(const ParameterValues& hall);

}  // namespace vitrine

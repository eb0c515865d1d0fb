#pragma once

#include "exhibits/framework/scene/frame_request.h"
#include "exhibits/framework/table/preset_values.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Frame before a picture, from which its motion vectors start.
struct FrameBefore {
    double seconds = 0;       ///< Time from that frame to the picture; above 0.
    render::Camera camera{};  ///< In the space of the picture's camera.
};

/// Circumstances of a picture besides all settings. Both together reproduce the picture bit by bit. Inside the
/// exhibition that a picture file contains, it is stored under "picture":
///
///     {"size": [640, 360], "samples": 4, "time": 0.0, "seed": 1}
///
/// Optional keys: "alone": true, "transparent": true, "channels" beyond color (["depth", "normal", "evaluations",
/// ...]), "transform" (rows of the 3 x 3 matrix of scale and rotation), "camera" if it was not the exhibition's,
/// "before" ({"seconds", "camera"}: `FrameBefore`), and "language" of the plaques if it was not English.
struct PictureRecord {
    glm::ivec2 size{640, 360};  ///< Pixels.
    int samples = 4;            ///< Per pixel.
    double time = 0;            ///< Seconds.
    std::uint32_t seed = 1;
    bool alone = false;        ///< Only the selected exhibit; `camera` is then in its own space.
    bool transparent = false;  ///< No background; in the hall, the selected exhibit is cut out.
    bool depth = false;        ///< The channel "depth.Z" was added.
    bool position = false;     ///< The channels "position.X" to "position.Z" were added.
    bool objects = false;      ///< The channels of Cryptomatte were added.
    bool motion = false;       ///< The channels "backward.u" and "backward.v" were added. They need `before`.
    std::optional<FrameBefore> before{};
    Channels channels{};
    glm::dmat4 exhibitTransform{1};  ///< Scale and rotation of the selected exhibit around its own origin.
    std::optional<render::Camera> camera{};
    std::string language = "en";

    /// Returns whether the same picture can be taken of the hall, without naming the exhibit.
    [[nodiscard]] bool isOfTheHall() const;
};

/// Names of all channels beyond color, as options and files have them: "depth".
[[nodiscard]] std::vector<std::string_view> channelNames();
/// Returns whether the record has the channel of this name, to read or to set; null for an unknown name.
[[nodiscard]] bool* channelOf(PictureRecord&, std::string_view name);

[[nodiscard]] render::Json jsonFromPictureRecord(const PictureRecord&);

/// Parses a record. Missing keys keep their initial values; unknown ones are dropped with a note. Throws Failure naming
/// file, line and key for a wrong type or a value out of range.
[[nodiscard]] PictureRecord pictureRecordFromJson(const render::Json&, const JsonPlace&,
                                                  std::vector<std::string>& notes);

}  // namespace vitrine

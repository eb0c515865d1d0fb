#pragma once

#include "exhibits/framework/frame_request.h"
#include "exhibits/framework/preset_values.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// How a picture was taken, besides the settings of everything: both together give the same picture again, to the bit.
/// In the exhibition inside a picture it stands under "picture":
///
///     {"size": [640, 360], "samples": 4, "time": 0.0, "seed": 1}
///
/// Further keys stand there only where they say something: "alone": true, "transparent": true, "channels" beyond color
/// (["depth", "normal", "evaluations"]), "transform" (rows of the 3 x 3 matrix of scale and rotation), "camera" where
/// the picture was not taken with the exhibition's own camera, and "language" of the plaques where it is not English.
struct PictureRecord {
    glm::ivec2 size{640, 360};  ///< Pixels.
    int samples = 4;            ///< Per pixel.
    double time = 0;            ///< Seconds.
    std::uint32_t seed = 1;
    bool alone = false;        ///< Only the chosen exhibit; `camera` is then in its own space.
    bool transparent = false;  ///< Nothing around it; in the hall, the chosen exhibit is cut out.
    bool depth = false;        ///< The channel "depth.Z" was added.
    Channels channels{};
    glm::dmat4 exhibitTransform{1};  ///< Scale and rotation of the chosen exhibit about its own origin.
    std::optional<render::Camera> camera{};
    std::string language = "en";

    /// Whether the same picture can be taken of the hall, without naming the exhibit.
    [[nodiscard]] bool isOfTheHall() const;
};

[[nodiscard]] render::Json jsonFromPictureRecord(const PictureRecord&);

/// Keys that are missing keep their initial values; unknown ones are left out with a note. Throws Failure naming file,
/// line and key for a wrong type or a value out of range.
[[nodiscard]] PictureRecord pictureRecordFromJson(const render::Json&, const JsonPlace&,
                                                  std::vector<std::string>& notes);

}  // namespace vitrine

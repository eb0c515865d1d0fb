#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// A scene object of the reference, converted to a scene file.
struct ConvertedScene {
    std::string text;
    std::vector<MadeFrom> parts;
};

/// Returns whether a text is a scene object of the reference: it has no format, but lists of primitives or
/// combinations.
[[nodiscard]] bool isSourceScene(const render::JsonText&);

/// Converts a scene to this project's format, with the look "asInTheReference". Differences from the reference: planes
/// are solid half spaces behind the plane as seen from the camera, instead of sheets; a degenerate shape is a finding
/// instead of a division by zero; the named cube maps become skies of their colors; noise scenes become surfaces of
/// noise. Returns nothing if findings were added. `without`: shapes (values of the text) that are left out, together
/// with combinations that contain nothing else.
[[nodiscard]] std::optional<ConvertedScene> convertSourceScene(const render::JsonText&, Findings&,
                                                               const std::set<std::uint32_t>& without = {});

}  // namespace vitrine::scenes

#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// A scene object of the source, written as a scene of ours.
struct ConvertedScene {
    std::string text;
    std::vector<MadeFrom> parts;
};

/// Whether a text is a scene object of the source: it has no format, and lists of primitives or combinations.
[[nodiscard]] bool isSourceScene(const render::JsonText&);

/// The same scene in our words, "asInTheSource". What differs from the source: planes are the solid half-space away
/// from the camera, where the source has sheets; a degenerate shape is a finding, where the source divides by zero;
/// the named cube maps are skies in their colors; noise scenes are surfaces of noise. Nothing where findings were
/// added. `without`: shapes (values of the text) that are left out, and with them the combinations that hold nothing
/// else.
[[nodiscard]] std::optional<ConvertedScene> convertSourceScene(const render::JsonText&, Findings&,
                                                               const std::set<std::uint32_t>& without = {});

}  // namespace vitrine::scenes

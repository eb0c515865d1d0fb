#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <optional>
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
/// from the camera, where the source has sheets; a degenerate triangle is a finding, where the source divides by zero;
/// the named cube maps are skies in their colors; noise scenes are surfaces of noise. Nothing where findings were
/// added.
[[nodiscard]] std::optional<ConvertedScene> convertSourceScene(const render::JsonText&, Findings&);

}  // namespace vitrine::scenes

#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// The numbers of a shape of the source, by key.
using SourceNumbers = std::map<std::string, std::array<double, 3>, std::less<>>;

struct SourceKey {
    std::string_view name;
    int numbers = 1;     ///< 1, or as many in an array.
    bool needed = true;  ///< Else 0 where it is not given.
};

/// A kind of shape of the source.
struct SourceKind {
    std::string_view type;  ///< In a combination: "sphere".
    std::string_view list;  ///< Under "primitives": "spheres".
    std::vector<SourceKey> keys;
    /// As a node of ours. `eye` is where the camera is. Throws std::string with what is wrong, without its full stop.
    render::Json (*node)(const SourceNumbers&, const glm::dvec3& eye);
};

[[nodiscard]] const std::vector<SourceKind>& sourceKinds();

}  // namespace vitrine::scenes

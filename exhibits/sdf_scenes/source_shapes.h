#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// Numbers of a shape of the reference, by key.
using SourceNumbers = std::map<std::string, std::array<double, 3>, std::less<>>;

struct SourceKey {
    std::string_view name;
    int numbers = 1;     ///< 1, or the length of an array.
    bool needed = true;  ///< Optional numbers are 0 if missing.
};

/// Kind of shape of the reference.
struct SourceKind {
    std::string_view type;  ///< Name in a combination: "sphere".
    std::string_view list;  ///< Name under "primitives": "spheres".
    std::vector<SourceKey> keys;
    /// Converts the shape to a node. `eye` is the camera's position. Throws std::string with the error, without its
    /// full stop.
    render::Json (*node)(const SourceNumbers&, const glm::dvec3& eye);
};

[[nodiscard]] const std::vector<SourceKind>& sourceKinds();

}  // namespace vitrine::scenes

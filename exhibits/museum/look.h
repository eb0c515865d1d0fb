#pragma once

#include "exhibits/framework/parameters.h"
#include "render/scene/camera.h"

#include <vector>

namespace vitrine {

/// A snapshot of everything that can be set: one set of values per exhibit (the hall first) and the
/// camera. Undo, presets of everything and A/B comparisons are Looks.
struct Look {
    std::vector<ParameterValues> values;  ///< In the order of Museum::exhibits().
    render::Camera camera;

    bool operator==(const Look&) const = default;
};

}  // namespace vitrine

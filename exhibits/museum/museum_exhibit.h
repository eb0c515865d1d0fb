#pragma once

#include "exhibits/framework/scene/exhibit.h"

#include <cstddef>

namespace vitrine {

/// An exhibit of a museum.
struct MuseumExhibit {
    std::size_t index;  ///< Index in Museum::subjects() and SceneState::values.
    const Exhibit& exhibit;
};

}  // namespace vitrine

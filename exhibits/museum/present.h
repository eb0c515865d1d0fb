#pragma once

#include "exhibits/museum/museum.h"

#include <string>

namespace vitrine {

/// An exhibit in the picture's world, visible or not.
struct Museum::Present {
    std::size_t index = 0;  ///< Index of the subject.
    const Exhibit& exhibit;
    glm::dmat4 worldFromExhibit{1};
    render::Box box;       ///< Bounds in world space.
    std::string hidden;    ///< Reason why it is not visible; empty: it may be.
    std::string unlit;     ///< Reason why no sunlight reaches it, so that it casts no shadow; empty: it may.
    std::string noShadow;  ///< Reason why its shadow is not drawn: it casts none, or none that may be visible.
};

/// Returns the box united with its shadow on the floor (at most 15 m of it, if the sun is low).
[[nodiscard]] render::Box withShadow(const render::Box& box, const glm::dvec3& towardsSun);

/// Returns the view of the whole picture, whatever tile is requested.
[[nodiscard]] render::View wholeView(const FrameRequest&);

}  // namespace vitrine

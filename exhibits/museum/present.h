#pragma once

#include "exhibits/museum/museum.h"

#include <string>

namespace vitrine {

/// An exhibit that stands in the picture's world, seen or not.
struct Museum::Present {
    std::size_t index = 0;  ///< Of the subject.
    const Exhibit& exhibit;
    glm::dmat4 worldFromExhibit{1};
    render::Box box;       ///< Its bounds, world space.
    std::string hidden;    ///< Why it cannot be seen; empty: it may be.
    std::string unlit;     ///< Why it throws no shadow at all.
    std::string noShadow;  ///< Why none is drawn: it throws none, or none that may be seen.
};

/// The box together with the shadow it throws on the floor (or 15 m of it, where the sun is low).
[[nodiscard]] render::Box withShadow(const render::Box& box, const glm::dvec3& towardsSun);

/// The view of the whole picture, whichever tile of it is asked for.
[[nodiscard]] render::View wholeView(const FrameRequest&);

}  // namespace vitrine

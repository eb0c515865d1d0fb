#pragma once

#include "exhibits/museum/museum.h"

#include <string>
#include <vector>

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

    /// Reason of exhibits that the first pictures of a window leave out.
    static constexpr const char* othersFirst = "the window is opening, and nearer exhibits are drawn first";

    /// Returns the exhibits of each picture that a visible one of `shown` shows (`ShowsPictures`).
    [[nodiscard]] static std::vector<std::vector<Present>>
    ofPictures(const Museum&, const Prepared&, const FrameRequest&, const std::vector<Present>& shown);
    /// Does what Museum::nextChange does. `isPicture`: for a picture that an exhibit shows, which shows no others.
    [[nodiscard]] static double nextChange(const Museum&, const Prepared&, const FrameRequest&, bool isPicture);
    /// Returns the seconds until a picture that the exhibit shows changes by itself; infinity: never.
    [[nodiscard]] static double nextOfPictures(const Museum&, const Prepared&, const FrameRequest&, const Present&);
};

/// Returns the box united with its shadow on the floor (at most 15 m of it, if the sun is low).
[[nodiscard]] render::Box withShadow(const render::Box& box, const glm::dvec3& towardsSun);

/// Returns whether the exhibit is a work behind an opening in a wall: its bounds are flat and face into the room.
[[nodiscard]] bool isBehindOpening(const render::Box& bounds);

/// Returns whether the exhibit's lamps change while it moves.
[[nodiscard]] bool changesLamps(const Exhibit&, const ExhibitState&);

/// Returns the view of the whole picture, whatever tile is requested.
[[nodiscard]] render::View wholeView(const FrameRequest&);

}  // namespace vitrine

#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace vitrine::printing {

/// Position of a quilt's first view: bottom left with rows upwards as in Looking Glass, or top left with rows
/// downwards.
enum class QuiltOrder : std::uint8_t { bottomLeft, topLeft };

/// Largest turn, in degrees, and largest shift, in percent, to either side.
inline constexpr double mostTurn = 360, mostShift = 100;

/// Rotation and shift of a picture by hand, before it becomes a view of a print. Stored in the units in which users
/// type them, so every digit is preserved.
struct ViewPlace {
    double turn = 0;      ///< Clockwise about the middle, degrees, up to `mostTurn` to either side.
    glm::dvec2 shift{0};  ///< To the right and down, percent of the view's width and height, up to `mostShift`.

    bool operator==(const ViewPlace&) const = default;
};

/// Places by the number of the picture among all pictures given, from 1. A picture without a place stays as it is.
using ViewPlaces = std::map<int, ViewPlace>;

/// Parses places: "3:1.5,2,-0.5; 7:0,1,0" turns picture 3 by 1.5 degrees clockwise and moves it 2 % of the view's width
/// to the right and half a percent of its height up. A line break separates places, too. Throws Failure
/// (ErrorKind::usage) that quotes the part it cannot read.
[[nodiscard]] ViewPlaces viewPlaces(std::string_view text);

/// Formats places; `viewPlaces` reads exactly the same values back. Places that change nothing are left out.
[[nodiscard]] std::string textOf(const ViewPlaces&);

/// Returns the place of a picture; without an entry, a place that changes nothing.
[[nodiscard]] ViewPlace placeOf(const ViewPlaces&, int picture);

/// Throws Failure (ErrorKind::usage) if a place names a picture beyond the last one.
void requirePictures(const ViewPlaces&, int pictures);

}  // namespace vitrine::printing

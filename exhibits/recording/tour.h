#pragma once

#include "exhibits/museum/museum.h"
#include "exhibits/recording/camera_path.h"
#include "render/files/strict_json.h"

#include <string>
#include <vector>

namespace vitrine {

/// A view that is kept under a name.
struct Bookmark {
    std::string name;
    render::Camera camera;  ///< In the world.

    bool operator==(const Bookmark&) const = default;
};

/// The version that is written; newer ones are refused.
inline constexpr int tourVersion = 1;

/// Bookmarks in the order in which a camera passes them. As a file:
///
///     {
///       "format": "vitrine-tour",
///       "version": 1,
///       "app": "0.1.0",
///       "name": "Round the hall",
///       "closed": false,
///       "pace": "eased",
///       "bookmarks": [
///         {"name": "Entrance", "camera": {"eye": [0.0, 1.65, 10.5], "target": [0.0, 1.75, 0.0], "fov": 0.96}}
///       ]
///     }
struct Tour {
    std::string name;
    std::vector<Bookmark> bookmarks;
    bool closed = false;  ///< Back to the first one.
    Pace pace = Pace::eased;

    std::vector<std::string> notes = {};  ///< What reading changed or did not know, for people.
};

/// Throws Failure naming file, line and key for broken JSON, a missing key, a wrong type, another format, a newer
/// version, or no bookmark. Fields of view and places out of range are clamped and unknown keys left out, with a note.
[[nodiscard]] Tour parseTour(std::string text, std::string fileName);
[[nodiscard]] std::string tourText(const Tour&);

/// A path through the bookmarks that runs into none of the obstacles (`Museum::obstacles`). Where the smooth way
/// between two of them would, it is led round by a way that a visitor can walk, looking ahead. Throws Failure
/// (Blame::file) naming the two where there is none, or the one that is itself inside of an obstacle.
[[nodiscard]] CameraPath tourPath(const Obstacles&, const Tour&);

/// Past the best views of all exhibits in the museum's order, from the hall's own and back to it. Views that an object
/// of the visitor's own stands in are left out.
[[nodiscard]] Tour museumTour(const Museum&, const SceneState&);

/// The share of a motion (0 to 1) at which the camera first runs into something; negative: nowhere. Looks at it every
/// `longestStep` meters or closer.
[[nodiscard]] double firstCollision(const Obstacles&, const CameraMotion&);

}  // namespace vitrine

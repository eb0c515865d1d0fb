#pragma once

#include "exhibits/museum/museum.h"
#include "exhibits/recording/camera_path.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::recording {

/// A view with a name.
struct Bookmark {
    std::string name;
    render::Camera camera;  ///< World space.

    bool operator==(const Bookmark&) const = default;
};

/// The version that is written; newer ones are rejected.
inline constexpr int tourVersion = 1;

/// Bookmarks in the order in which the camera passes them. The file format:
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
    bool closed = false;  ///< Whether the tour returns to the first bookmark.
    Pace pace = Pace::eased;

    std::vector<std::string> notes = {};  ///< Changes and ignored parts, full sentences.
};

/// Parses a tour. Throws Failure naming file, line and key for broken JSON, a missing key, a wrong type, another
/// format, a newer version, or no bookmarks. Fields of view and positions out of range are clamped, and unknown keys
/// are ignored, with a note.
[[nodiscard]] Tour parseTour(std::string text, std::string fileName);
/// Reads a tour from a file. Throws Failure as `render::readFile` and `parseTour` do.
[[nodiscard]] Tour readTour(const std::filesystem::path&);
/// Returns the path of the file that keeps the visitor's bookmarks, as a tour. It may not exist.
[[nodiscard]] std::filesystem::path bookmarksFile();
[[nodiscard]] std::string tourText(const Tour&);

/// Returns a path through the bookmarks that passes all obstacles (`Museum::obstacles`). If the smooth way between two
/// bookmarks is blocked, it follows a way that a user can walk, looking ahead. Throws Failure (ErrorKind::file) that
/// names the two if there is none, or a bookmark inside an obstacle.
[[nodiscard]] CameraPath tourPath(const Obstacles&, const Tour&);

/// Returns a tour of the best views of all exhibits in the museum's order, starting and ending at the hall's. Views
/// from inside a user's object are left out.
[[nodiscard]] Tour museumTour(const Museum&, const SceneState&);

/// Returns the part of a motion (0 to 1) at which the camera first hits an obstacle; negative if it does not. Tests
/// the straight lines between cameras at 2001 evenly spaced parts.
[[nodiscard]] double firstCollision(const Obstacles&, const CameraMotion&);

}  // namespace vitrine::recording

#pragma once

#include "exhibits/framework/files/picture_record.h"
#include "exhibits/museum/assignment.h"
#include "exhibits/museum/picture.h"
#include "render/image/image_io.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Size of a picture if neither an option nor the picture of --preset gives it.
inline constexpr const char* usualPictureSize = "640x360";

/// Options of `render` and similar commands about the picture, as typed. If `preset` names a picture, its settings
/// replace options that are not given.
struct PictureOptions {
    std::string subject;  ///< Name of an exhibit, or "hall".
    std::string out;
    std::string size;  ///< Empty: that of the picture that `preset` names, or `usualPictureSize`.
    std::string preset;
    /// Takes only the settings of a picture that `preset` names, and not its camera and size.
    bool settingsOnly = false;
    std::vector<std::string> sets;     ///< Assignments "name=value" or "exhibit.name=value".
    std::vector<std::string> motions;  ///< Animations "name=sine:0.1:0.9:period=4", with the same names.
    std::optional<double> time;
    std::optional<std::uint32_t> seed;
    std::string eye, target, scale, rotate;
    double fovDegrees = 0;  ///< 0: that of the view.
    bool alone = false;
    bool transparent = false;
    int samples = 0;  ///< 0: the hall's supersamples if they were set, or 4.
    std::string environment, model;
};

/// Adds the options about the scene and the view, but not those about size and file. All have one heading.
void addSceneOptions(CLI::App&, PictureOptions&, const std::string& heading = "Options");

/// Adds the options time, seed, eye, target and fov.
void addCameraOptions(CLI::App&, PictureOptions&, const std::string& heading = "Options");

/// Applies the options about the camera. Throws Failure (ErrorKind::usage) naming the option.
void setCamera(const PictureOptions&, render::Camera&);

/// Values, camera and request that the options describe.
struct RequestedPicture {
    std::size_t subject = 0;
    SceneState sceneState;
    PictureRequest request;
    bool cameraFromPreset = false;
    std::optional<PictureRecord> taken;  ///< Record of how the preset's picture was taken, if it shows this subject.
    std::vector<std::string> notes;      ///< Sentences on corrected values, for standard error.
};
[[nodiscard]] RequestedPicture requestedPicture(const Museum&, const PictureOptions&);
/// The same with another scene state than the initial one. `camera`, if set, replaces the best view of the subject.
/// `taken` says how the picture was taken whose settings it starts from.
[[nodiscard]] RequestedPicture requestedPicture(const Museum&, const PictureOptions&, SceneState,
                                                const std::optional<render::Camera>&,
                                                std::optional<PictureRecord> taken = std::nullopt);

/// Parses "1.5,2,0" as three finite numbers; plain ones are in `unit`. Throws Failure (ErrorKind::usage) naming the
/// option.
[[nodiscard]] glm::dvec3 parseTriple(const std::string& option, const std::string& text, Unit unit = Unit::none);
/// Parses "640x360" as two positive numbers. `what` describes them and `such` is an example, for the message.
[[nodiscard]] glm::ivec2 parseSize(const std::string& option, const std::string& text,
                                   const std::string& what = "width x height in whole pixels",
                                   const std::string& such = "640x360");

}  // namespace vitrine::app

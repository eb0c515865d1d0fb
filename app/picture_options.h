#pragma once

#include "exhibits/framework/picture_record.h"
#include "exhibits/museum/picture.h"
#include "render/image/image_io.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Size of a picture if neither an option nor the picture that --preset names says it.
inline constexpr const char* usualPictureSize = "640x360";

/// Options of `render` and its relatives about the picture, as typed. Options not given are as in the picture that
/// `preset` names, where it names one.
struct PictureOptions {
    std::string subject;  ///< An exhibit's name, or "hall".
    std::string out;
    std::string size;  ///< Empty: as the picture that `preset` names was taken, or `usualPictureSize`.
    std::string preset;
    bool settingsOnly = false;         ///< Of a picture that `preset` names, not how it was taken.
    std::vector<std::string> sets;     ///< "name=value" or "exhibit.name=value".
    std::vector<std::string> motions;  ///< "name=sine:0.1:0.9:period=4", by the same names.
    std::optional<double> time;
    std::optional<std::uint32_t> seed;
    std::string eye, target, scale, rotate;
    double fovDegrees = 0;  ///< 0: the view's own.
    bool alone = false;
    bool transparent = false;
    bool everything = false;
    int samples = 0;       ///< 0: as the hall's supersamples were set, or 4.
    std::string channels;  ///< Empty: as the picture that `preset` names was taken, or color alone.
    std::string environment, model;
};

/// Adds the options that describe a picture to a sub-command.
void addPictureOptions(CLI::App&, PictureOptions&);
/// Those of them that say what is shown and from where, not how large and into what file; all under one heading.
void addSceneOptions(CLI::App&, PictureOptions&, const std::string& heading = "Options");

/// Those that say when, with what seed and from where: time, seed, eye, target, fov.
void addCameraOptions(CLI::App&, PictureOptions&, const std::string& heading = "Options");

/// What the options say of the camera, in place of what it was. Throws Failure (Blame::usage) naming the option.
void setCamera(const PictureOptions&, render::Camera&);

/// Values, camera and request that the options ask for. Throws Failure naming the option and what to give.
struct RequestedPicture {
    std::size_t subject = 0;
    SceneState sceneState;
    PictureRequest request;
    bool cameraFromPreset = false;
    std::optional<PictureRecord> taken;  ///< How the picture that the preset came from was taken, if of this subject.
    std::vector<std::string> notes;      ///< What was brought to the nearest legal value, for standard error.
};
[[nodiscard]] RequestedPicture requestedPicture(const Museum&, const PictureOptions&);
/// The same from this look in place of the initial one; the camera, where there is one, in place of the best view of
/// the subject.
[[nodiscard]] RequestedPicture requestedPicture(const Museum&, const PictureOptions&, SceneState,
                                                const std::optional<render::Camera>&);

/// Sets several, each a "name=value", whatever their order: files that give rows come first.
void applySets(const Museum&, SceneState&, std::size_t subject, const std::vector<std::string>& assignments,
               std::vector<std::string>& notes);

/// Sets one "name=value"; `subject` is what an undotted name belongs to. Plain numbers are in SI units, as
/// `list --json` and presets have them; "30deg" and "12mm" name their own.
void applySet(const Museum&, SceneState&, std::size_t subject, const std::string& assignment,
              std::vector<std::string>& notes);

/// A row and whose it is.
struct NamedRow {
    std::size_t owner, row;
};
/// The row "name", of the subject, or "exhibit.name". Throws Failure (Blame::usage) naming `option`.
[[nodiscard]] NamedRow namedRow(const Museum&, const SceneState&, std::size_t subject, const std::string& name,
                                const std::string& option);

/// Lets one row move, "name=motion" as `typedMotion` reads it. Throws Failure (Blame::usage) naming the option.
void applyMotion(const Museum&, SceneState&, std::size_t subject, const std::string& assignment);

/// The value that someone typed on the command line, where a number is in SI units unless it names its own; nothing
/// when the text means none.
[[nodiscard]] std::optional<Value> optionValue(const ParameterInfo&, const std::string& text);
/// "a number from 0 to 1", "one of none, hard": after "give ". Numbers are in the unit in which `typed` was given: SI
/// for a plain one, else that in which the row is shown.
[[nodiscard]] std::string whatItTakes(const ParameterInfo&, const std::string& typed = {});

/// What a picture's file name ends in says how it is written. Throws Failure (Blame::usage) naming the option.
[[nodiscard]] render::PictureFormat pictureFormat(const std::string& option, const std::string& file, bool sixteenBit);

/// "1.5,2,0" to three finite numbers, plain ones in `unit`. Throws Failure (Blame::usage) naming the option.
[[nodiscard]] glm::dvec3 parseTriple(const std::string& option, const std::string& text, Unit unit = Unit::none);
/// "640x360" to two positive numbers. `what` is what they are of, and `such` an example.
[[nodiscard]] glm::ivec2 parseSize(const std::string& option, const std::string& text,
                                   const std::string& what = "width x height in whole pixels",
                                   const std::string& such = "640x360");

}  // namespace vitrine::app

#pragma once

#include "exhibits/framework/files/preset.h"
#include "exhibits/museum/picture.h"

#include <string>

namespace vitrine {

/// Returns how `request` takes a picture. It includes the request's own camera if that differs from the one of the
/// exhibition: if the exhibit is shown alone, where its own space is the world, or if the view was widened.
[[nodiscard]] PictureRecord pictureRecord(const PictureRequest&, const render::Camera& ofExhibition);

/// Aspect ratio (width / height) for which the exhibits' best views are made.
inline constexpr double keptAspect = 1.5;

/// Returns the camera for a picture of this aspect ratio (width / height). Below `keptAspect` the field of view grows,
/// so that the picture shows as much from left to right as one of that ratio does.
[[nodiscard]] render::Camera widened(const render::Camera&, double aspect);

/// Returns the samples per pixel of a picture if nothing else gives them: the hall's supersamples if they are set,
/// or 4.
[[nodiscard]] int usualSamples(const ParameterValues& hall);

/// Returns the settings stored in a picture file: all parameters of the exhibition, and how the picture was taken.
/// `subject` is the selected exhibit, or the hall. `view` is the exhibition's camera, in world space; null: the
/// request's.
[[nodiscard]] std::string pictureSettings(const Museum&, std::size_t subject, const SceneState&, const PictureRequest&,
                                          const std::string& name, const render::Camera* view = nullptr);

}  // namespace vitrine

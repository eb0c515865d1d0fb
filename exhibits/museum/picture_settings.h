#pragma once

#include "exhibits/framework/files/preset.h"
#include "exhibits/museum/picture.h"

#include <string>

namespace vitrine {

/// Returns how `request` takes a picture. It includes the request's own camera if that differs from the one of the
/// exhibition: if the exhibit is shown alone, where its own space is the world, or if the view was widened.
[[nodiscard]] PictureRecord pictureRecord(const PictureRequest&, const render::Camera& ofExhibition);

/// Returns the samples per pixel of a picture if nothing else gives them: the hall's supersamples if they are set,
/// or 4.
[[nodiscard]] int usualSamples(const ParameterValues& hall);

/// Returns the settings stored in a picture file: all parameters of the exhibition, and how the picture was taken.
/// `subject` is the selected exhibit, or the hall. `view` is the exhibition's camera, in world space; null: the
/// request's.
[[nodiscard]] std::string pictureSettings(const Museum&, std::size_t subject, const SceneState&, const PictureRequest&,
                                          const std::string& name, const render::Camera* view = nullptr);

}  // namespace vitrine

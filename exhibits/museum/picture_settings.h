#pragma once

#include "exhibits/framework/preset.h"
#include "exhibits/museum/picture.h"

#include <string>

namespace vitrine {

/// How `request` takes a picture. Its own camera is part of that where it is not the one that the picture's exhibition
/// has: alone, where the exhibit's own space is the world, and where it was widened.
[[nodiscard]] PictureRecord pictureRecord(const PictureRequest&, const render::Camera& ofExhibition);

/// The settings that a picture file carries: an exhibition with everything that can be set, and how it was taken.
/// `subject` is the exhibit that was chosen, or the hall. `view` is the exhibition's camera, in the world: the
/// request's own, unless given.
[[nodiscard]] std::string pictureSettings(const Museum&, std::size_t subject, const SceneState&, const PictureRequest&,
                                          const std::string& name, const render::Camera* view = nullptr);

}  // namespace vitrine

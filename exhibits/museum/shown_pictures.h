#pragma once

#include "exhibits/framework/scene/frame_request.h"
#include "exhibits/framework/scene/shows_pictures.h"
#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Pictures of the hall and of exhibits that another exhibit shows (`ShowsPictures`).
namespace vitrine {

class Museum;

/// Tells the exhibits that show pictures which sources there are: the hall, and all other exhibits.
void offerPictures(const std::vector<std::unique_ptr<Exhibit>>&);

/// Returns the request of the picture of a source that exhibit `by` shows within the picture of `request`: one sample
/// per pixel, the same time. An exhibit is shown alone at its best view. `hallFromHere` has the camera of `request`, in
/// the hall; `hallFromScreen` looks out of the place of `by`. Returns nothing if there is no such source.
[[nodiscard]] std::optional<FrameRequest> requestOfPicture(const Museum&, const SceneState&,
                                                           const FrameRequest& request, std::size_t by,
                                                           const std::string& source);

}  // namespace vitrine

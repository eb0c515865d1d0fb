#pragma once

#include "exhibits/framework/scene/prepare.h"
#include "exhibits/museum/scene_state.h"

#include <memory>
#include <vector>

namespace vitrine::hall {
struct PreparedHall;
}

namespace vitrine {

/// Prepared data of one exhibit.
struct PreparedExhibit {
    bool seen = false, shadowSeen = false;  ///< Uses that `part` was prepared for.
    std::shared_ptr<const PreparedPart> part;
};

/// Everything needed to plan a frame (files, meshes, simulation state), resolved for one time. Immutable; owned by the
/// caller; keeps its data alive. Made by Museum::prepare.
struct Prepared {
    SceneState sceneState;             ///< State at this time: `Museum::atMoment`.
    double time = 0;                   ///< Seconds.
    std::vector<double> sincePressed;  ///< See FrameRequest.
    std::shared_ptr<const hall::PreparedHall> hall;
    std::vector<PreparedExhibit> exhibits;  ///< By subject; the hall's entry is empty.
    /// Assets still loading, which are left out. Filled only if `FrameRequest::nonBlocking`.
    std::vector<render::PendingAsset> pending;

    /// Returns the errors of files that it needs and cannot read: full sentences.
    [[nodiscard]] std::vector<Message> unreadableFiles() const;
    /// Returns the seconds since the button of subject `i` was pressed; infinity: never.
    [[nodiscard]] double sincePress(std::size_t i) const;
    [[nodiscard]] ExhibitState state(std::size_t i) const;
};

}  // namespace vitrine

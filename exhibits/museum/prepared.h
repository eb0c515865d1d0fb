#pragma once

#include "exhibits/framework/prepare.h"
#include "exhibits/museum/scene_state.h"

#include <memory>
#include <vector>

namespace vitrine {

struct PreparedHall;

/// One exhibit's share of a prepared picture.
struct PreparedExhibit {
    bool seen = false, shadowSeen = false;  ///< What `part` was prepared for.
    std::shared_ptr<const PreparedPart> part;
};

/// A look at one moment with everything resolved that it takes to plan pictures of it: whoever draws owns what it
/// prepared. Holds what it names: nothing in it changes or goes while it lives. Made by Museum::prepare.
struct Prepared {
    SceneState sceneState;             ///< At this moment: `Museum::atMoment`.
    double time = 0;                   ///< Seconds.
    std::vector<double> sincePressed;  ///< As in FrameRequest.
    std::shared_ptr<const PreparedHall> hall;
    std::vector<PreparedExhibit> exhibits;  ///< By subject; that of the hall stays empty.
    /// What was not there without waiting, and is left out: only of `FrameRequest::waitless`.
    std::vector<render::PendingAsset> pending;

    /// Which files it needs and cannot read, and why: full sentences.
    [[nodiscard]] std::vector<std::string> unreadableFiles() const;
    /// Seconds since the button of subject `i` was pressed; infinity: never.
    [[nodiscard]] double sincePress(std::size_t i) const;
    [[nodiscard]] ExhibitState state(std::size_t i) const;
};

}  // namespace vitrine

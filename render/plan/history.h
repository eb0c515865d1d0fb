#pragma once

#include "render/plan/image_info.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render {

/// Something that what was accumulated depends on: another hash than in the last frame, and it is of no use because ...
struct HistoryDependency {
    std::string whyLost;  ///< "a value changed", "another model was loaded".
    std::uint64_t hash = 0;
};

/// An image whose content of the last frame passes may read (`previous(name)`) while they write that of this frame.
struct History {
    ImageInfo image;
    std::vector<HistoryDependency> dependencies = {};
    /// A camera that moved farther, turned farther or whose clock ran farther than this since the last frame is
    /// somewhere else. Less than that is for the pass to reproject. Infinite: it does not matter.
    double cutMeters = 1;
    double cutRadians = 0.5;
    double cutSeconds = 1;
    std::optional<View> view = {};  ///< Of the passes that draw it, where it is not the plan's.
};

/// The name under which a pass reads the last frame's content of a history image.
[[nodiscard]] std::string previous(const std::string& image);

/// What is remembered of the frame that last wrote a history image.
struct HistoryRecord {
    ImageInfo image;
    View view;
    double time = 0;
    std::vector<HistoryDependency> dependencies;
};

/// Whether what the last frame left can be used in this one.
struct HistoryState {
    History history;
    bool valid = false;
    std::string reset;  ///< Why not: "the camera jumped"; empty when valid.
    View lastView;      ///< Of the frame before; this one's when not valid.
};

/// `last` is null when there was none. `cut`: whoever moves the camera says that this frame has nothing to do with the
/// last.
[[nodiscard]] HistoryState historyState(const History&, const View& now, double time, bool cut,
                                        const HistoryRecord* last);

/// How far a pass that takes several frames has come.
struct PartProgress {
    std::uint64_t hash = 0;
    int done = 0;
    bool completedOnce = false;  ///< Its outputs hold a whole result: of this hash, or of the one before.
};

/// What a renderer's persistent images and buffers hold, for the next plan.
struct PersistentState {
    std::map<std::string, std::uint64_t> passes = {};  ///< Pass -> key under which it last wrote its persistent images.
    std::map<std::string, HistoryRecord> histories = {};  ///< By image.
    std::map<std::string, PartProgress> parts = {};       ///< By pass.
};

}  // namespace vitrine::render

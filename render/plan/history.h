#pragma once

#include "render/plan/image_info.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::render {

/// State that the accumulated content depends on. When the hash differs from the last frame's, the history is discarded
/// for the reason `whyLost`.
struct HistoryDependency {
    std::string whyLost;  ///< "a value changed", "another model was loaded".
    std::uint64_t hash = 0;
};

/// An image whose content persists to the next frame: passes read the last frame's content (`previous(name)`) while
/// they write this frame's.
struct History {
    ImageInfo image;
    std::vector<HistoryDependency> dependencies = {};
    /// Limits of camera movement, rotation and elapsed time since the last frame; beyond any of them the history is
    /// discarded. The pass reprojects smaller changes. Infinite: no limit.
    double cutMeters = 1;
    double cutRadians = 0.5;
    double cutSeconds = 1;
    std::optional<View> view = {};  ///< View of the passes that draw it. Unset: the plan's view.
};

/// The name under which a pass reads the last frame's content of a history image.
[[nodiscard]] std::string previous(const std::string& image);

/// Record of the frame that last wrote a history image.
struct HistoryRecord {
    ImageInfo image;
    View view;
    double time = 0;
    std::vector<HistoryDependency> dependencies;
};

/// Says whether the last frame's content of a history can be used in this frame.
struct HistoryState {
    History history;
    bool valid = false;
    std::string reset;  ///< Reason why it is not valid: "the camera jumped"; empty when valid.
    View lastView;      ///< View of the last frame; this frame's view when not valid.
};

/// Compares a history with its record. `last` is null if there is none. `resetHistory`: this frame does not continue
/// the last one, so the history is discarded.
[[nodiscard]] HistoryState historyState(const History&, const View& now, double time, bool resetHistory,
                                        const HistoryRecord* last);

/// Progress of a sliced pass, which takes several frames.
struct SliceProgress {
    std::uint64_t hash = 0;
    int done = 0;
    bool completedOnce = false;  ///< Its outputs hold a complete result, of this hash or of the one before.
};

/// Content of a renderer's persistent images and buffers, as the next plan needs it.
struct PersistentState {
    std::map<std::string, std::uint64_t> passes = {};  ///< Pass -> key under which it last wrote its persistent images.
    std::map<std::string, HistoryRecord> histories = {};  ///< By image name.
    std::map<std::string, SliceProgress> slices = {};     ///< By pass name.
    std::set<std::uint64_t> stopped =
        {};  ///< Pass::unbounded of the passes that were stopped because they took too long.
};

}  // namespace vitrine::render

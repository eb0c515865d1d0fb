#pragma once

#include "app/study/cost_switch.h"
#include "exhibits/study/study_costs.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vitrine::app {

/// Point of a study on the page.
struct StudyPagePoint {
    std::string text;
    bool hasPictures = false;  ///< The files pictures/point-N-view-V.png and its -heat.png exist.
};

/// Chart of the page for one cost axis.
struct StudyPageChart {
    study::CostAxis axis = study::CostAxis::time;
    std::string svg;
    /// Position of each point in pixels from the top left; unset: not in the chart.
    std::vector<std::optional<glm::dvec2>> places;
    PageCost cost;
};

/// Returns an HTML page with chart, pictures, heat maps and numbers, a wipe against the reference, and a button for
/// each cost axis. It needs the folder pictures/ beside it, and no network.
[[nodiscard]] std::string studyPage(Subjects, const study::StudyRequest&, const study::StudyResult&,
                                    const std::vector<StudyPageChart>&, glm::ivec2 chartSize,
                                    const std::vector<StudyPagePoint>&);

}  // namespace vitrine::app

#pragma once

#include "app/study/cost_switch.h"
#include "exhibits/study/study_costs.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vitrine::app {

/// A point as the page shows it.
struct StudyPagePoint {
    std::string text;
    bool hasPictures = false;  ///< pictures/point-N-view-V.png and its -heat.png are there.
};

/// A chart of the page over one axis of costs.
struct StudyPageChart {
    CostAxis axis = CostAxis::time;
    std::string svg;
    std::vector<std::optional<glm::dvec2>> places;  ///< Of each point, pixels from the top left; unset: not in it.
    PageCost cost;
};

/// One page of HTML that shows chart, pictures, heat maps and numbers together, with a wipe against the reference, and
/// a button for each axis of costs.
/// It needs the folder pictures/ beside it, and no network.
[[nodiscard]] std::string studyPage(Subjects, const StudyRequest&, const StudyResult&,
                                    const std::vector<StudyPageChart>&, glm::ivec2 chartSize,
                                    const std::vector<StudyPagePoint>&);

}  // namespace vitrine::app

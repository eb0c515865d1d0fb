#pragma once

#include "exhibits/study/study_result.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine::app {

/// A point as the page shows it.
struct StudyPagePoint {
    std::string text;
    bool hasPictures = false;  ///< pictures/point-N-view-V.png and its -heat.png are there.
    glm::dvec2 place{0};       ///< In the chart, pixels from the top left.
};

/// One page of HTML that shows chart, pictures, heat maps and numbers together, with a wipe against the reference.
/// It needs the folder pictures/ beside it, and no network.
[[nodiscard]] std::string studyPage(Subjects, const StudyRequest&, const StudyResult&, const std::string& chartSvg,
                                    glm::ivec2 chartSize, const std::vector<StudyPagePoint>&);

}  // namespace vitrine::app

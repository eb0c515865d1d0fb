#pragma once

#include "exhibits/study/study_result.h"

#include <optional>

namespace vitrine {

/// The pictures of a study in one image of linear light: a column for each view, in the first row the references, then
/// a row for each point. What was not drawn is black.
struct ContactSheet {
    render::Image image;  ///< 3 channels; empty: there are no pictures.
    glm::ivec2 size{0};   ///< Of each picture, pixels.
    std::size_t views = 0;
    std::size_t points = 0;

    [[nodiscard]] bool empty() const { return image.empty(); }
    [[nodiscard]] render::Image reference(std::size_t view) const;
    [[nodiscard]] render::Image picture(std::size_t point, std::size_t view) const;

    /// Pixels of all of the sheet.
    [[nodiscard]] glm::ivec2 extent() const;
};

/// Empty where there is no reference yet, or where its pictures would be too many for one image that can be read again
/// (`render::ImageLimits`).
[[nodiscard]] ContactSheet contactSheet(const StudyResult&);

}  // namespace vitrine

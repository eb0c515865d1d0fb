#pragma once

#include "exhibits/study/study_result.h"

#include <optional>

namespace vitrine::study {

/// All pictures of a study in one image of linear light: a column per view, the references in the first row, then a row
/// per point. Missing pictures are black.
struct ContactSheet {
    render::Image image;  ///< 3 channels; empty if there are no pictures.
    glm::ivec2 size{0};   ///< Size of each picture, pixels.
    std::size_t views = 0;
    std::size_t points = 0;

    [[nodiscard]] bool empty() const { return image.empty(); }
    [[nodiscard]] render::Image reference(std::size_t view) const;
    [[nodiscard]] render::Image picture(std::size_t point, std::size_t view) const;

    /// Returns the size of the whole sheet in pixels.
    [[nodiscard]] glm::ivec2 extent() const;
};

/// Returns the sheet of a study. It is empty if there is no reference yet, or if the sheet would be too large to be
/// read again (`render::ImageLimits`).
[[nodiscard]] ContactSheet contactSheet(const StudyResult&);

}  // namespace vitrine::study

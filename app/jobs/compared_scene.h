#pragma once

#include "app/kit/picture_options.h"
#include "exhibits/jobs/kit/job.h"
#include "exhibits/jobs/kit/job_document.h"

#include <array>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Adds the options that name the settings A and B, and those of the camera that shows both.
void addComparedOptions(CLI::App&, PictureOptions&, std::array<std::string, 2>& settings);

/// Settings from which a comparison starts.
struct ComparedStart {
    const SceneState* state = nullptr;        ///< Settings A if none are named; null: some must be.
    const jobs::JobDocument* like = nullptr;  ///< Document of an earlier comparison; null: there is none.
    bool offered = false;                     ///< B is a comparison that the exhibit of A offers.
};

/// Returns A as the scene of a job, and B as its other settings; no B if it is an offered comparison. Adds sentences on
/// corrected values to `notes`. Throws Failure (ErrorKind::usage), and those of reading presets.
[[nodiscard]] jobs::JobScene comparedScene(const CLI::App&, const Museum&, const PictureOptions&,
                                           const std::array<std::string, 2>& settings, const ComparedStart&,
                                           std::vector<std::string>& notes);

}  // namespace vitrine::app

#pragma once

#include "exhibits/study/study.h"
#include "exhibits/study/study_costs.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::app {

/// Throws Failure (Blame::usage) when the folder is there and holds anything but a study.
void requireStudyFolder(const std::filesystem::path&);

/// The axis of costs that a study's own chart has: as asked for, else time, if its clock can be trusted or no count of
/// work tells its settings apart.
[[nodiscard]] CostAxis chartCosts(const StudyResult&, std::optional<CostAxis> asked);

/// Writes study.json, study.csv, chart.svg, chart.png, pictures, heat maps and index.html, and `presetText` as
/// preset.json when it is not empty. All of it is written beside the folder first, which is then replaced: it holds
/// all of the old study or all of the new. `machine` goes into the file as it is. `costs` is the axis of chart.svg and
/// chart.png; the page shows both. Throws Failure (Blame::file).
void writeStudyFolder(const std::filesystem::path&, Subjects, const Study&, const render::Json& machine,
                      const std::string& presetText, CostAxis costs);

}  // namespace vitrine::app

#pragma once

#include "exhibits/study/study.h"
#include "exhibits/study/study_costs.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::app {

/// Throws Failure (Blame::usage) if the folder exists and contains anything but a study.
void requireStudyFolder(const std::filesystem::path&);

/// Returns the cost axis of a study's chart: the requested one, else time, if its clock is exact enough or no count of
/// work distinguishes the settings.
[[nodiscard]] CostAxis chartCosts(const StudyResult&, std::optional<CostAxis> asked);

/// Writes study.json, study.csv, chart.svg, chart.png, pictures, heat maps and index.html, and `presetText`, if not
/// empty, as preset.json. All files are written beside the folder first, which is then replaced, so that it has all of
/// the old study or all of the new. `machine` is written unchanged. `costs` is the axis of chart.svg and chart.png; the
/// page shows both axes. Throws Failure (Blame::file).
void writeStudyFolder(const std::filesystem::path&, Subjects, const Study&, const render::Json& machine,
                      const std::string& presetText, CostAxis costs);

}  // namespace vitrine::app

#pragma once

#include "exhibits/study/study.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <string>

namespace vitrine::app {

/// Throws Failure (Blame::usage) when the folder is there and holds anything but a study.
void requireStudyFolder(const std::filesystem::path&);

/// Writes study.json, study.csv, chart.svg, chart.png, pictures, heat maps and index.html, and `presetText` as
/// preset.json when it is not empty. All of it is written beside the folder first, which is then replaced: it holds
/// all of the old study or all of the new. `machine` goes into the file as it is. Throws Failure (Blame::file).
void writeStudyFolder(const std::filesystem::path&, Subjects, const Study&, const render::Json& machine,
                      const std::string& presetText);

}  // namespace vitrine::app

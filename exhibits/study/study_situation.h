#pragma once

#include "exhibits/framework/table/studied_parameters.h"
#include "exhibits/study/study_result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::study {

/// Settings and views of a study in which its parameters have an effect.
struct StudySituation {
    SceneState sceneState;              ///< The request's, changed so that parameters have an effect.
    std::vector<StudyChange> changes;   ///< Changed settings, and the reasons.
    std::vector<StudyParameter> exact;  ///< Parameters with their most exact value in the reference only.
    std::vector<StudyView> views;       ///< Views of the request's subject; never empty.
};

/// Finds the situation of a study from the conditions of its parameters (`ParameterInfo::actsWhen`) and from what
/// tables declare about them (`StudiedParameter`). Studied and pinned parameters keep their values.
[[nodiscard]] StudySituation studySituation(Subjects, const StudyRequest&);

/// Returns whether a study leaves all settings unchanged. It does on request, or if it looks for the best setting of
/// this scene state (over three parameters or more, or within a limit).
[[nodiscard]] bool keepsSettings(const StudyRequest&);

/// Returns what the table declares of an axis's parameter.
[[nodiscard]] StudiedParameter declaredOf(const SceneState&, const StudyAxis&);

/// Form of parameter names in sentences.
enum class ParameterNames : std::uint8_t {
    typed,  ///< As on the command line: "levelOfDetail".
    shown   ///< As in the interface: "Level of detail".
};

/// Returns each change as a sentence: "Studied with “levelOfDetail” at off instead of on, which would limit
/// “shellCount”." Further sentences name parameters that limit another one and were not changed, and parameters that
/// are exact in the reference only.
[[nodiscard]] std::vector<std::string> situationSentences(Subjects, const StudyRequest&, const StudyResult&,
                                                          ParameterNames = ParameterNames::typed);

/// Returns all settings that differ from the initial ones, in the form of `--set`: "levelOfDetail=off",
/// "hall.sunStrength=2". A study with these settings measures the same.
[[nodiscard]] std::vector<std::string> settingsToRepeat(Subjects, const StudyRequest&, const StudyResult&);

}  // namespace vitrine::study

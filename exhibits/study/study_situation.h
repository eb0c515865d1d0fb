#pragma once

#include "exhibits/framework/studied_rows.h"
#include "exhibits/study/study_result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine {

/// Where a study measures: the settings and the views in which its parameters show.
struct StudySituation {
    SceneState sceneState;             ///< The request's, changed where its parameters would not show.
    std::vector<StudyChange> changes;  ///< What was changed, and why.
    std::vector<StudyRow> exact;       ///< Rows with their most exact value in the reference only.
    std::vector<StudyView> views;      ///< Of the request's subject; never empty.
};

/// Finds the situation of a study from the tables: from the conditions of its parameters (`ParameterInfo::actsWhen`)
/// and from what is declared beside them (`StudiedRow`). Rows that are studied or pinned keep their values.
[[nodiscard]] StudySituation studySituation(Subjects, const StudyRequest&);

/// Whether a study leaves all settings as they are: because it was asked to, or because it looks for the best setting
/// of this very scene state (over three parameters or more, or within a limit).
[[nodiscard]] bool keepsSettings(const StudyRequest&);

/// Returns what the table declares of an axis's parameter.
[[nodiscard]] StudiedRow declaredOf(const SceneState&, const StudyAxis&);

/// How sentences name parameters.
enum class RowNames : std::uint8_t {
    typed,  ///< As a command line takes them: "levelOfDetail".
    shown   ///< As the interface shows them: "Level of detail".
};

/// Each change as a sentence: "Studied with “levelOfDetail” at off instead of on, which would limit “shellCount”."
/// Further sentences name rows that limit a parameter and stay as they were set, and rows that are exact in the
/// reference only.
[[nodiscard]] std::vector<std::string> situationSentences(Subjects, const StudyRequest&, const StudyResult&,
                                                          RowNames = RowNames::typed);

/// All settings that differ from the initial ones, as `--set` takes them: "levelOfDetail=off", "hall.sunStrength=2".
/// The same study with them measures the same.
[[nodiscard]] std::vector<std::string> settingsToRepeat(Subjects, const StudyRequest&, const StudyResult&);

}  // namespace vitrine

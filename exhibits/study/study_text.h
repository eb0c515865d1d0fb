#pragma once

#include "exhibits/study/study_costs.h"
#include "exhibits/study/study_result.h"
#include "render/files/strict_json.h"

#include <string>
#include <vector>

namespace vitrine {

/// "steps 64" or "steps 64, method fair": a point's values by the names that a command line takes; of more than two
/// parameters, those that differ from the present ones.
[[nodiscard]] std::string pointText(Subjects, const StudyRequest&, const StudyPoint&);

/// The same values by the labels of the interface, in pieces, so that each can be translated. None: as at present.
[[nodiscard]] std::vector<SettingPart> settingParts(Subjects, const StudyRequest&, const StudyPoint&);
/// The same as text: "Steps 64, Method fair".
[[nodiscard]] std::string settingText(const std::vector<SettingPart>&);
/// Labels of the parameters that a study varies: "Steps, Method".
[[nodiscard]] std::string axisLabels(Subjects, const StudyRequest&);

/// What the cost is counted in: "field evaluations", "milliseconds", or the counter's own name.
[[nodiscard]] std::string costTitle(const std::string& costName);

/// "Halving the error costs 1.9 times the evaluations (1.7 to 2.2 with 95 % confidence)." Says that more points are
/// needed where the ends of the interval are more than a factor of 4 apart. Empty without a law.
[[nodiscard]] std::string lawSentence(const StudyCosts&);
/// The same by the cost that the study's own front goes by.
[[nodiscard]] std::string lawSentence(const StudyResult&);

/// What was chosen and whether it held, with its numbers; or that nothing keeps the limit. Empty when no limit was set,
/// and until everything is measured.
[[nodiscard]] std::string choiceSentence(Subjects, const StudyRequest&, const StudyResult&);

/// Everything that was measured but the pictures; `machine` is put beside it as it is.
[[nodiscard]] render::Json studyJson(Subjects, const StudyRequest&, const StudyResult&, render::Json machine);

/// One line per point and view, with every metric and counter that any of them has; times are medians of the runs.
[[nodiscard]] std::string studyCsv(Subjects, const StudyRequest&, const StudyResult&);

}  // namespace vitrine

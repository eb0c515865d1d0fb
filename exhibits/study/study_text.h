#pragma once

#include "exhibits/study/study_result.h"
#include "render/files/strict_json.h"

#include <string>

namespace vitrine {

/// "steps 64" or "steps 64, method fair": a point's values for people; of more than two parameters, those that differ
/// from the present ones.
[[nodiscard]] std::string pointText(Subjects, const StudyRequest&, const StudyPoint&);

/// What the cost is counted in: "field evaluations", "milliseconds", or the counter's own name.
[[nodiscard]] std::string costTitle(const std::string& costName);

/// "Halving the error costs 1.9 times the evaluations (1.7 to 2.2 with 95 % confidence)."; empty without a law.
[[nodiscard]] std::string lawSentence(const StudyResult&);

/// What was chosen and whether it held, with its numbers; or that nothing keeps the limit. Empty when no limit was set,
/// and until everything is measured.
[[nodiscard]] std::string choiceSentence(Subjects, const StudyRequest&, const StudyResult&);

/// Everything that was measured but the pictures; `machine` is put beside it as it is.
[[nodiscard]] render::Json studyJson(Subjects, const StudyRequest&, const StudyResult&, render::Json machine);

/// One line per point and view, with every metric and counter that any of them has; times are medians of the runs.
[[nodiscard]] std::string studyCsv(Subjects, const StudyRequest&, const StudyResult&);

}  // namespace vitrine

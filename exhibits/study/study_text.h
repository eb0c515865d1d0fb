#pragma once

#include "exhibits/study/study_costs.h"
#include "exhibits/study/study_result.h"
#include "render/files/strict_json.h"

#include <string>
#include <vector>

namespace vitrine::study {

/// Returns a point's values by the names on the command line: "steps 64" or "steps 64, method fair". With more than two
/// parameters, only values that differ from the present ones.
[[nodiscard]] std::string pointText(Subjects, const StudyRequest&, const StudyPoint&);

/// Returns the same values by the labels of the interface, in parts that can be translated. Empty: all at present
/// values.
[[nodiscard]] std::vector<SettingPart> settingParts(Subjects, const StudyRequest&, const StudyPoint&);
/// Returns the parts as text: "Steps 64, Method fair".
[[nodiscard]] std::string settingText(const std::vector<SettingPart>&);
/// Returns labels of the varied parameters: "Steps, Method".
[[nodiscard]] std::string axisLabels(Subjects, const StudyRequest&);

/// Returns the title of a cost: "field evaluations", "milliseconds", or the counter's own name.
[[nodiscard]] std::string costTitle(const std::string& costName);

/// Returns a sentence on the law: "Halving the error costs 1.9 times the evaluations (1.7 to 2.2 with 95 %
/// confidence)." If the ends of the interval differ by more than a factor of 4, it says that more points are needed.
/// Empty without a law.
[[nodiscard]] std::string lawSentence(const StudyCosts&);
/// The same with the cost of the study's own front.
[[nodiscard]] std::string lawSentence(const StudyResult&);

/// Returns the choice, its numbers, and whether it keeps the limit, or that no setting does. Empty without a limit, and
/// until everything is measured.
[[nodiscard]] std::string choiceSentence(Subjects, const StudyRequest&, const StudyResult&);

/// Returns everything that was measured except the pictures. `machine` is added unchanged.
[[nodiscard]] render::Json studyJson(Subjects, const StudyRequest&, const StudyResult&, render::Json machine);

/// Returns CSV with one line per point and view, and every metric and counter that any of them has. Times are medians
/// of the runs.
[[nodiscard]] std::string studyCsv(Subjects, const StudyRequest&, const StudyResult&);

}  // namespace vitrine::study

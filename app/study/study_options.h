#pragma once

#include "app/queue/shard.h"
#include "exhibits/study/study_costs.h"
#include "render/measure/flip.h"
#include "render/measure/metrics.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Returns the cost axis "ms" or "work"; nullopt for an empty name. Throws Failure (Blame::usage) naming both.
[[nodiscard]] std::optional<CostAxis> costAxisOption(const std::string& name);

/// Returns the metric of this name. Throws Failure (Blame::usage) naming the option and all metrics.
[[nodiscard]] render::Metric metricOption(const std::string& option, const std::string& name, bool ofStudy = false);
/// Returns the names of the metrics; `ofStudy`: only those that are 0 for equal pictures.
[[nodiscard]] std::string metricNames(bool ofStudy = false);

/// Options of `study`, as typed.
struct StudyOptions {
    std::string subject;
    std::vector<std::string> parameters;
    std::string values;  ///< Values of the one parameter: "16,64,256".
    int points = 0;      ///< 0: the number of `usualPoints`.
    int views = 3;
    std::string size = "320x180";
    std::string metric = "rmse";
    int runs = 7;
    int settings = 60;
    double pixelsPerDegree = render::flipPixelsPerDegree;
    std::string preset;
    std::vector<std::string> sets;
    bool alone = false;
    bool noModelError = false;
    bool asSet = false;
    std::string cost;  ///< Cost axis, "ms" or "work"; empty: depends on whether the clock is exact enough.
    std::optional<double> maxError, maxMilliseconds;
    std::string out;
    PartOptions part;
};

void addStudyOptions(CLI::App&, StudyOptions&);

/// Returns the study that the options describe. `notes` gets sentences on corrected values. Throws Failure
/// (Blame::usage) naming the option or parameter and what to give.
[[nodiscard]] StudyRequest studyRequest(const Museum&, const StudyOptions&, std::vector<std::string>& notes);
/// The same with another scene state than the initial one.
[[nodiscard]] StudyRequest studyRequest(const Museum&, const StudyOptions&, SceneState,
                                        std::vector<std::string>& notes);

}  // namespace vitrine::app

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

/// The axis of that name, "ms" or "work"; nothing for an empty one. Throws Failure (Blame::usage) naming both.
[[nodiscard]] std::optional<CostAxis> costAxisOption(const std::string& name);

/// The metric of that name. Throws Failure (Blame::usage) naming the option and all metrics.
[[nodiscard]] render::Metric metricOption(const std::string& option, const std::string& name, bool ofStudy = false);
/// Names of the metrics; of a study's those that fall to 0.
[[nodiscard]] std::string metricNames(bool ofStudy = false);

/// What `study` can be told, as typed.
struct StudyOptions {
    std::string subject;
    std::vector<std::string> parameters;
    std::string values;  ///< "16,64,256", for one parameter.
    int points = 0;      ///< 0: as many as `usualPoints` says.
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
    std::string cost;  ///< "ms" or "work"; empty: by whether the clock can be trusted.
    std::optional<double> maxError, maxMilliseconds;
    std::string out;
    PartOptions part;
};

void addStudyOptions(CLI::App&, StudyOptions&);

/// The study that the options ask for; `notes` gets what was brought to the nearest legal value. Throws Failure
/// (Blame::usage) naming the option or parameter and what to give.
[[nodiscard]] StudyRequest studyRequest(const Museum&, const StudyOptions&, std::vector<std::string>& notes);
/// The same from this look in place of the initial one.
[[nodiscard]] StudyRequest studyRequest(const Museum&, const StudyOptions&, SceneState,
                                        std::vector<std::string>& notes);

}  // namespace vitrine::app

#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/study/study_costs.h"
#include "exhibits/study/study_result.h"
#include "render/measure/flip.h"

namespace vitrine::study {

/// Setting that a study looks for among those that it measures.
enum class StudyFind : int { nothing, cheapest, best };
enum class ChartCost : int { automatic, ms, work };

/// Returns the names of the metrics of studies: all that are 0 for equal pictures.
[[nodiscard]] const std::vector<std::string>& studyMetrics();

/// Parameters of a study.
struct StudyTable final : Parameters {
    Group variedGroup = group("Varied");
    Text varied = text("parameters",
                       "Parameters to vary: one gives a curve, two a surface, none the best settings over all of "
                       "them. hall.supersamples and hall.resolutionScale are possible for every exhibit.",
                       several(), positional());
    Text values = text("values", "Values of the parameter if only one varies, separated by commas, such as 16,64,256.");
    Count points = count("points", 0, Range{2, 64}.soft(2, 17),
                         "Approximate number of values of each parameter. Auto: 8 for one parameter, 5 for two, 17 for "
                         "more.",
                         reads(0, "auto"));
    Count settings = count("settings", 60, Range{2, 10000, logarithmic}.soft(10, 500),
                           "Maximum number of settings to measure when three or more parameters vary.");

    Group pictureGroup = group("Pictures");
    Count views = count("views", 3, Range{1, 64}.soft(1, 8), "Number of the exhibit's views in which to measure.");
    Count width = count("width", 320, Range{1, 1000000, logarithmic}.soft(16, 1920), "Size of a picture in pixels.",
                        tuple("size", 'x'));
    Count height = count("height", 180, Range{1, 1000000, logarithmic}.soft(9, 1080), "Size of a picture in pixels.",
                         tuple("size", 'x'));
    Toggle alone = toggle(
        "alone", false,
        "Measure the exhibit without the hall, in the environment's light: quicker, but without sun and shadows.",
        labeled("Without the hall"));
    Toggle asSet =
        toggle("asSet", false, "Do not adjust other parameters or skip views to make the studied parameter visible.",
               labeled("Keep all settings"));

    Group measureGroup = group("Measurement");
    Choice<int> metric = choice("metric", 0, studyMetrics(), "Metric by which errors are measured.");
    Real pixelsPerDegree = real("pixelsPerDegree", render::flipPixelsPerDegree, none, Range{1, 1000}.soft(20, 100),
                                "Pixels per degree of the viewer's field of view, for the metric flip.");
    Toggle modelError = toggle(
        "modelError", true, "Compare with a second reference, too, in which all parameters are at their most exact.");
    Count runs =
        count("runs", 7, Range{1, 1000, logarithmic}.soft(1, 50),
              "Largest number of timed frames per setting and view. Six are taken where its times are far from "
              "all others.");

    Group findGroup = group("Choice");
    Choice<StudyFind> choosing = choice("find", StudyFind::nothing, {"nothing", "cheapest", "best"},
                                        "Setting to choose: the cheapest within an error, or the best within a time.",
                                        labeled("Setting to find"));
    Real maxError =
        real("maxError", 0.02, none, Range{0, 1e6}.soft(0, 1),
             "Largest error allowed in any view: the cheapest setting within it is chosen.", labeled("Largest error"),
             when(choosing, StudyFind::cheapest), implies(choosing, StudyFind::cheapest));
    Real maxMilliseconds = real(
        "maxMilliseconds", 10, none, Range{0, 1e9}.soft(0, 100),
        "Longest frame time allowed, in milliseconds: the most exact setting within it is chosen.",
        labeled("Longest time"), option("max-ms"), when(choosing, StudyFind::best), implies(choosing, StudyFind::best));
    Choice<ChartCost> cost = choice("cost", ChartCost::automatic, {"auto", "ms", "work"},
                                    "Cost in chart.svg and chart.png: ms (milliseconds per picture) or work (counted). "
                                    "Auto: ms if the clock is reliable. The page shows both.");
};

[[nodiscard]] const StudyTable& studyTable();

/// Returns the study that values of `StudyTable` describe. Throws Failure (ErrorKind::usage) naming what cannot be and
/// what to give.
[[nodiscard]] StudyRequest studyRequest(const ParameterValues&, const Museum&, SceneState, std::size_t subject);

/// Returns the cost axis of a study's chart: the one that is set, else time, if its clock is exact enough or no count
/// of work distinguishes the settings.
[[nodiscard]] CostAxis chartCosts(const ParameterValues&, const StudyResult&);

}  // namespace vitrine::study

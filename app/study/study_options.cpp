#include "app/study/study_options.h"

#include "app/kit/number_option.h"
#include "app/kit/picture_options.h"
#include "render/failure.h"
#include "render/measure/distance.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace vitrine::app {
namespace {

/// Returns the names of parameters that can be studied: "bounces, shadowRays, ...".
std::string qualityNames(const SceneState& sceneState, std::size_t exhibit)
{
    return joined(qualityAxes(sceneState, exhibit, 2), ", ",
                  [&](const StudyAxis& axis) { return rowOf(sceneState, axis).name; });
}

StudyAxis axisNamed(const Museum& museum, const SceneState& sceneState, std::size_t subject, const std::string& text,
                    int points)
{
    std::size_t exhibit = subject;
    std::string name = text;
    if (const std::size_t dot = text.find('.'); dot != std::string::npos) {
        const auto found = museum.find(text.substr(0, dot));
        if (!found || (*found != 0 && *found != subject))
            throw Failure(Blame::usage,
                          "study " + text +
                              ": a parameter is the exhibit's own or the hall's, as in hall.supersamples.");
        exhibit = *found;
        name = text.substr(dot + 1);
    }
    const auto row = sceneState.values[exhibit].table().find(name);
    const std::optional<StudyAxis> axis = row ? studyAxis(sceneState, exhibit, *row, points) : std::nullopt;
    if (!axis)
        throw Failure(Blame::usage,
                      "study " + text + ": " + std::string(museum.subject(exhibit).name()) +
                          (row ? " has it, but no value of it is more exact than another" : " has no such parameter") +
                          "; give one of " + qualityNames(sceneState, exhibit) + '.');
    return *axis;
}

void setValues(const SceneState& sceneState, StudyAxis& axis, const std::string& text)
{
    axis.values.clear();
    const ParameterInfo& row = rowOf(sceneState, axis);
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::optional<Value> value = optionValue(row, part);
        const std::optional<Value> legal = value ? nearestLegal(row, *value) : std::nullopt;
        if (!legal || *legal != *value)
            throw Failure(Blame::usage, "--values: \"" + part + "\" is no value for " + std::string(row.name) +
                                            "; give " + whatItTakes(row, part) + '.');
        axis.values.push_back(std::get<double>(*legal));
    }
    std::sort(axis.values.begin(), axis.values.end());
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    if (axis.values.empty())
        throw Failure(Blame::usage, "--values: give values separated by commas, such as --values 16,64,256.");
}

std::vector<std::string> namesOfMetrics(bool ofStudy)
{
    std::vector<std::string> names;
    for (const render::MetricInfo& metric : render::allMetrics())
        if (!ofStudy || !metric.falls) names.emplace_back(metric.name);
    return names;
}

}  // namespace

std::optional<CostAxis> costAxisOption(const std::string& name)
{
    if (name.empty()) return std::nullopt;
    if (name == "ms") return CostAxis::time;
    if (name == "work") return CostAxis::work;
    throw Failure(Blame::usage, "--cost \"" + name + "\" is no cost of a chart; give ms or work.");
}

std::string metricNames(bool ofStudy)
{
    return joined(namesOfMetrics(ofStudy));
}

render::Metric metricOption(const std::string& option, const std::string& name, bool ofStudy)
{
    if (const std::optional<render::Metric> metric = render::metricNamed(name)) return *metric;
    const std::vector<std::string> names = namesOfMetrics(ofStudy);
    throw Failure(Blame::usage, option + " \"" + name + "\" is no metric" + didYouMean(name, names) + " give one of " +
                                    joined(names) + '.');
}

void addStudyOptions(CLI::App& command, StudyOptions& o)
{
    command.add_option("exhibit", o.subject, "An exhibit's name, or hall")->required();
    command.add_option("parameters", o.parameters,
                       "Parameters to vary: one gives a curve, two a surface, none the best settings over all of them. "
                       "hall.supersamples and hall.resolutionScale are possible for every exhibit");
    command.add_option("--values", o.values, "Values of the parameter if only one varies, separated by commas");
    addNumber(command, "--points", o.points, {2, 64}, "Approximate number of values of each parameter");
    addNumber(command, "--views", o.views, {1, 64}, "Number of the exhibit's views in which to measure")
        ->capture_default_str();
    command.add_option("--size", o.size, "Width x height in pixels")->capture_default_str();
    command.add_option("--metric", o.metric, "Measure of the error: " + metricNames(true))->capture_default_str();
    addNumber(command, "--runs", o.runs, {1, 1000}, "Number of timed frames per setting and view")
        ->capture_default_str();
    addNumber(command, "--settings", o.settings, {2, 10000},
              "Maximum number of settings to measure when three or more parameters vary")
        ->capture_default_str();
    addNumber(command, "--pixels-per-degree", o.pixelsPerDegree, {1, 1000},
              "Pixels per degree of the viewer's field of view, for the metric flip")
        ->capture_default_str();
    command.add_option("--preset", o.preset, "Settings to start from: the name of a shipped preset, or a file");
    command.add_option("--set", o.sets, "Value of a parameter that does not vary, as name=value")
        ->take_all()
        ->allow_extra_args(true);
    command.add_flag(
        "--alone", o.alone,
        "Measure the exhibit without the hall, in the environment's light: quicker, but without sun and shadows");
    command.add_flag("--as-set", o.asSet,
                     "Do not adjust other parameters or skip views to make the studied parameter visible");
    command.add_flag("--no-model-error", o.noModelError,
                     "Skip the second reference, in which all parameters are at their most exact");
    CLI::Option* error = addNumber(command, "--max-error", o.maxError, {0, 1e6},
                                   "Largest error allowed in any view: choose the cheapest setting within it");
    addNumber(command, "--max-ms", o.maxMilliseconds, {0, 1e9},
              "Longest frame time allowed, in milliseconds: choose the most exact setting within it")
        ->excludes(error);
    command.add_option("--out", o.out, "Output folder for the study; an older study in it is replaced")->required();
}

StudyRequest studyRequest(const Museum& museum, const StudyOptions& options, std::vector<std::string>& notes)
{
    return studyRequest(museum, options, museum.initialSceneState(), notes);
}

StudyRequest studyRequest(const Museum& museum, const StudyOptions& options, SceneState start,
                          std::vector<std::string>& notes)
{
    PictureOptions picture;
    picture.subject = options.subject;
    picture.preset = options.preset;
    picture.settingsOnly = true;
    picture.sets = options.sets;
    picture.size = options.size;
    RequestedPicture job = requestedPicture(museum, picture, std::move(start), std::nullopt);
    notes = job.notes;

    StudyRequest request;
    request.subject = job.subject;
    request.sceneState = std::move(job.sceneState);
    request.size = job.request.frame.raster.size;
    request.views = options.views;
    request.runs = options.runs;
    request.metric = metricOption("--metric", options.metric, true);
    request.pixelsPerDegree = options.pixelsPerDegree;
    request.needsFiles = true;
    request.alone = options.alone && job.subject != hallIndex;
    request.modelError = !options.noModelError;
    request.asSet = options.asSet;
    for (const std::string& set : options.sets) {
        const NamedRow named = namedRow(museum, request.sceneState, job.subject, set.substr(0, set.find('=')), "--set");
        request.pinned.push_back({named.owner, named.row});
    }
    request.settings = options.settings;
    request.maxError = options.maxError;
    request.maxMilliseconds = options.maxMilliseconds;
    const bool one = options.parameters.size() == 1;
    const int points = options.points > 0 ? options.points : usualPoints(options.parameters.size());
    for (const std::string& name : options.parameters)
        request.axes.push_back(axisNamed(museum, request.sceneState, job.subject, name, points));
    for (std::size_t i = 0; i < request.axes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (request.axes[i].subject == request.axes[j].subject && request.axes[i].row == request.axes[j].row)
                throw Failure(Blame::usage,
                              "study " + options.parameters[i] + ": named twice; name each parameter once.");
    if (!options.values.empty()) {
        if (!one) throw Failure(Blame::usage, "--values: name exactly one parameter before it.");
        setValues(request.sceneState, request.axes.front(), options.values);
    }
    if (request.axes.empty()) request.axes = qualityAxes(request.sceneState, job.subject, options.points);
    if (request.axes.empty())
        throw Failure(
            Blame::usage,
            options.subject +
                " has no parameter on which accuracy depends; name one of the hall, such as hall.supersamples.");
    return request;
}

}  // namespace vitrine::app

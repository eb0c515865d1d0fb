#include "exhibits/study/study_table.h"

#include "exhibits/framework/table/typed_number.h"
#include "exhibits/study/study_axis.h"
#include "render/failure.h"
#include "render/measure/distance.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <sstream>

namespace vitrine::study {
namespace {

/// Returns the names of parameters that can be studied.
std::vector<std::string> qualityNames(const SceneState& sceneState, std::size_t exhibit)
{
    std::vector<std::string> names;
    for (const StudyAxis& axis : qualityAxes(sceneState, exhibit, 2))
        names.emplace_back(parameterOf(sceneState, axis).name);
    return names;
}

StudyAxis axisNamed(const Museum& museum, const SceneState& sceneState, std::size_t subject, const std::string& text,
                    int points)
{
    std::size_t exhibit = subject;
    std::string name = text;
    if (const std::size_t dot = text.find('.'); dot != std::string::npos) {
        const auto found = museum.find(text.substr(0, dot));
        if (!found || (*found != hallIndex && *found != subject))
            throw Failure(ErrorKind::usage,
                          "study " + text +
                              ": a parameter is the exhibit's own or the hall's, as in hall.supersamples.");
        exhibit = *found;
        name = text.substr(dot + 1);
    }
    const auto row = sceneState.values[exhibit].table().find(name);
    std::optional<StudyAxis> axis = row ? studyAxis(sceneState, exhibit, *row, points) : std::nullopt;
    if (!axis) {
        const std::vector<std::string> names = qualityNames(sceneState, exhibit);
        throw Failure(ErrorKind::usage,
                      "study " + text + ": " + std::string(museum.subject(exhibit).name()) +
                          (row ? std::string(" has it, but no value of it is more exact than another;")
                               : " has no such parameter" + didYouMean(name, names)) +
                          " give one of " + joined(names) + '.');
    }
    return std::move(*axis);
}

void setValues(const SceneState& sceneState, StudyAxis& axis, const std::string& text)
{
    axis.values.clear();
    const ParameterInfo& row = parameterOf(sceneState, axis);
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::optional<Value> value = optionValue(row, part);
        const std::optional<Value> legal = value ? nearestLegal(row, *value) : std::nullopt;
        if (!legal || *legal != *value)
            throw Failure(ErrorKind::usage, "--values: \"" + part + "\" is not a value for " + std::string(row.name) +
                                                "; give " + whatItTakes(row, part) + '.');
        axis.values.push_back(std::get<double>(*legal));
    }
    std::sort(axis.values.begin(), axis.values.end());
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    if (axis.values.empty())
        throw Failure(ErrorKind::usage, "--values: give values separated by commas, such as --values 16,64,256.");
}

/// Sets the axes of the request, whose subject and scene state are set.
void setAxes(const ParameterValues& values, const Museum& museum, StudyRequest& request)
{
    const StudyTable& t = studyTable();
    const std::vector<std::string> names = linesOf(values[t.varied]);
    const int points = values[t.points] > 0 ? values[t.points] : usualPoints(names.size());
    for (const std::string& name : names) {
        StudyAxis axis = axisNamed(museum, request.sceneState, request.subject, name, points);
        for (const StudyAxis& other : request.axes)
            if (axis.subject == other.subject && axis.row == other.row)
                throw Failure(ErrorKind::usage, "study " + name + ": named twice; name each parameter once.");
        request.axes.push_back(std::move(axis));
    }
    if (!values[t.values].empty()) {
        if (names.size() != 1) throw Failure(ErrorKind::usage, "--values: name exactly one parameter before it.");
        setValues(request.sceneState, request.axes.front(), values[t.values]);
    }
    if (request.axes.empty()) request.axes = qualityAxes(request.sceneState, request.subject, values[t.points]);
    if (request.axes.empty())
        throw Failure(
            ErrorKind::usage,
            std::string(museum.subject(request.subject).name()) +
                " has no parameter on which accuracy depends; name one of the hall, such as hall.supersamples.");
}

}  // namespace

const std::vector<std::string>& studyMetrics()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const render::MetricInfo& metric : render::allMetrics())
            if (!metric.falls && !metric.ofHighRange) all.emplace_back(metric.name);
        return all;
    }();
    return names;
}

const StudyTable& studyTable()
{
    static const StudyTable table;
    return table;
}

StudyRequest studyRequest(const ParameterValues& values, const Museum& museum, SceneState sceneState,
                          std::size_t subject)
{
    const StudyTable& t = studyTable();
    StudyRequest request;
    request.subject = subject;
    request.sceneState = std::move(sceneState);
    request.size = {values[t.width], values[t.height]};
    request.views = values[t.views];
    request.runs = values[t.runs];
    request.metric = render::metricNamed(studyMetrics()[static_cast<std::size_t>(values[t.metric])]).value();
    request.pixelsPerDegree = values[t.pixelsPerDegree];
    request.alone = values[t.alone] && subject != hallIndex;
    request.modelError = values[t.modelError];
    request.asSet = values[t.asSet];
    request.settings = values[t.settings];
    if (values[t.choosing] == StudyFind::cheapest) request.maxError = values[t.maxError];
    if (values[t.choosing] == StudyFind::best) request.maxMilliseconds = values[t.maxMilliseconds];
    setAxes(values, museum, request);
    return request;
}

CostAxis chartCosts(const ParameterValues& values, const StudyResult& result)
{
    const ChartCost cost = values[studyTable().cost];
    if (cost != ChartCost::automatic) return cost == ChartCost::ms ? CostAxis::time : CostAxis::work;
    return result.workName.empty() ? CostAxis::time : usualCostAxis(result.clockTrusted);
}

}  // namespace vitrine::study

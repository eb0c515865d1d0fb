#include "exhibits/study/study_text.h"

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/study/csv_field.h"
#include "exhibits/study/study_situation.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"
#include "render/version.h"

#include <cmath>
#include <set>

namespace vitrine::study {
namespace {

using render::Json;
using render::shortNumber;

/// An interval of factors wider than this does not help to choose a setting.
constexpr double widestFactor = 4;

/// JSON cannot express values that are not finite.
Json number(double x)
{
    return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json errorsJson(const Errors& errors)
{
    Json json = Json::object();
    for (const auto& [metric, error] : errors) json[std::string(toString(metric))] = number(error);
    return json;
}

Json countersJson(const std::map<std::string, std::int64_t>& counters)
{
    Json json = Json::object();
    for (const auto& [name, count] : counters) json[name] = count;
    return json;
}

Json shotJson(const std::string& view, const StudyShot& shot)
{
    Json milliseconds = Json::array();
    for (const double ms : shot.milliseconds) milliseconds.push_back(ms);
    return Json{{"view", view},
                {"errors", errorsJson(shot.errors)},
                {"modelError", shot.modelError ? number(*shot.modelError) : Json(nullptr)},
                {"counters", countersJson(shot.counters)},
                {"ms", milliseconds}};
}

Json pointJson(Subjects subjects, const StudyRequest& request, const StudyResult& result, std::size_t i)
{
    const StudyPoint& point = result.points[i];
    Json values = Json::object();
    for (std::size_t a = 0; a < request.axes.size(); ++a) {
        const StudyAxis& axis = request.axes[a];
        values[axisName(subjects, request.sceneState, request.subject, axis)] =
            jsonFromValue(parameterOf(request.sceneState, axis), axis.values[point.setting[a]]);
    }
    Json json{{"values", values},
              {"error", number(point.error)},
              {"errorOverViews", Json::array({number(point.lowestError), number(point.worstError)})},
              {"uncertain", point.uncertain},
              {"cost", number(point.cost)},
              {"dominated", point.dominated},
              {"knee", result.knee == i},
              {"present", result.present == i},
              {"counters", countersJson(point.counters)}};
    if (point.modelError) json["modelError"] = number(*point.modelError);
    if (point.time) {
        const render::Summary& t = *point.time;
        json["ms"] = Json{{"median", t.median},
                          {"spread", t.spread},
                          {"low", t.low},
                          {"high", t.high},
                          {"interval", Json::array({t.interval.low, t.interval.high})},
                          {"confidence", t.interval.confidence},
                          {"runs", t.runs}};
    }
    Json views = Json::array();
    for (std::size_t v = 0; v < point.shots.size(); ++v) views.push_back(shotJson(result.views[v], point.shots[v]));
    json["views"] = views;
    return json;
}

std::string numberText(double x)
{
    return std::isfinite(x) ? render::shortestNumber(x) : "";
}

/// Returns the cost of `chosen` relative to the present setting, as the end of a sentence.
std::string besidePresent(const StudyResult& result, const StudyPoint& chosen)
{
    if (!result.present) return {};
    const StudyPoint& present = result.points[*result.present];
    if (&present == &chosen) return ", the present setting";
    if (present.cost <= 0 || chosen.cost <= 0) return {};
    if (result.costsTheSame(present, chosen)) return ", with costs that cannot be distinguished from the present ones";
    const double ratio = present.cost / chosen.cost;
    return ratio > 1 ? ", " + shortNumber(ratio) + " times cheaper than at present"
                     : ", " + shortNumber(1 / ratio) + " times the cost of the present setting";
}

}  // namespace

std::string pointText(Subjects subjects, const StudyRequest& request, const StudyPoint& point)
{
    std::string text;
    for (std::size_t a = 0; a < request.axes.size(); ++a) {
        const StudyAxis& axis = request.axes[a];
        const bool asAtPresent =
            std::get<double>(request.sceneState.values[axis.subject].row(axis.row)) == axis.values[point.setting[a]];
        if (asAtPresent && request.axes.size() > 2) continue;
        text += (text.empty() ? "" : ", ") + axisName(subjects, request.sceneState, request.subject, axis) + ' ' +
                axisValueText(request.sceneState, axis, axis.values[point.setting[a]]);
    }
    return text.empty() ? "as at present" : text;
}

std::vector<SettingPart> settingParts(Subjects subjects, const StudyRequest& request, const StudyPoint& point)
{
    std::vector<SettingPart> parts;
    for (std::size_t a = 0; a < request.axes.size(); ++a) {
        const StudyAxis& axis = request.axes[a];
        const double value = axis.values[point.setting[a]];
        const bool asAtPresent = std::get<double>(request.sceneState.values[axis.subject].row(axis.row)) == value;
        if (asAtPresent && request.axes.size() > 2) continue;
        parts.push_back({axisLabel(subjects, request.sceneState, request.subject, axis),
                         axisValueText(request.sceneState, axis, value)});
    }
    return parts;
}

std::string settingText(const std::vector<SettingPart>& parts)
{
    const auto text = [](const SettingPart& part) { return part.label + ' ' + part.value; };
    return parts.empty() ? "as at present" : joined(parts, ", ", text);
}

std::string axisLabels(Subjects subjects, const StudyRequest& request)
{
    return joined(request.axes, ", ", [&](const StudyAxis& axis) {
        return axisLabel(subjects, request.sceneState, request.subject, axis);
    });
}

std::string costTitle(const std::string& costName)
{
    if (costName == "evaluations") return "field evaluations";
    if (costName == "ms") return "milliseconds";
    if (costName == "pixels") return "pixel samples";
    if (costName == "fetches") return "texture fetches";
    if (costName == "samples") return "samples kept";  // Discarded and hidden samples are not counted.
    std::string words;                                 // "march steps" for "marchSteps".
    for (const char c : costName) {
        const bool capital = c >= 'A' && c <= 'Z';
        if (capital) words += ' ';
        words += capital ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return words;
}

std::string lawSentence(const StudyCosts& costs)
{
    if (!costs.law) return {};
    const auto factor = [](double slope) { return std::pow(2.0, -slope); };
    const render::Interval& interval = costs.law->slopeInterval;
    const double low = factor(interval.high);
    const double high = factor(interval.low);
    if (!(low > 0) || !(high <= widestFactor * low))
        return "The cost of halving the error cannot be estimated from so few points, which vary so much; measure more "
               "values.";
    const std::string what =
        costs.parameters > 1 ? "With the best of the settings, halving the error" : "Halving the error";
    return what + " costs " + shortNumber(factor(costs.law->slope)) + " times the " + costTitle(costs.name) + " (" +
           shortNumber(low) + " to " + shortNumber(high) + " with 95 % confidence).";
}

std::string lawSentence(const StudyResult& result)
{
    StudyCosts costs;
    costs.name = result.costName;
    costs.law = result.law;
    costs.parameters = result.points.empty() ? 1 : result.points.front().setting.size();
    return lawSentence(costs);
}

std::string choiceSentence(Subjects subjects, const StudyRequest& request, const StudyResult& result)
{
    if (!result.complete || (!request.maxError && !request.maxMilliseconds)) return {};
    const std::string limit = request.maxError
                                  ? std::string(toString(request.metric)) + " " + shortNumber(*request.maxError)
                                  : shortNumber(*request.maxMilliseconds) + " ms";
    if (!result.choice) return "No setting that was measured stays within " + limit + '.';
    const StudyPoint& point = result.points[result.choice->point];
    std::string text = std::string(request.maxError ? "Cheapest" : "Best") + " within " + limit + ": " +
                       settingText(settingParts(subjects, request, point)) + "; error " +
                       shortNumber(point.worstError) + " at worst, " +
                       (point.time ? shortNumber(point.time->median) + " ms a frame"
                                   : shortNumber(point.cost) + ' ' + costTitle(result.costName));
    text += besidePresent(result, point);
    text += ". In " + std::to_string(result.choice->heldOutViews.size()) + " held-out view" +
            (result.choice->heldOutViews.size() == 1 ? "" : "s") + ": error " +
            shortNumber(result.choice->heldOutError);
    if (request.maxMilliseconds) text += ", " + shortNumber(result.choice->heldOutMilliseconds) + " ms";
    return text +
           (result.choice->holds
                ? ", within the limit."
                : ", beyond the limit, and so is every other setting that was measured: study more of the views.");
}

namespace {

Json axesJson(Subjects subjects, const StudyRequest& request, const StudyResult& result)
{
    Json axes = Json::array();
    for (std::size_t a = 0; a < request.axes.size(); ++a) {
        const StudyAxis& axis = request.axes[a];
        const ParameterInfo& row = parameterOf(request.sceneState, axis);
        Json values = Json::array();
        for (const double value : axis.values) values.push_back(jsonFromValue(row, value));
        axes.push_back(Json{{"name", axisName(subjects, request.sceneState, request.subject, axis)},
                            {"label", axisLabel(subjects, request.sceneState, request.subject, axis)},
                            {"unit", std::string(info(row.unit).storedSymbol)},
                            {"values", values},
                            {"reference", jsonFromValue(row, result.exact[a])}});
    }
    return axes;
}

/// Returns the settings that the study changed, and how to repeat it.
Json situationJson(Subjects subjects, const StudyRequest& request, const StudyResult& result)
{
    Json changed = Json::array(), sentences = Json::array(), settings = Json::array();
    for (const StudyChange& change : result.changes) {
        const StudyAxis at{change.row.subject, change.row.row, {}};
        const ParameterInfo& row = parameterOf(request.sceneState, at);
        changed.push_back(Json{{"name", axisName(subjects, request.sceneState, request.subject, at)},
                               {"value", jsonFromValue(row, change.to)},
                               {"instead", jsonFromValue(row, change.from)}});
    }
    for (const std::string& sentence : situationSentences(subjects, request, result)) sentences.push_back(sentence);
    for (const std::string& setting : settingsToRepeat(subjects, request, result)) settings.push_back(setting);
    return Json{{"changed", changed}, {"sentences", sentences}, {"set", settings}};
}

}  // namespace

Json studyJson(Subjects subjects, const StudyRequest& request, const StudyResult& result, Json machine)
{
    Json points = Json::array();
    for (std::size_t i = 0; i < result.points.size(); ++i) points.push_back(pointJson(subjects, request, result, i));
    Json front = Json::array();
    for (const std::size_t i : result.front) front.push_back(i);
    Json views = Json::array();
    for (const std::string& view : result.views) views.push_back(view);

    Json json{
        {"format", "vitrine-study"},
        {"version", 1},
        {"app", render::programVersion()},
        {"exhibit", std::string(subjects[request.subject]->name())},
        {"alone", request.alone},
        {"size", Json::array({request.size.x, request.size.y})},
        {"views", views},
        {"parameters", axesJson(subjects, request, result)},
        {"situation", situationJson(subjects, request, result)},
        {"metric", std::string(toString(request.metric))},
        {"errorsAreOf",
         "display-referred linear light, one sample at each pixel's center unless supersamples or pictures in motion "
         "are studied"},
        {"pixelsPerDegree", request.pixelsPerDegree},
        {"cost", result.costName},
        {"timing", Json{{"warmUpFrames", 1}, {"runs", request.runs}, {"interleaved", true}}},
        {"clock",
         Json{{"method", result.clock}, {"trusted", result.clockTrusted}, {"overheadMs", result.overheadMilliseconds}}},
        {"machine", std::move(machine)},
        {"reference", Json{{"uncertainty", number(result.uncertainty)},
                           {"converged", result.converged},
                           {"why", result.convergence}}},
        {"front", front},
        {"points", points}};
    if (result.law) {
        const render::Interval& interval = result.law->slopeInterval;
        json["law"] = Json{{"costOverErrorExponent", result.law->slope},
                           {"interval", Json::array({number(interval.low), number(interval.high)})},
                           {"confidence", interval.confidence},
                           {"sentence", lawSentence(result)}};
    }
    if (result.choice) {
        Json heldOut = Json::array();
        for (const std::string& view : result.choice->heldOutViews) heldOut.push_back(view);
        json["choice"] = Json{{"point", result.choice->point},
                              {"heldOutViews", heldOut},
                              {"heldOutError", number(result.choice->heldOutError)},
                              {"holds", result.choice->holds},
                              {"sentence", choiceSentence(subjects, request, result)}};
    }
    return json;
}

std::string studyCsv(Subjects subjects, const StudyRequest& request, const StudyResult& result)
{
    std::set<std::string> counters;
    std::set<render::Metric> metrics;
    for (const StudyPoint& point : result.points) {
        for (const StudyShot& shot : point.shots) {
            for (const auto& [name, count] : shot.counters) counters.insert(name);
            for (const auto& [metric, error] : shot.errors) metrics.insert(metric);
        }
    }
    std::string text;
    for (const StudyAxis& axis : request.axes)
        text += axisName(subjects, request.sceneState, request.subject, axis) + ',';
    text += "view";
    for (const render::Metric metric : metrics) text += ',' + std::string(toString(metric));
    if (request.modelError) text += ",model_" + std::string(toString(request.metric));
    for (const std::string& name : counters) text += ',' + name;
    text += ",ms_median,ms_spread,ms_low,ms_high,runs,clock,settings\n";
    std::string settings;
    for (const std::string& setting : settingsToRepeat(subjects, request, result))
        settings += (settings.empty() ? "" : "; ") + setting;
    for (const StudyPoint& point : result.points) {
        for (std::size_t v = 0; v < point.shots.size(); ++v) {
            const StudyShot& shot = point.shots[v];
            for (std::size_t a = 0; a < request.axes.size(); ++a)
                text += csvField(formatValue(parameterOf(request.sceneState, request.axes[a]),
                                             request.axes[a].values[point.setting[a]])) +
                        ',';
            text += csvField(result.views[v]);
            for (const render::Metric metric : metrics)
                text += ',' + (shot.errors.contains(metric) ? numberText(shot.errors.at(metric)) : std::string());
            if (request.modelError) text += ',' + (shot.modelError ? numberText(*shot.modelError) : std::string());
            for (const std::string& name : counters)
                text +=
                    ',' + (shot.counters.contains(name) ? std::to_string(shot.counters.at(name)) : std::string("0"));
            if (shot.milliseconds.empty()) {
                text += ",,,,,0,";
            } else {
                const render::Summary t = render::summarize(shot.milliseconds);
                for (const double x : {t.median, t.spread, t.low, t.high}) text += ',' + numberText(x);
                text += ',' + std::to_string(t.runs) + ',';
            }
            text += csvField(result.clock) + ',' + csvField(settings) + '\n';
        }
    }
    return text;
}

}  // namespace vitrine::study

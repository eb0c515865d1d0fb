#include "exhibits/jobs/comparison/comparison_json.h"

#include "exhibits/framework/table/preset_values.h"
#include "render/version.h"

#include <cmath>

namespace vitrine::jobs {

using render::Json;

namespace comparisons {
namespace {

Json sideJson(const compare::PassSide& side)
{
    static constexpr std::array<const char*, 3> states{"ran", "skipped", "absent"};
    return Json{{"state", states.at(static_cast<std::size_t>(side.state))},
                {"ms", side.milliseconds < 0 ? Json(nullptr) : Json(side.milliseconds)},
                {"why", side.why}};
}

Json timeJson(const compare::ComparedSide& side)
{
    if (!side.time) return nullptr;
    return Json{
        {"median", side.time->median}, {"low", side.time->low}, {"high", side.time->high}, {"runs", side.time->runs}};
}

Json parametersJson(Subjects subjects, const std::vector<compare::DifferingParameter>& rows)
{
    Json all = Json::array();
    for (const compare::DifferingParameter& row : rows)
        all.push_back(Json{{"exhibit", std::string(subjects[row.subject]->name())},
                           {"name", row.name},
                           {"a", row.a ? jsonFromValue(row.info, *row.a) : Json(nullptr)},
                           {"b", row.b ? jsonFromValue(row.info, *row.b) : Json(nullptr)},
                           {"actsInA", row.actsInA},
                           {"actsInB", row.actsInB}});
    return all;
}

}  // namespace
}  // namespace comparisons

Json comparisonJson(Subjects subjects, const compare::Comparison& comparison, const ComparisonText& text)
{
    const compare::ComparisonRequest& request = comparison.request();
    const compare::ComparisonResult& result = comparison.result();
    Json errors = Json::object(), passes = Json::array(), counters = Json::object();
    for (const auto& [metric, error] : result.errors)
        errors[std::string(toString(metric))] = std::isfinite(error) ? Json(error) : Json("infinite");
    for (const compare::PassCost& cost : result.passes)
        passes.push_back(Json{{"name", cost.name},
                              {"kind", toString(cost.work)},
                              {"a", comparisons::sideJson(cost.a)},
                              {"b", comparisons::sideJson(cost.b)}});
    for (const compare::CounterCost& cost : result.counters)
        counters[cost.name] =
            Json{{"a", cost.a ? Json(*cost.a) : Json(nullptr)}, {"b", cost.b ? Json(*cost.b) : Json(nullptr)}};
    const FrameRequest& frame = request.frame;
    return Json{
        {"format", "vitrine-comparison"},
        {"version", 1},
        {"app", render::programVersion()},
        {"a", text.names[0]},
        {"b", text.names[1]},
        {"size", Json::array({frame.raster.size.x, frame.raster.size.y})},
        {"samples", Json::array({request.samples[0], request.samples[1]})},
        {"time", frame.time},
        {"seed", frame.seed},
        {"camera", jsonFromCamera(frame.camera, Json::object())},
        {"machine", text.machine},
        {"clock", Json{{"method", result.sides[0].report.clock}, {"trusted", result.sides[0].report.clockTrusted}}},
        {"errors", errors},
        {"rows", comparisons::parametersJson(subjects, result.rows)},
        {"ms", Json{{"a", comparisons::timeJson(result.sides[0])}, {"b", comparisons::timeJson(result.sides[1])}}},
        {"passes", passes},
        {"counters", counters}};
}

}  // namespace vitrine::jobs

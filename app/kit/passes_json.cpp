#include "app/kit/passes_json.h"

#include <string>

namespace vitrine::app {
namespace {

using render::Json;

/// Returns null if there is no bound.
Json boundJson(const render::ContributionBound& bound)
{
    return bound.isKnown() ? Json{{"share", bound.relative}, {"radiance", bound.absolute}} : Json(nullptr);
}

/// Returns the JSON of a pass or of its report.
template <typename Step> Json stepJson(const Step& step)
{
    Json json{
        {"name", step.name}, {"kind", toString(step.work)}, {"reason", step.reason}, {"bound", boundJson(step.bound)}};
    if (!step.variant.empty()) json["variant"] = step.variant;
    for (const render::Effect& effect : step.effects)
        json["effects"].push_back(Json{{"name", effect.name}, {"bound", boundJson(effect.bound)}});
    return json;
}

}  // namespace

Json ranJson(const std::vector<render::StepReport>& steps)
{
    Json ran = Json::array();
    for (const render::StepReport& step : steps) {
        ran.push_back(stepJson(step));
        ran.back()["ms"] = step.milliseconds < 0 ? Json(nullptr) : Json(step.milliseconds);
    }
    return ran;
}

Json plannedJson(const std::vector<render::Pass>& passes)
{
    Json planned = Json::array();
    for (const render::Pass& pass : passes) planned.push_back(stepJson(pass));
    return planned;
}

Json skippedJson(const std::vector<render::CulledPass>& passes)
{
    Json skipped = Json::array();
    for (const render::CulledPass& pass : passes)
        skipped.push_back(Json{{"name", pass.name},
                               {"kind", toString(pass.work)},
                               {"reason", pass.reason},
                               {"boundIsZero", pass.boundIsZero}});
    return skipped;
}

}  // namespace vitrine::app

#include "app/serve/values_json.h"

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/framework/time/motion_json.h"

namespace vitrine::app {
namespace {

using render::Json;

Json motionJson(const ParameterValues& values, std::size_t row)
{
    const Motion* motion = values.motion(row);
    return motion ? jsonFromMotion(values.rows()[row], *motion) : Json(nullptr);
}

}  // namespace

Json valuesJson(const ParameterValues& values)
{
    Json json = Json::object();
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        json[std::string(values.rows()[i].name)] = jsonFromValue(values.rows()[i], values.row(i));
    return json;
}

Json motionsJson(const ParameterValues& values)
{
    Json json = Json::object();
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (values.motion(i)) json[std::string(values.rows()[i].name)] = motionJson(values, i);
    return json;
}

Json changeJson(std::string_view exhibit, const ParameterValues& before, const ParameterValues& now)
{
    Json changed{{"exhibit", std::string(exhibit)}, {"values", Json::object()}, {"motions", Json::object()}};
    for (std::size_t i = 0; i < now.rows().size(); ++i) {
        const ParameterInfo& row = now.rows()[i];
        const auto old = before.table().find(row.name);
        const std::string name(row.name);
        if (!old || before.row(*old) != now.row(i)) changed["values"][name] = jsonFromValue(row, now.row(i));
        const Json motion = motionJson(now, i);
        if (motion != (old ? motionJson(before, *old) : Json(nullptr))) changed["motions"][name] = motion;
    }
    return changed["values"].empty() && changed["motions"].empty() ? Json(nullptr) : changed;
}

}  // namespace vitrine::app

#include "app/kit/table_json.h"

#include "exhibits/compare/offered_comparison.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/table/preset_values.h"

namespace vitrine::app {
namespace {

using render::Json;

/// Returns {"test": "all", "parts": [...]}, or {"test": "among", "row": "sunBy", "values": ["angles"]}.
Json conditionJson(const Condition& condition, const Parameters& table)
{
    Json json{{"test", std::string(toString(condition.test))}};
    if (condition.row.empty()) {
        json["parts"] = Json::array();
        for (const Condition& part : condition.parts) json["parts"].push_back(conditionJson(part, table));
        return json;
    }
    const ParameterInfo& row = table.rows()[table.find(condition.row).value()];
    json["row"] = std::string(condition.row);
    json["values"] = Json::array();
    for (const double value : condition.values) json["values"].push_back(jsonFromValue(row, value));
    return json;
}

/// Returns a parameter. Numbers are in SI units, and `unit` names that unit.
Json parameterJson(const ParameterInfo& parameter, const Parameters& table)
{
    Json choices = Json::array();
    for (const std::string_view choice : parameter.choices) choices.push_back(std::string(choice));
    Json quality = nullptr;
    if (parameter.qualityReference)
        quality = Json{{"reference", jsonFromValue(parameter, *parameter.qualityReference)}};
    Json when = nullptr;
    if (parameter.actsWhen) when = conditionJson(*parameter.actsWhen, table);
    return Json{{"name", std::string(parameter.name)},
                {"label", label(parameter)},
                {"group", std::string(parameter.group)},
                {"kind", std::string(toString(parameter.kind))},
                {"unit", std::string(info(parameter.unit).storedSymbol)},
                {"low", parameter.range.low},
                {"high", parameter.range.high},
                {"softLow", parameter.range.softLow},
                {"softHigh", parameter.range.softHigh},
                {"scale", std::string(toString(parameter.range.scale))},
                {"initial", jsonFromValue(parameter, parameter.initial)},
                {"help", std::string(parameter.help)},
                {"choices", choices},
                {"quality", quality},
                {"actsWhen", when}};
}

/// Returns the comparisons that the subject offers, with the parameters that they change.
Json comparisonsJson(const SceneObject& subject, const Parameters& table)
{
    Json all = Json::array();
    for (const OfferedComparison& offered : compare::offeredComparisons(subject)) {
        Json values = Json::object();
        for (const auto& [name, value] : offered.rows)
            if (const auto row = table.find(name)) values[std::string(name)] = jsonFromValue(table.rows()[*row], value);
        all.push_back(
            Json{{"name", offered.name}, {"title", offered.title}, {"help", offered.help}, {"values", values}});
    }
    return all;
}

}  // namespace

Json exhibitJson(std::string_view name, std::string_view title, std::string_view summary, const Parameters& table,
                 const SceneObject* subject)
{
    Json rows = Json::array();
    for (const ParameterInfo& parameter : table.rows()) rows.push_back(parameterJson(parameter, table));
    const auto* exhibit = dynamic_cast<const Exhibit*>(subject);
    return Json{
        {"name", std::string(name)},   {"complete", !exhibit || exhibit->isComplete()},
        {"title", std::string(title)}, {"summary", std::string(summary)},
        {"parameters", rows},          {"comparisons", subject ? comparisonsJson(*subject, table) : Json::array()}};
}

Json exhibitsJson(const Museum& museum, const SceneState& sceneState)
{
    Json all = Json::array();
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        const SceneObject& subject = museum.subject(i);
        all.push_back(
            exhibitJson(subject.name(), subject.title(), subject.summary(), sceneState.values[i].table(), &subject));
    }
    return all;
}

}  // namespace vitrine::app

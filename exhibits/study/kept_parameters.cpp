#include "exhibits/study/kept_parameters.h"

#include "exhibits/framework/table/preset_values.h"

#include <algorithm>

namespace vitrine::study {
namespace {

std::optional<std::size_t> subjectNamed(Subjects subjects, const std::string& name)
{
    for (std::size_t i = 0; i < subjects.size(); ++i)
        if (subjects[i]->name() == name) return i;
    return std::nullopt;
}

}  // namespace

KeptParameters parametersOf(const KeptStudy& study, Subjects subjects, const SceneState& sceneState)
{
    KeptParameters found;
    for (const KeptStudy::Parameter& parameter : study.parameters) {
        const std::size_t dot = parameter.name.find('.');
        const std::string exhibit = dot == std::string::npos ? study.exhibit : parameter.name.substr(0, dot);
        const std::optional<std::size_t> subject = subjectNamed(subjects, exhibit);
        if (!subject) {
            found.missingExhibit = exhibit;
            return found;
        }
        const std::string name = dot == std::string::npos ? parameter.name : parameter.name.substr(dot + 1);
        const std::optional<std::size_t> row = sceneState.values[*subject].table().find(name);
        if (!row) {
            found.missingParameter = parameter.name;
            return found;
        }
        found.rows.push_back({*subject, *row});
    }
    return found;
}

std::optional<std::vector<Value>> valuesOf(const KeptStudy& study, std::size_t point, const KeptParameters& rows,
                                           const SceneState& sceneState, std::string& wrong)
{
    std::vector<Value> values;
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        const auto [subject, row] = rows.rows[i];
        std::vector<std::string> changes;
        const std::optional<Value> value = valueFromText(sceneState.values[subject].rows()[row],
                                                         render::writeJson(study.points[point].values[i]), changes);
        if (!value || !changes.empty()) {
            wrong = study.parameters[i].name;
            return std::nullopt;
        }
        values.push_back(*value);
    }
    return values;
}

}  // namespace vitrine::study

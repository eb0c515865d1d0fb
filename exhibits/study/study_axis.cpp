#include "exhibits/study/study_axis.h"

#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/table/value_text.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vitrine::study {

const ParameterInfo& parameterOf(const SceneState& sceneState, const StudyAxis& axis)
{
    return sceneState.values[axis.subject].rows()[axis.row];
}

std::string axisName(Subjects subjects, const SceneState& sceneState, std::size_t subject, const StudyAxis& axis)
{
    const std::string name(parameterOf(sceneState, axis).name);
    return axis.subject == subject ? name : std::string(subjects[axis.subject]->name()) + '.' + name;
}

std::string axisLabel(Subjects subjects, const SceneState& sceneState, std::size_t subject, const StudyAxis& axis)
{
    const std::string name = label(parameterOf(sceneState, axis));
    return axis.subject == subject ? name : std::string(subjects[axis.subject]->title()) + ": " + name;
}

std::string axisValueText(const SceneState& sceneState, const StudyAxis& axis, double value)
{
    const ParameterInfo& row = parameterOf(sceneState, axis);
    const std::string unit(info(row.unit).symbol);
    std::string text = formatValue(row, value);
    if (row.kind == Kind::real) {
        // Four digits distinguish the values of a sweep; all seventeen would be noise.
        char digits[32];
        const double shown = render::parseNumber(text).value_or(value);
        text.assign(digits, std::to_chars(digits, digits + sizeof digits, shown, std::chars_format::general, 4).ptr);
    }
    return text + (unit.empty() ? "" : ' ' + unit);
}

std::optional<StudyAxis> studyAxis(const SceneState& sceneState, std::size_t subject, std::size_t row, int points)
{
    StudyAxis axis{subject, row, {}};
    const ParameterInfo& info = parameterOf(sceneState, axis);
    if (!info.qualityReference) return std::nullopt;
    // One value is reserved for the initial one, unless the sweep contains it anyway.
    axis.values = derive::sweep(info, std::max(points - 1, 2));
    if (info.isNumeric()) axis.values.push_back(*info.qualityReference);
    std::sort(axis.values.begin(), axis.values.end());
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    return axis;
}

std::vector<StudyAxis> qualityAxes(const SceneState& sceneState, std::size_t subject, int points)
{
    const auto& rows = sceneState.values[subject].rows();
    if (points == 0)
        points = usualPoints(
            static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const ParameterInfo& parameter) {
                return parameter.qualityReference.has_value();
            })));
    std::vector<StudyAxis> axes;
    for (std::size_t row = 0; row < rows.size(); ++row)
        if (auto axis = studyAxis(sceneState, subject, row, points)) axes.push_back(std::move(*axis));
    return axes;
}

ParameterValues atReference(ParameterValues values)
{
    for (std::size_t row = 0; row < values.rows().size(); ++row)
        if (const auto reference = values.rows()[row].qualityReference) values.setParameter(row, *reference);
    return values;
}

Exactness exactness(const ParameterInfo& parameter, int doublings)
{
    const double initial = parameter.isNumeric() ? std::get<double>(parameter.initial) : 0;
    Exactness result{parameter.qualityReference.value_or(initial), {}, parameter.exactByMeaning, {}};
    if (parameter.exactByMeaning || !parameter.isNumeric()) return result;
    const bool byFactors = parameter.range.scale == Scale::logarithmic;
    if (!byFactors && parameter.kind != Kind::count) return result;
    const auto legal = [&](double x) { return x >= parameter.range.low && x <= parameter.range.high; };
    const auto moved = [&](double x, bool up) {
        const double to = byFactors ? x * (up ? 2 : 0.5) : x + (up ? 1 : -1);
        return parameter.kind == Kind::count ? std::round(to) : to;
    };
    const auto check = [&](bool up) {
        if (const double to = moved(result.exact, up); legal(to) && to != result.exact) result.neighbors.push_back(to);
    };
    if (result.exact == initial) {
        // The less exact direction is unknown here.
        check(false);
        check(true);
        return result;
    }
    const bool more = result.exact > initial;
    if (byFactors) {
        for (int i = 0; i < doublings && legal(moved(result.exact, more)); ++i)
            result.exact = moved(result.exact, more);
        if (const double to = moved(result.exact, more); legal(to)) result.beyond = to;
    }
    check(!more);
    return result;
}

std::vector<std::vector<double>> neighborsOf(const SceneState& sceneState, const std::vector<StudyAxis>& axes,
                                             int doublings)
{
    std::vector<double> exact, first, last;
    for (const StudyAxis& axis : axes) {
        const Exactness e = exactness(parameterOf(sceneState, axis), doublings);
        exact.push_back(e.exact);
        first.push_back(e.neighbors.empty() ? e.exact : e.neighbors.front());
        last.push_back(e.neighbors.empty() ? e.exact : e.neighbors.back());
    }
    std::vector<std::vector<double>> settings;
    if (first != exact) settings.push_back(first);
    if (last != first) settings.push_back(last);
    return settings;
}

}  // namespace vitrine::study

#include "exhibits/framework/study_axis.h"

#include "exhibits/framework/derive.h"
#include "exhibits/framework/value_text.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vitrine {

const ParameterInfo& rowOf(Exhibits exhibits, const StudyAxis& axis)
{
    return exhibits[axis.exhibit]->parameters().rows()[axis.row];
}

std::string axisName(Exhibits exhibits, std::size_t subject, const StudyAxis& axis)
{
    const std::string name(rowOf(exhibits, axis).name);
    return axis.exhibit == subject ? name : std::string(exhibits[axis.exhibit]->name()) + '.' + name;
}

std::string axisValueText(Exhibits exhibits, const StudyAxis& axis, double value)
{
    const ParameterInfo& row = rowOf(exhibits, axis);
    const std::string unit(info(row.unit).symbol);
    std::string text = formatValue(row, value);
    if (row.kind == Kind::real) {
        // Four digits tell the values of a sweep apart; all seventeen tell nobody anything.
        char digits[32];
        const double shown = render::parseNumber(text).value_or(value);
        text.assign(digits, std::to_chars(digits, digits + sizeof digits, shown, std::chars_format::general, 4).ptr);
    }
    return text + (unit.empty() ? "" : ' ' + unit);
}

std::optional<StudyAxis> studyAxis(Exhibits exhibits, std::size_t exhibit, std::size_t row, int points)
{
    StudyAxis axis{exhibit, row, {}};
    const ParameterInfo& info = rowOf(exhibits, axis);
    if (!info.qualityReference) return std::nullopt;
    // One place is the initial value's, unless the sweep meets it anyway.
    axis.values = derive::sweep(info, std::max(points - 1, 2));
    if (info.isNumeric()) axis.values.push_back(*info.qualityReference);
    std::sort(axis.values.begin(), axis.values.end());
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    return axis;
}

std::vector<StudyAxis> qualityAxes(Exhibits exhibits, std::size_t exhibit, int points)
{
    const auto& rows = exhibits[exhibit]->parameters().rows();
    if (points == 0) points = usualPoints(static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const ParameterInfo& row) { return row.qualityReference.has_value(); })));
    std::vector<StudyAxis> axes;
    for (std::size_t row = 0; row < rows.size(); ++row)
        if (auto axis = studyAxis(exhibits, exhibit, row, points)) axes.push_back(std::move(*axis));
    return axes;
}

ParameterValues atReference(ParameterValues values)
{
    for (std::size_t row = 0; row < values.rows().size(); ++row)
        if (const auto reference = values.rows()[row].qualityReference) values.setRow(row, *reference);
    return values;
}

Exactness exactness(const ParameterInfo& row, int doublings)
{
    const double reference = row.qualityReference.value_or(std::get<double>(row.initial));
    Exactness result{reference, {}, {}};
    const bool number = row.isNumeric();
    const double initial = number ? std::get<double>(row.initial) : reference;
    if (!number || initial == reference) return result;
    const auto legal = [&](double x) { return x >= row.range.low && x <= row.range.high; };
    const bool more = reference > initial;
    if (row.range.scale == Scale::logarithmic) {
        const double factor = more ? 2 : 0.5;
        for (int i = 0; i < doublings && legal(result.exact * factor); ++i) result.exact *= factor;
        result.halfway = result.exact / factor;
        if (legal(result.exact * factor)) result.beyond = result.exact * factor;
    } else if (row.kind == Kind::count) {
        result.halfway = result.exact + (more ? -1 : 1);
    }
    if (row.kind == Kind::count && result.halfway) result.halfway = std::round(*result.halfway);
    return result;
}

}  // namespace vitrine

#include "exhibits/framework/parameters.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

namespace vitrine {
namespace {

double clampNumber(const ParameterInfo& row, double x)
{
    const double inside = std::clamp(x, row.range.low, row.range.high);
    return row.kind == Kind::real ? inside : std::round(inside);
}

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::string_view toString(Kind kind)
{
    switch (kind) {
    case Kind::real: return "real";
    case Kind::count: return "count";
    case Kind::toggle: return "toggle";
    case Kind::choice: return "choice";
    case Kind::color: return "color";
    case Kind::direction: return "direction";
    case Kind::file: return "file";
    }
    return "";
}

std::string_view toString(Scale scale)
{
    return scale == Scale::linear ? "linear" : "logarithmic";
}

std::string label(const ParameterInfo& row)
{
    std::string text;
    for (const char c : row.name) {
        const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
        if (upper && !text.empty()) text += ' ';
        const int shownAs = text.empty() ? std::toupper(static_cast<unsigned char>(c)) : std::tolower(static_cast<unsigned char>(c));
        text += static_cast<char>(shownAs);
    }
    return text;
}

std::optional<Value> nearestLegal(const ParameterInfo& row, const Value& value)
{
    switch (row.kind) {
    case Kind::real:
    case Kind::count:
    case Kind::toggle:
    case Kind::choice: {
        const double* x = std::get_if<double>(&value);
        if (!x || std::isnan(*x)) return std::nullopt;
        return clampNumber(row, *x);
    }
    case Kind::color: {
        const glm::dvec3* v = std::get_if<glm::dvec3>(&value);
        if (!v || !isFinite(*v)) return std::nullopt;
        return glm::clamp(*v, 0.0, 1.0);
    }
    case Kind::direction: {
        const glm::dvec3* v = std::get_if<glm::dvec3>(&value);
        if (!v || !isFinite(*v)) return std::nullopt;
        const double length = glm::length(*v);
        if (!(length > 1e-12) || !std::isfinite(length)) return std::nullopt;
        // A direction that is already unit length keeps its bits, so that presets round-trip.
        return std::abs(length - 1) < 1e-12 ? *v : *v / length;
    }
    case Kind::file: {
        const std::string* path = std::get_if<std::string>(&value);
        if (!path) return std::nullopt;
        return *path;
    }
    }
    return std::nullopt;
}

std::optional<std::size_t> Parameters::find(std::string_view name) const
{
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const ParameterInfo& r) { return r.name == name; });
    if (row == rows_.end()) return std::nullopt;
    return static_cast<std::size_t>(row - rows_.begin());
}

ParameterValues Parameters::initial() const
{
    return ParameterValues(*this);
}

Parameters::Group Parameters::group(std::string_view title)
{
    group_ = title;
    return {};
}

Real Parameters::real(std::string_view name, double initial, Unit unit, Range range, std::string_view help, Quality q)
{
    return {append({name, group_, help, Kind::real, unit, range, initial, {}, q.reference})};
}

Count Parameters::count(std::string_view name, int initial, Range range, std::string_view help, Quality q)
{
    return {append({name, group_, help, Kind::count, none, range, static_cast<double>(initial), {}, q.reference})};
}

Toggle Parameters::toggle(std::string_view name, bool initial, std::string_view help, Quality q)
{
    return {append({name, group_, help, Kind::toggle, none, {0, 1}, initial ? 1.0 : 0.0, {}, q.reference})};
}

Color Parameters::color(std::string_view name, glm::dvec3 initial, std::string_view help)
{
    return {append({name, group_, help, Kind::color, none, {0, 1}, initial, {}, {}})};
}

Direction Parameters::direction(std::string_view name, glm::dvec3 initial, std::string_view help)
{
    return {append({name, group_, help, Kind::direction, none, {-1, 1}, glm::normalize(initial), {}, {}})};
}

File Parameters::file(std::string_view name, std::string_view help, std::string_view endings)
{
    return {append({name, group_, help, Kind::file, none, {0, 0}, std::string(), {}, {}, endings})};
}

std::uint16_t Parameters::appendChoice(std::string_view name, int initial, std::initializer_list<std::string_view> names,
                                       std::string_view help, Quality q)
{
    const double last = static_cast<double>(names.size()) - 1;
    return append({name, group_, help, Kind::choice, none, {0, last}, static_cast<double>(initial), names, q.reference});
}

std::uint16_t Parameters::append(ParameterInfo row)
{
    assert(!find(row.name) && "two rows share a name");
    assert(row.range.low <= row.range.softLow && row.range.softHigh <= row.range.high);
    assert(row.range.scale == Scale::linear || row.range.softLow > 0);
    assert(nearestLegal(row, row.initial).has_value());
    rows_.push_back(std::move(row));
    return static_cast<std::uint16_t>(rows_.size() - 1);
}

ParameterValues::ParameterValues(const Parameters& table) : table_(&table)
{
    values_.reserve(table.rows().size());
    for (const ParameterInfo& row : table.rows()) values_.push_back(row.initial);
}

bool ParameterValues::setRow(std::size_t i, const Value& value)
{
    const std::optional<Value> legal = nearestLegal(rows()[i], value);
    if (!legal) return false;
    values_[i] = *legal;
    return *legal == value;
}

void ParameterValues::resetRow(std::size_t i)
{
    values_[i] = rows()[i].initial;
}

bool ParameterValues::isInitial(std::size_t i) const
{
    return values_[i] == rows()[i].initial;
}

}  // namespace vitrine

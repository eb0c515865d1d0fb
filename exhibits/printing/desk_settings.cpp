#include "exhibits/printing/desk_settings.h"

#include "exhibits/framework/preset_values.h"
#include "exhibits/printing/sheet.h"

#include <cmath>
#include <limits>

namespace vitrine::printing {
namespace {

/// Without the last digits that conversion adds, so that 70 mm stay 70.
double mm(double metres)
{
    return std::round(metres * 1e12) / 1e9;
}

double degrees(double radians)
{
    return std::round(radians / radiansPerDegree * 1e9) / 1e9;
}

bool same(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

}  // namespace

Sheet sheetOf(const DeskTable& table, const ParameterValues& values)
{
    Sheet sheet;
    if (values[table.lens] == LensShape::derived) {
        sheet = derivedSheet("", values[table.lensesPerInch], degrees(values[table.zone]), values[table.refractiveIndex]);
        sheet.conic = values[table.conic];
    } else {
        sheet = {"", values[table.lensesPerInch], 0, mm(values[table.radius]), mm(values[table.thickness]), values[table.refractiveIndex], values[table.conic]};
    }
    sheet.effectiveLpi = values[table.measuredPerInch];
    check(sheet);
    return sheet;
}

ParameterValues withSheet(const DeskTable& table, ParameterValues values, const Sheet& sheet)
{
    values.set(table.lensesPerInch, sheet.nominalLpi);
    values.set(table.measuredPerInch, sheet.effectiveLpi);
    values.set(table.radius, sheet.radius / 1000);
    values.set(table.thickness, sheet.thickness / 1000);
    values.set(table.refractiveIndex, sheet.index);
    values.set(table.conic, sheet.conic);
    // The zone that a lens focused on its back would have; kept where the sheet is that lens.
    const double zone = 2 * std::atan(sheet.index * (25.4 / sheet.nominalLpi) / (2 * sheet.thickness));
    values.set(table.zone, degrees(zone) * radiansPerDegree);
    values.set(table.lens, same(sheet.radius, sheet.thickness * (sheet.index - 1) / sheet.index) ? LensShape::derived : LensShape::given);
    return values;
}

PrintSettings printSettings(const DeskTable& table, const ParameterValues& values, int views)
{
    PrintSettings s;
    s.sheet = sheetOf(table, values);
    s.dpiX = values[table.dotsPerInch];
    s.dpiY = values[table.dotsDown] > 0 ? values[table.dotsDown] : s.dpiX;
    s.width = mm(values[table.width]);
    s.height = mm(values[table.height]);
    s.bleed = mm(values[table.bleed]);
    s.distance = values[table.infiniteDistance] ? std::numeric_limits<double>::infinity() : mm(values[table.distance]);
    s.visualLpi = values[table.visualPerInch];
    s.phase = values[table.phase];
    s.direction = degrees(values[table.direction]);
    s.reverse = values[table.reverse];
    s.mirror = values[table.mirror];
    s.views = views;
    s.method = values[table.method];
    s.guard = values[table.guard];
    s.border = mm(values[table.border]);
    s.inkSpread = mm(values[table.inkSpread]);
    s.compensate = values[table.compensate];
    s.dither = values[table.dither] && values[table.bits] == 0;  // 16 bits need none.
    return s;
}

ParameterValues withSettings(const DeskTable& table, ParameterValues values, const PrintSettings& s)
{
    values = withSheet(table, std::move(values), s.sheet);
    values.set(table.dotsPerInch, s.dpiX);
    values.set(table.dotsDown, s.dpiY == s.dpiX ? 0.0 : s.dpiY);
    values.set(table.width, s.width / 1000);
    values.set(table.height, s.height / 1000);
    values.set(table.bleed, s.bleed / 1000);
    values.set(table.infiniteDistance, std::isinf(s.distance));
    if (!std::isinf(s.distance)) values.set(table.distance, s.distance / 1000);
    values.set(table.visualPerInch, s.visualLpi);
    values.set(table.phase, s.phase);
    values.set(table.direction, s.direction * radiansPerDegree);
    values.set(table.reverse, s.reverse);
    values.set(table.mirror, s.mirror);
    values.set(table.views, s.views);
    values.set(table.method, s.method);
    values.set(table.guard, s.guard);
    values.set(table.border, s.border / 1000);
    values.set(table.inkSpread, s.inkSpread / 1000);
    values.set(table.compensate, s.compensate);
    values.set(table.dither, s.dither);
    return values;
}

render::Json deskJson(const ParameterValues& values, const std::vector<std::string>& sources)
{
    render::Json changed = render::Json::object();
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (!values.isInitial(i)) changed[std::string(values.rows()[i].name)] = jsonFromValue(values.rows()[i], values.row(i));
    return {{"values", changed}, {"files", sources}};
}

ParameterValues valuesFromDesk(const DeskTable& table, const render::JsonDocument& document, std::vector<std::string>& sources,
                               std::vector<std::string>& notes)
{
    ParameterValues values = table.initial();
    const render::Json& root = document.root();
    if (!root.is_object() || !root.contains("desk")) return values;
    const render::Json& desk = root["desk"];
    if (!desk.is_object() || !desk.contains("values") || !desk["values"].is_object()) throw document.failure("desk", "this must be an object with \"values\"; correct it there.");
    for (const auto& [key, json] : desk["values"].items()) {
        const auto row = table.find(key);
        if (!row) {
            notes.push_back("\"" + key + "\" is not known and was left out.");
            continue;
        }
        const JsonPlace place{document, "desk.values." + key, {}};
        values.setRow(*row, valueFromJson(table.rows()[*row], json, place, key, notes));
    }
    if (!desk.contains("files")) return values;
    if (!desk["files"].is_array()) throw document.failure("desk.files", "this must be a list of file names; correct it there.");
    for (const render::Json& file : desk["files"]) {
        if (!file.is_string()) throw document.failure("desk.files", "this must be a list of file names; correct it there.");
        sources.push_back(file.get<std::string>());
    }
    return values;
}

}  // namespace vitrine::printing

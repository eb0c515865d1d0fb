#include "exhibits/printing/print_table.h"

#include "exhibits/framework/table/acting.h"

#include <cmath>

namespace vitrine::printing {
namespace {

/// Converts to millimeters, without the last digits that conversion adds, so 70 mm are exactly 70.
double mm(double meters)
{
    return std::round(meters * 1e12) / 1e9;
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

const PrintTable& printTable()
{
    static const PrintTable table;
    return table;
}

bool rowActs(const ParameterInfo& row, const ParameterValues& values, bool chart)
{
    const PrintTable& table = printTable();
    const auto is = [&](auto parameter) { return row.name == table.rows()[parameter.row].name; };
    const ViewOrigin from = values[table.origin];
    if (row.group == "Views") {
        if (chart)
            return is(table.views) && values[table.chart] != ChartKind::pitch &&
                   values[table.chart] != ChartKind::phase;
        if (is(table.viewWidth) || is(table.samples) || is(table.baselineScale) || is(table.convergence))
            return from == ViewOrigin::shown;
        if (is(table.quiltColumns) || is(table.quiltRows)) return from == ViewOrigin::quilt;
        if (is(table.views)) return from != ViewOrigin::quilt;
        if (is(table.fitting)) return from != ViewOrigin::shown;
        return !is(table.origin) && !is(table.places);  // The dialog shows these beside the files.
    }
    if (row.group == "Chart" && !chart) return false;
    if (chart && (is(table.border) || is(table.compensate))) return false;
    return !row.actsWhen || holds(*row.actsWhen, values);
}

bool sameViews(const ParameterValues& a, const ParameterValues& b)
{
    const PrintTable& table = printTable();
    const bool rendered = b[table.origin] == ViewOrigin::shown;
    const auto decides = [&](const ParameterInfo& row) {
        if (row.name == table.rows()[table.places.row].name) return !rendered;
        if (row.group == "Views") return row.name == table.rows()[table.origin.row].name || rowActs(row, b, false);
        // Pictures are fitted to the shape of the print when they are read.
        const bool shapes = row.name == "width" || row.name == "height" || row.name == "bleed";
        if (!rendered && shapes) return b[table.fitting] != Fitting::stretch;
        // The cameras are placed by what the lenses show, and framed by the print's shape.
        return rendered &&
               (row.group == "Sheet" || row.name == "width" || row.name == "height" || row.name == "bleed" ||
                row.name == "direction" || row.name == "distance" || row.name == "visualPerInch");
    };
    for (std::size_t i = 0; i < a.rows().size(); ++i)
        if (a.row(i) != b.row(i) && decides(a.rows()[i])) return false;
    return true;
}

double viewingDistance(const ParameterValues& values)
{
    return values[printTable().distance] * 1000;
}

int bitsOf(const ParameterValues& values)
{
    return values[printTable().bits] == PrintBits::eight ? 8 : 16;
}

Sheet sheetOf(const ParameterValues& values)
{
    const PrintTable& table = printTable();
    Sheet sheet;
    if (values[table.lens] == LensShape::derived) {
        sheet = derivedSheet("derived", values[table.lensesPerInch], degrees(values[table.zone]),
                             values[table.refractiveIndex]);
        sheet.conic = values[table.conic];
    } else {
        sheet = {"own",
                 values[table.lensesPerInch],
                 0,
                 mm(values[table.radius]),
                 mm(values[table.thickness]),
                 values[table.refractiveIndex],
                 values[table.conic]};
    }
    sheet.effectiveLpi = values[table.measuredPerInch];
    check(sheet);
    return sheet;
}

ParameterValues withSheet(ParameterValues values, const Sheet& sheet)
{
    const PrintTable& table = printTable();
    values.set(table.lensesPerInch, sheet.nominalLpi);
    values.set(table.measuredPerInch, sheet.effectiveLpi);
    values.set(table.radius, sheet.radius / 1000);
    values.set(table.thickness, sheet.thickness / 1000);
    values.set(table.refractiveIndex, sheet.index);
    values.set(table.conic, sheet.conic);
    // The zone that a lens focused on its back would have; the sheet is unchanged if it is that lens.
    const double zone = 2 * std::atan(sheet.index * (25.4 / sheet.nominalLpi) / (2 * sheet.thickness));
    values.set(table.zone, degrees(zone) * radiansPerDegree);
    values.set(table.lens, same(sheet.radius, sheet.thickness * (sheet.index - 1) / sheet.index) ? LensShape::derived
                                                                                                 : LensShape::given);
    return values;
}

PrintSettings printSettings(const ParameterValues& values, int views)
{
    const PrintTable& table = printTable();
    PrintSettings s;
    s.sheet = sheetOf(values);
    s.dpiX = values[table.dotsPerInch];
    s.dpiY = values[table.dotsDown] > 0 ? values[table.dotsDown] : s.dpiX;
    s.width = mm(values[table.width]);
    s.height = mm(values[table.height]);
    s.bleed = mm(values[table.bleed]);
    s.distance = mm(values[table.distance]);
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
    s.dither = values[table.dither] && values[table.bits] == PrintBits::eight;  // 16 bits need none.
    return s;
}

}  // namespace vitrine::printing

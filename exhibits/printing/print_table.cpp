#include "exhibits/printing/print_table.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/printing/quilt.h"
#include "render/text/joined.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

constexpr int mostOfItself = 24;   // Most rendered views by default: more cost time and show little.
constexpr int viewsOfCharts = 12;  // Number of views that a chart tests by default.

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

const std::vector<std::string>& viewFormats()
{
    static const std::vector<std::string> names = [] {
        const std::vector<std::string_view> endings = render::writtenEndings(viewBits);
        return std::vector<std::string>(endings.begin(), endings.end());
    }();
    return names;
}

const PrintTable& printTable()
{
    static const PrintTable table;
    return table;
}

bool parameterActs(const ParameterInfo& parameter, const ParameterValues& values, bool chart)
{
    const PrintTable& table = printTable();
    const auto isAmong = [&](auto... parameters) {
        return ((parameter.name == table.rows()[parameters.row].name) || ...);
    };
    const ViewOrigin from = values[table.origin];
    if (isAmong(table.saveViews, table.viewFormat, table.sheet)) return false;  // The dialog has no use for these,
    if (isAmong(table.origin, table.files, table.quilt, table.places)) return false;  // and fields for these.
    if (parameter.group == "Views") {
        if (chart)
            return isAmong(table.views) && values[table.chart] != ChartKind::pitch &&
                   values[table.chart] != ChartKind::phase;
        if (isAmong(table.views)) return true;
        if (isAmong(table.quiltColumns, table.quiltRows, table.quiltOrder)) return from == ViewOrigin::quilt;
        return isAmong(table.fitting, table.every, table.pingPong) == (from != ViewOrigin::shown);
    }
    if (parameter.group == "Chart" && !chart) return false;
    if (chart && isAmong(table.border, table.compensate, table.cropMarks, table.registrationMarks, table.colorBar,
                         table.pitchStrip))
        return false;
    return !parameter.actsWhen || holds(*parameter.actsWhen, values);
}

bool sameViews(const ParameterValues& a, const ParameterValues& b)
{
    const PrintTable& table = printTable();
    const bool rendered = b[table.origin] == ViewOrigin::shown;
    const auto decides = [&](const ParameterInfo& row) {
        const auto is = [&](auto parameter) { return row.name == table.rows()[parameter.row].name; };
        if (is(table.places)) return !rendered;
        if (is(table.files)) return b[table.origin] == ViewOrigin::files;
        if (is(table.quilt)) return b[table.origin] == ViewOrigin::quilt;
        if (row.group == "Views") return is(table.origin) || parameterActs(row, b, false);
        // Pictures are fitted to the shape of the print when they are read.
        const bool shapes = row.name == "width" || row.name == "height" || row.name == "bleed";
        if (!rendered && shapes) return b[table.fitting] != Fitting::stretch;
        // The cameras are placed by what the lenses show, and framed by the print's shape.
        return rendered && !is(table.sheet) &&
               (row.group == "Sheet" || row.name == "width" || row.name == "height" || row.name == "bleed" ||
                row.name == "direction" || row.name == "distance" || row.name == "visualPerInch");
    };
    for (std::size_t i = 0; i < a.rows().size(); ++i)
        if (a.row(i) != b.row(i) && decides(a.rows()[i])) return false;
    // The number of rendered views follows the resolution if it is not given.
    return !rendered || b[table.views] > 0 || a[table.dotsPerInch] == b[table.dotsPerInch];
}

std::vector<std::string> picturesOf(const ParameterValues& values)
{
    const PrintTable& table = printTable();
    return linesOf(values[table.origin] == ViewOrigin::quilt ? values[table.quilt] : values[table.files]);
}

ParameterValues withPictures(ParameterValues values, const std::vector<std::string>& pictures)
{
    const PrintTable& table = printTable();
    if (values[table.origin] != ViewOrigin::quilt) {
        values.set(table.files, joined(pictures, "\n"));
        return values;
    }
    values.set(table.quilt, pictures.empty() ? std::string() : pictures.front());
    if (const auto grid = quiltNamed(values[table.quilt])) {
        values.set(table.quiltColumns, grid->columns);
        values.set(table.quiltRows, grid->rows);
    }
    return values;
}

int viewCount(const ParameterValues& values)
{
    if (const int given = values[printTable().views]; given > 0) return given;
    if (values[printTable().origin] == ViewOrigin::chart) return viewsOfCharts;
    return std::clamp(static_cast<int>(PrintLayout(printSettings(values, 1)).pixelsPerLens()), 2, mostOfItself);
}

std::optional<double> strengthOf(const ParameterValues& values)
{
    const PrintTable& table = printTable();
    const double scale = values[table.baselineScale];
    if (scale == baselineThatFits) return std::nullopt;
    if (scale != baselineByMotion) return scale;
    return values[table.turn] == 0 && values[table.sweeps].empty() ? 1 : 0;
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
    s.marks = {values[table.cropMarks], values[table.registrationMarks], values[table.colorBar],
               values[table.pitchStrip]};
    s.inkSpread = mm(values[table.inkSpread]);
    s.compensate = values[table.compensate];
    s.dither = values[table.dither] && values[table.bits] == PrintBits::eight;  // 16 bits need none.
    return s;
}

}  // namespace vitrine::printing

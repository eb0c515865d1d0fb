#include "exhibits/printing/sheet.h"

#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

[[noreturn]] void refuse(const Sheet& sheet, const std::string& why)
{
    throw Failure(ErrorKind::usage,
                  "The sheet" + (sheet.name.empty() ? "" : " \"" + sheet.name + "\"") + " is impossible: " + why + ".");
}

void requirePositive(const Sheet& sheet, double value, const char* what)
{
    if (!(value > 0) || !std::isfinite(value))
        refuse(sheet, std::string(what) + " is " + shortText(value) + "; give a positive number");
}

std::vector<Sheet> makeKnownSheets()
{
    std::vector<Sheet> sheets;
    for (const double lpi : {10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 60.0, 62.0, 75.0, 100.0, 161.0}) {
        sheets.push_back(derivedSheet(shortText(lpi) + "-3d", lpi, 30));
        sheets.push_back(derivedSheet(shortText(lpi) + "-flip", lpi, 50));
    }
    // The example in Wikipedia, "Lenticular printing": pitch 336.65 um, radius 190.5, thickness 457.
    sheets.push_back({"75-measured", mmPerInch / 0.33665, 0, 0.1905, 0.457, 1.557, 0});
    return sheets;
}

}  // namespace

void check(const Sheet& sheet)
{
    if (!(sheet.index > 1) || !std::isfinite(sheet.index)) {
        refuse(sheet, "the refractive index is " + shortText(sheet.index) +
                          "; plastics have 1.49 to 1.6, and it must be above 1");
    }
    requirePositive(sheet, sheet.lpi(), "LPI");
    requirePositive(sheet, sheet.radius, "the radius");
    requirePositive(sheet, sheet.thickness, "the thickness");
    if (!std::isfinite(sheet.conic)) refuse(sheet, "the conic constant is not a number");
    const double half = sheet.pitch() / 2;
    const double reach = 1 - (1 + sheet.conic) * half * half / (sheet.radius * sheet.radius);
    if (!(reach > 0)) {
        const double least = half * std::sqrt(1 + sheet.conic);
        refuse(sheet, "lenses of " + shortText(sheet.pitch()) + " mm need a radius above " + shortText(least) +
                          " mm, and it is " + shortText(sheet.radius) +
                          " mm; focused on its back the sheet is then at least " +
                          shortText(sheet.index * least / (sheet.index - 1)) + " mm thick");
    }
    const double sag = half * half / (sheet.radius * (1 + std::sqrt(reach)));
    if (sheet.thickness <= sag) {
        refuse(sheet, "its lenses are " + shortText(sag) + " mm deep, and the thickness is only " +
                          shortText(sheet.thickness) + " mm");
    }
}

bool sameLens(const Sheet& a, const Sheet& b)
{
    const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-6 * std::max(std::abs(x), std::abs(y)); };
    return near(a.nominalLpi, b.nominalLpi) && near(a.effectiveLpi, b.effectiveLpi) && near(a.radius, b.radius) &&
           near(a.thickness, b.thickness) && near(a.index, b.index) && near(a.conic, b.conic);
}

Sheet derivedSheet(const std::string& name, double lpi, double zoneDegrees, double index)
{
    Sheet sheet{name, lpi, 0, 1, 1, index, 0};
    requirePositive(sheet, lpi, "LPI");
    const double largest = index > 1 ? 2 * std::atan(index - 1) / radiansPerDegree : 0;
    if (!(zoneDegrees > 0) || (index > 1 && !(zoneDegrees < largest))) {
        refuse(sheet, "a viewing zone of " + shortText(zoneDegrees) + " degrees; a lens focused on its back reaches " +
                          shortText(largest) + " degrees with this index");
    }
    sheet.thickness = index * sheet.pitch() / (2 * std::tan(zoneDegrees * radiansPerDegree / 2));
    sheet.radius = sheet.thickness * (index - 1) / index;
    check(sheet);
    return sheet;
}

const std::vector<Sheet>& knownSheets()
{
    static const std::vector<Sheet> sheets = makeKnownSheets();
    return sheets;
}

const Sheet& knownSheet(const std::string& name)
{
    for (const Sheet& sheet : knownSheets())
        if (sheet.name == name) return sheet;
    std::vector<std::string> names;
    for (const Sheet& sheet : knownSheets()) names.push_back(sheet.name);
    throw Failure(ErrorKind::usage, "There is no sheet \"" + name + "\"" + didYouMean(name, names) + " known are " +
                                        joined(names, ", ") + ".");
}

}  // namespace vitrine::printing

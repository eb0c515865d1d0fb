#include "exhibits/lenticular/card_sheet.h"

#include "exhibits/printing/optics.h"
#include "exhibits/printing/sheet.h"

#include <algorithm>
#include <cmath>

namespace vitrine::lenticular {
namespace {

/// Adjusts a sheet until it passes `check`: the curve reaches the cusp, and the print is below it.
CardSheetFound feasible(Sheet sheet)
{
    std::string note;
    const double half = sheet.pitch() / 2;
    const double least = 1.02 * half * std::sqrt(std::max(1 + sheet.conic, 0.0));
    if (sheet.radius < least) {
        sheet.radius = least;
        note = "its radius raised to " + printing::shortText(least) + " mm, which its lenses need";
    }
    const double shallow = 1.05 * printing::sag(sheet, half);
    if (sheet.thickness < shallow) {
        sheet.thickness = shallow;
        note += std::string(note.empty() ? "its" : ", and its") + " thickness raised to " +
                printing::shortText(shallow) + " mm, as deep as its lenses are";
    }
    return {sheet, note};
}

/// Returns the side of a picture that is across the lenses.
double across(const glm::dvec2& size, bool horizontalLenses)
{
    return horizontalLenses ? size.y : size.x;
}

CardPicture viewsPicture(const LenticularTable& table, const ParameterValues& values, const Sheet& sheet,
                         const glm::dvec2& half, const std::shared_ptr<const CardSource>& found,
                         render::AssetStore& assets)
{
    CardPicture result;
    const CardSource& source = *found;
    const bool lying = horizontal(table, values, source);
    const double pitch = sheet.pitch() * 1e-3;
    const double ratio = pitchRatio(table, values, sheet) / (1 + values[table.pitchError]);
    const double width = 2 * across(half, lying);
    const double lenses = width * ratio / pitch;
    const bool flat = values[table.strips] == CardStrips::flat;
    // The number of whole lenses is odd, so one is in the center.
    const int columns = 2 * static_cast<int>(std::ceil(std::max(lenses - 1, 0.0) / 2)) + 1;
    result.texture = viewTexture(assets, found, flat ? columns : 0, lenses, lying);
    if (!result.texture) return result;
    const int texels = lying ? result.texture->height : result.texture->width;
    const bool byLens = flat && texels == columns;
    CardPrintBlock& block = result.block;
    block.views = source.views.count();
    block.pitch = static_cast<float>(pitch);
    block.pitchRatio = static_cast<float>(ratio);
    block.texturePerLens = static_cast<float>(byLens ? 1.0 / columns : 1 / lenses);
    block.size = glm::vec2(result.texture->width, result.texture->height);
    return result;
}

CardPicture rasterPicture(const LenticularTable& table, const ParameterValues& values, const glm::dvec2& half,
                          const CardSource& source)
{
    CardPicture result;
    result.raster = true;
    result.texture = source.raster;
    const double width = 2 * across(half, source.lying);
    CardPrintBlock& block = result.block;
    block.views = source.print.views;
    block.pitch = static_cast<float>(width / source.lenses);
    block.pitchRatio = static_cast<float>(1 / (1 + values[table.pitchError]));
    block.texturePerLens = static_cast<float>(source.rasterSize.x / source.lenses);
    block.size = glm::vec2(source.rasterSize);
    return result;
}

}  // namespace

CardSheetFound cardSheet(const LenticularTable& table, const ParameterValues& values)
{
    const CardSheet kind = values[table.sheetKind];
    Sheet sheet;
    if (kind == CardSheet::custom) {
        sheet = {"custom",
                 values[table.customLpi],
                 0,
                 values[table.radius] * 1e3,
                 values[table.thickness] * 1e3,
                 values[table.refractiveIndex],
                 values[table.conic]};
    } else {
        sheet = printing::knownSheet(
            std::string(values.rows()[table.sheetKind.row].choices[static_cast<std::size_t>(kind)]));
    }
    if (const int slices = values[table.slices]; slices > 0) {
        const double pitch =
            2e3 * (values[table.axis] == CardAxis::vertical ? cardHalfSize.x : cardHalfSize.y) / slices;
        const double scale = pitch / sheet.pitch();
        sheet.radius *= scale;
        sheet.thickness *= scale;
        sheet.nominalLpi = printing::mmPerInch / pitch;
        sheet.effectiveLpi = 0;
    }
    return feasible(sheet);
}

glm::dvec3 dispersedIndex(double index, double abbeNumber)
{
    const auto inverseSquare = [](double micrometers) { return 1 / (micrometers * micrometers); };
    const double b = (index - 1) / abbeNumber / (inverseSquare(0.4861) - inverseSquare(0.6563));
    const auto at = [&](double micrometers) {
        return std::max(1.001, index + b * (inverseSquare(micrometers) - inverseSquare(0.5876)));
    };
    return {at(0.611), at(0.549), at(0.465)};
}

double pitchRatio(const LenticularTable& table, const ParameterValues& values, const Sheet& sheet)
{
    const double distance = values[table.distance] * 1e3;
    switch (values[table.model]) {
    case CardModel::linear: return 1 / (1 + sheet.pitch() / (2 * std::tan(values[table.intendedMaxAngle]) * distance));
    case CardModel::paraxial: return 1 / (1 + sheet.thickness / sheet.index / distance);
    case CardModel::exact: break;
    }
    return sheet.pitch() / printing::printPitch(sheet, distance);
}

glm::dvec2 pictureHalfSize(const LenticularTable& table, const ParameterValues& values, double aspect)
{
    const glm::dvec2 room = glm::dvec2(cardHalfSize) - values[table.margin];
    return room.x / room.y > aspect ? glm::dvec2(room.y * aspect, room.y) : glm::dvec2(room.x, room.x / aspect);
}

bool horizontal(const LenticularTable& table, const ParameterValues& values, const CardSource& source)
{
    return source.raster ? source.lying : values[table.axis] == CardAxis::horizontal;
}

CardPicture cardPicture(const LenticularTable& table, const ParameterValues& values, const Sheet& chosen,
                        const std::shared_ptr<const CardSource>& found, render::AssetStore& assets)
{
    const CardSource& source = *found;
    const glm::dvec2 half = pictureHalfSize(table, values, source.aspect);
    CardPicture picture = source.raster ? rasterPicture(table, values, half, source)
                                        : viewsPicture(table, values, chosen, half, found, assets);
    const Sheet& sheet = source.raster ? source.print.sheet : chosen;
    const double pitch = sheet.pitch();
    // The Gaussian is replaced by a box with the same variance.
    const double ink = std::sqrt(12.0) * values[table.inkSpread] * 1e3 / pitch;
    picture.block.halfSize = glm::vec2(half);
    picture.block.phase = static_cast<float>(values[table.phase]);
    picture.block.slope = static_cast<float>(std::tan(values[table.rotation]));
    picture.block.radius = static_cast<float>(sheet.radius / pitch);
    picture.block.thickness = static_cast<float>(sheet.thickness / pitch);
    picture.block.conic = static_cast<float>(sheet.conic);
    picture.block.blur = static_cast<float>(ink);
    picture.block.index = glm::vec3(values[table.dispersion] ? dispersedIndex(sheet.index, values[table.abbeNumber])
                                                             : glm::dvec3(sheet.index));
    return picture;
}

}  // namespace vitrine::lenticular

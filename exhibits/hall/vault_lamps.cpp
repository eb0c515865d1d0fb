#include "exhibits/hall/vault_lamps.h"

#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/hall/baked_picture.h"
#include "exhibits/hall/sun.h"

#include <algorithm>

namespace vitrine::hall {
namespace {

/// Radiance of a lamp of strength 1. The vault is then a dim background for the pools of the spotlights.
constexpr double radianceOfLamp = 1.1;

}  // namespace

double lampsShareAt(double sunElevation)
{
    const double sunk = std::clamp((lampsBegin - sunElevation) / lampsBegin, 0.0, 1.0);
    return sunk * sunk * (3 - 2 * sunk);
}

VaultLamps vaultLampsOf(const HallTable& table, const ParameterValues& values)
{
    VaultLamps lamps;
    switch (values[table.lamps]) {
    case LampsLit::automatic:
        lamps.share = lampsShareAt(sunOf(table, values).elevation);
        if (lamps.share <= 0) lamps.whyDark = "the sun is too high for lamps";
        break;
    case LampsLit::on: lamps.share = 1; break;
    case LampsLit::off: lamps.whyDark = "the lamps are switched off"; break;
    }
    const double strength = values[table.lampStrength];
    if (lamps.whyDark.empty() && !(strength > 0)) lamps.whyDark = "the strength of the lamps is 0";
    lamps.radiance = blackBodyColor(values[table.lampTemperature]) * (radianceOfLamp * strength * lamps.share);
    return lamps;
}

LampLight::LampLight(const render::Json& table)
{
    air_ = startReadingBaked(table.at("air").at("file").get<std::string>()).get();
    airScale_ = table.at("air").at("scale").get<double>();
    surfaceScale_ = table.at("surfaces").get<double>();
}

}  // namespace vitrine::hall

#pragma once

#include <cstdint>
#include <string_view>

namespace vitrine {

/// Display units of values. Values are stored, computed and uploaded in SI (meters, seconds,
/// radians; hours of the day); only panels, the manual and typed input convert, through `shown` and `stored`.
enum class Unit : std::uint8_t {
    none,
    meter,
    centimeter,
    millimeter,
    micrometer,
    degree,
    second,
    hertz,
    pixel,
    stop,
    percent,
    kelvin,
    perMeter,
    hour
};

struct UnitInfo {
    std::string_view symbol;        ///< As shown: "mm".
    std::string_view storedSymbol;  ///< As stored: "m".
    double shownPerStored;
};

[[nodiscard]] UnitInfo info(Unit);

[[nodiscard]] inline double shown(double stored, Unit unit)
{
    return stored * info(unit).shownPerStored;
}
[[nodiscard]] inline double stored(double shown, Unit unit)
{
    return shown / info(unit).shownPerStored;
}

}  // namespace vitrine

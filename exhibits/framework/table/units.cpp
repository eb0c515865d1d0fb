#include "exhibits/framework/table/units.h"

#include <numbers>

namespace vitrine {

UnitInfo info(Unit unit)
{
    switch (unit) {
    case Unit::none: return {"", "", 1};
    case Unit::meter: return {"m", "m", 1};
    case Unit::centimeter: return {"cm", "m", 100};
    case Unit::millimeter: return {"mm", "m", 1e3};
    case Unit::micrometer: return {"µm", "m", 1e6};
    case Unit::degree: return {"°", "rad", 180 / std::numbers::pi};
    case Unit::second: return {"s", "s", 1};
    case Unit::hertz: return {"Hz", "Hz", 1};
    case Unit::pixel: return {"px", "px", 1};
    case Unit::stop: return {"EV", "EV", 1};
    case Unit::percent: return {"%", "", 100};
    case Unit::kelvin: return {"K", "K", 1};
    case Unit::perMeter: return {"1/m", "1/m", 1};
    case Unit::hour: return {"h", "h", 1};
    }
    return {"", "", 1};
}

}  // namespace vitrine

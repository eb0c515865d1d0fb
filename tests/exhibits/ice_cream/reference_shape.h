#pragma once

#include "exhibits/ice_cream/ice_cream_table.h"

#include <cmath>

namespace vitrine::test {

/// Sets the numbers of the reference's shape that differ from the initial ones: fillets of the cream, height of its
/// upper layer, and places of two candies.
inline void setReferenceShape(const ice_cream::IceCreamTable& table, ParameterValues& values)
{
    values.set(table.sprinkles, 0);
    values.set(table.layerBlend, 0.05);
    for (const ice_cream::CreamParameters& layer : table.layers) values.set(layer.blend, 0.01);
    values.set(table.layers[1].raise, 0.4 * std::cos(1.0) - 0.02);
    values.set(table.candies[3].x, -0.2);
    values.set(table.candies[3].y, 0.84);
    values.set(table.candies[3].z, -0.2);
    values.set(table.candies[5].x, 0.168);
    values.set(table.candies[5].z, -0.156);
}

}  // namespace vitrine::test

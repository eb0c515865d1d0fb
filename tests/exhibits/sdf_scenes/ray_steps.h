#pragma once

#include "tests/exhibits/sdf_scenes/support.h"

#include <cmath>

namespace vitrine::test {

/// Returns the number of rays that pass a surface in a step whose length is the field's distance.
template <typename Field> int overshoots(const Field& field, Random& random, int rays)
{
    int passed = 0;
    for (int ray = 0; ray < rays; ++ray) {
        const glm::dvec3 origin = random.point(4);
        const glm::dvec3 direction = random.direction();
        double t = 0;
        for (int step = 0; step < 60 && t < 12; ++step) {
            const double d = field(origin + t * direction);
            if (std::abs(d) < 1e-4) break;
            // Within the step, the sign must be the same as at its start.
            const double within = t + std::abs(d) * random.number(0.2, 1);
            const double there = field(origin + within * direction);
            if (std::abs(there) > 1e-9 && (there < 0) != (d < 0)) {
                ++passed;
                break;
            }
            t += std::abs(d);
        }
    }
    return passed;
}

}  // namespace vitrine::test

#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace vitrine::test {

/// Shares of the light on one side of a sheet.
struct SheetShares {
    double transmitted = 0, reflected = 0;
    std::uint64_t work = 0;  ///< Number of scatterings, or other steps.
};

/// Traces light from all directions above at float64 through a slab that scatters isotropically in three dimensions.
/// `scatter` and `absorb` are those of Kubelka and Munk, times the thickness: 3/4 of the slab's scattering and twice
/// its absorption (Mudgett and Richards 1971, "Multiple Scattering Calculations for Technology").
inline SheetShares tracedSlab(double scatter, double absorb, std::uint64_t photons, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(0, 1);
    const double scatters = scatter * 4 / 3, all = scatters + absorb / 2;
    SheetShares found;
    for (std::uint64_t i = 0; i < photons; ++i) {
        double depth = 0, cosine = std::sqrt(1 - even(random)), weight = 1;
        while (weight > 1e-9) {
            depth -= std::log(1 - even(random)) / all * cosine;
            if (depth < 0 || depth > 1) break;
            ++found.work;
            weight *= scatters / all;
            cosine = 2 * even(random) - 1;
        }
        if (depth > 1) found.transmitted += weight / static_cast<double>(photons);
        if (depth < 0) found.reflected += weight / static_cast<double>(photons);
    }
    return found;
}

}  // namespace vitrine::test

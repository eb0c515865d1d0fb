#pragma once

#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/sdf_morph/sdf_morph_table.h"
#include "tests/support/degree.h"

namespace vitrine::test {

// Tables of equal structure: a handle of one table is the same parameter in all of them.
inline const hall::HallTable& hallTable()
{
    static const hall::HallTable table;
    return table;
}
/// Puts the sun nearly straight in front of the window, where it shines on the exhibit in the middle of the hall.
inline void letTheSunIn(ParameterValues& hall)
{
    hall.set(hallTable().sunElevation, sdf_morph::straightSunElevation);
    hall.set(hallTable().sunAzimuth, sdf_morph::straightSunAzimuth);
}
inline const crepuscular_rays::CrepuscularRaysTable& raysTable()
{
    static const crepuscular_rays::CrepuscularRaysTable table;
    return table;
}
inline const sdf_morph::SdfMorphTable& sdfTable()
{
    static const sdf_morph::SdfMorphTable table;
    return table;
}

}  // namespace vitrine::test

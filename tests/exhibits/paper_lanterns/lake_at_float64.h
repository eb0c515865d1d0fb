#pragma once

#include "exhibits/kit/blue_noise.h"
#include "exhibits/paper_lanterns/lake_scene.h"
#include "exhibits/paper_lanterns/paper_lanterns_cpu.h"

#include <limits>

namespace vitrine::test {

inline const PaperLanternsTable& lanternsTable()
{
    static const PaperLanternsTable table;
    return table;
}

/// Values with the source's waves and lanterns that fill their cells: the hardest lattice.
inline ParameterValues sourceLake()
{
    const PaperLanternsTable& t = lanternsTable();
    ParameterValues values = t.initial();
    values.set(t.waveHeight, 1.0);
    values.set(t.waveSpeed, LakeSpeed::source);
    values.set(t.crowding, 1.0);
    values.set(t.spacing, 4.0);
    values.set(t.lanterns, 40000);
    return values;
}

/// The lake of these values at float64; only solid lanterns, no glowing points.
inline glsl::Lake lakeAtFloat64(const ParameterValues& values, double seconds)
{
    static const std::shared_ptr<const render::Texture> noise = blueNoise();
    glsl::Lake made;
    copyLake(made.lake, lakeBlock(lanternsTable(), values, seconds, std::numeric_limits<double>::infinity()));
    made.lake.pointWidth = 1e9;
    made.lake.stepLimit = 512;
    made.blueNoise = noise->bytes.data();
    return made;
}

}  // namespace vitrine::test

#pragma once

#include "render/glsl/cpu.h"

/// shaders/lib/tonemap.glsl as C++: the tone curves.

#include "render/glsl/begin_cpu.h"

#include "shaders/lib/tonemap.glsl"

#include "render/glsl/end_cpu.h"

namespace vitrine::test {

/// Tone curve of the hall's parameter `toneCurve`.
struct NamedToneCurve {
    const char* name;
    glm::dvec3 (*map)(glm::dvec3);
};

/// All tone curves, in the order of the parameter's choices.
inline const NamedToneCurve toneCurves[] = {{"Vitrine", glsl::toneVitrine},
                                            {"AgX", glsl::toneAgx},
                                            {"ACES", glsl::toneAces},
                                            {"Khronos neutral", glsl::toneNeutral},
                                            {"none", glsl::toneNone}};

}  // namespace vitrine::test

#pragma once

#include "tests/support/random.h"

#include <glm/glm.hpp>

#include <cmath>

namespace vitrine::test {

inline bool isFinite(double x)
{
    return std::isfinite(x);
}
inline bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace vitrine::test

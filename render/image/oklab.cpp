#include "render/image/oklab.h"

#include <cmath>

namespace vitrine::render {
namespace {

// Rows of the published matrices; glm's constructor takes columns, hence the transposes.
struct OklabMatrices {
    glm::dmat3 conesFromLinear = glm::transpose(glm::dmat3(0.4122214708, 0.5363325363, 0.0514459929,  //
                                                           0.2119034982, 0.6806995451, 0.1073969566,  //
                                                           0.0883024619, 0.2817188376, 0.6299787005));
    glm::dmat3 labFromRoots = glm::transpose(glm::dmat3(0.2104542553, 0.7936177850, -0.0040720468,  //
                                                        1.9779984951, -2.4285922050, 0.4505937099,  //
                                                        0.0259040371, 0.7827717662, -0.8086757660));
    // Inverted numerically, so that a color is unchanged after conversion there and back.
    glm::dmat3 rootsFromLab = glm::inverse(labFromRoots);
    glm::dmat3 linearFromCones = glm::inverse(conesFromLinear);
};

const OklabMatrices& matrices()
{
    static const OklabMatrices all;
    return all;
}

}  // namespace

glm::dvec3 oklabFromLinear(const glm::dvec3& linear)
{
    const glm::dvec3 cones = matrices().conesFromLinear * linear;
    return matrices().labFromRoots * glm::dvec3(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
}

glm::dvec3 linearFromOklab(const glm::dvec3& lab)
{
    const glm::dvec3 roots = matrices().rootsFromLab * lab;
    return matrices().linearFromCones * (roots * roots * roots);
}

}  // namespace vitrine::render

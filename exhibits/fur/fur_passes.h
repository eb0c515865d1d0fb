#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/fur/coat.h"

#include <memory>
#include <string>

namespace vitrine {

/// A furry exhibit at one moment: what its passes are planned from.
struct FurScene {
    const PlanContext& context;
    Coats coats;
    std::shared_ptr<const render::Mesh> skins[furBodyCount];
    std::shared_ptr<const render::Mesh> fins[furBodyCount];  ///< Null unless silhouettes are filled with fins.
};

// Both read the simulation state "fur.bodies".

/// A few shells of each body, in the exhibits' shadow map.
void planCoatShadow(const FurScene&, render::FramePlan&);
/// Shells, fins, light and floor, or why not.
void planCoats(const FurScene&, render::FramePlan&);

}  // namespace vitrine

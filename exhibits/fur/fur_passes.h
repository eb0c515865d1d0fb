#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/fur/coat.h"

#include <memory>
#include <string>

namespace vitrine::fur {

/// State of the exhibit at one time, from which its passes are planned.
struct FurScene {
    const PlanContext& context;
    Coats coats;
    std::shared_ptr<const render::Mesh> skins[furBodyCount];
    std::shared_ptr<const render::Mesh> fins[furBodyCount];  ///< Null unless silhouettes are filled with fins.
};

// The passes of both functions read the simulation state "fur.bodies".

/// Plans a few shells of each body in the shadow map of the exhibits.
void planCoatShadow(const FurScene&, render::FramePlan&);
/// Plans shells, fins, shading and floor, or the reasons for skipping them.
void planCoats(const FurScene&, render::FramePlan&);

}  // namespace vitrine::fur

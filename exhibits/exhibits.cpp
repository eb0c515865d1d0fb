#include "exhibits/exhibits.h"

#include "exhibits/crepuscular_rays/crepuscular_rays.h"
#include "exhibits/fur/fur.h"
#include "exhibits/ice_cream/ice_cream.h"
#include "exhibits/lenticular/lenticular.h"
#include "exhibits/noise/noise.h"
#include "exhibits/paper_lanterns/paper_lanterns.h"
#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/sdf_morph/sdf_morph.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "exhibits/your_shader/your_shader.h"

namespace vitrine {

std::vector<std::unique_ptr<Exhibit>> allExhibits()
{
    std::vector<std::unique_ptr<Exhibit>> exhibits;
    exhibits.push_back(std::make_unique<sdf_morph::SdfMorph>());
    exhibits.push_back(std::make_unique<lenticular::Lenticular>());
    exhibits.push_back(std::make_unique<fur::Fur>());
    exhibits.push_back(std::make_unique<crepuscular_rays::CrepuscularRays>());
    exhibits.push_back(std::make_unique<scenes::SdfScenes>());
    exhibits.push_back(std::make_unique<noise::Noise>());
    exhibits.push_back(std::make_unique<pixel_art::PixelArt>());
    exhibits.push_back(std::make_unique<ice_cream::IceCream>());
    exhibits.push_back(std::make_unique<paper_lanterns::PaperLanterns>());
    exhibits.push_back(std::make_unique<guest::YourShader>());
    return exhibits;
}

}  // namespace vitrine

#include "exhibits/exhibits.h"

#include "exhibits/fur/fur.h"
#include "exhibits/sdf_morph/sdf_morph.h"

namespace vitrine {

std::vector<std::unique_ptr<Exhibit>> allExhibits()
{
    std::vector<std::unique_ptr<Exhibit>> exhibits;
    exhibits.push_back(std::make_unique<SdfMorph>());
    exhibits.push_back(std::make_unique<Fur>());
    return exhibits;
}

}  // namespace vitrine

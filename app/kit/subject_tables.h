#pragma once

#include "exhibits/exhibits.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/hall/hall_table.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::app {

/// Names and initial values of all subjects of the museum, without the building itself.
struct SubjectTables {
    const hall::HallTable hall;
    const std::vector<std::unique_ptr<Exhibit>> exhibits = allExhibits();
    NamedValues values{{"hall", hall.initial()}};

    SubjectTables()
    {
        for (const auto& exhibit : exhibits)
            values.emplace_back(std::string(exhibit->name()), exhibit->parameters().initial());
    }
};

}  // namespace vitrine::app

#pragma once

#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/museum/scene_state.h"
#include "exhibits/study/kept_study.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// Indices of a kept study's parameters in the current tables.
struct KeptParameters {
    struct Row {
        std::size_t subject = 0, row = 0;
    };
    std::vector<Row> rows;         ///< By parameter, as far as they exist.
    std::string missingExhibit;    ///< First exhibit that this museum lacks; empty if none.
    std::string missingParameter;  ///< First parameter that its table lacks; empty if none.

    [[nodiscard]] bool all() const { return missingExhibit.empty() && missingParameter.empty(); }
};
/// Finds the parameters of a study. The scene state's values refer to the tables.
[[nodiscard]] KeptParameters parametersOf(const KeptStudy&, Subjects, const SceneState&);

/// Returns the values of a point for those parameters, all of which must exist. If a value is illegal, returns nothing
/// and sets `wrong` to the name of its parameter.
[[nodiscard]] std::optional<std::vector<Value>> valuesOf(const KeptStudy&, std::size_t point, const KeptParameters&,
                                                         const SceneState&, std::string& wrong);

}  // namespace vitrine::study

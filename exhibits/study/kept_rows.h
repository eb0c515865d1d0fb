#pragma once

#include "exhibits/framework/subject.h"
#include "exhibits/museum/scene_state.h"
#include "exhibits/study/kept_study.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// Where the parameters of a kept study are among the rows that there are now.
struct KeptRows {
    struct Row {
        std::size_t subject = 0, row = 0;
    };
    std::vector<Row> rows;       ///< By parameter; as far as they are there.
    std::string missingExhibit;  ///< That is not in this museum; empty: it is.
    std::string missingRow;      ///< The first that no table has; empty: all are there.

    [[nodiscard]] bool all() const { return missingExhibit.empty() && missingRow.empty(); }
};
/// The look's values have the tables.
[[nodiscard]] KeptRows rowsOf(const KeptStudy&, Subjects, const SceneState&);

/// The values of a point for those rows, all of which are there; nothing, and the parameter's name in `wrong`, where
/// one is no legal value of its row.
[[nodiscard]] std::optional<std::vector<Value>> valuesOf(const KeptStudy&, std::size_t point, const KeptRows&,
                                                         const SceneState&, std::string& wrong);

}  // namespace vitrine

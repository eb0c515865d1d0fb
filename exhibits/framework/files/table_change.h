#pragma once

#include "exhibits/framework/table/parameters.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine {

/// Returns the values under another table. Parameters of the same name and kind keep values that are not initial, made
/// legal; new parameters take pending values; all others are initial, so that unchanged values follow the file that
/// gives the parameters. Animations are kept with their parameters. Problems with a pending value are added to `notes`,
/// one sentence each.
[[nodiscard]] ParameterValues underTable(const ParameterValues&, std::shared_ptr<const Parameters>,
                                         std::vector<std::string>& notes);

/// Returns `values` under the table of `other` if both name the same files for it, else `values` themselves.
[[nodiscard]] ParameterValues withTableOf(const ParameterValues& other, const ParameterValues& values);

}  // namespace vitrine

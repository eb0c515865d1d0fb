#pragma once

#include "exhibits/framework/parameters.h"

#include <string>

namespace vitrine {

/// The file that a value of a file row names: a bare name means a file of the program's own where the row has such
/// (`ParameterInfo::shipped`), anything else is a path as it stands.
[[nodiscard]] std::string filePath(const ParameterInfo&, const std::string& value);

}  // namespace vitrine

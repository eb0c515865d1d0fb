#pragma once

#include "exhibits/framework/table/parameters.h"

#include <string>

namespace vitrine {

/// Returns the file that a value of a file parameter names. A bare name means one of the program's own files, if the
/// parameter has such (`ParameterInfo::assetFolder`). So does a relative path that names one of them, and no file in
/// the current folder. Any other value is returned unchanged.
[[nodiscard]] std::string filePath(const ParameterInfo&, const std::string& value);

}  // namespace vitrine

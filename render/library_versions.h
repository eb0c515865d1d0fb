#pragma once

#include <map>
#include <string>

namespace vitrine::render {

/// Returns the versions of the libraries that this layer is built on, by name. The version is that of the loaded
/// library if the library reports it, else that of the headers.
[[nodiscard]] std::map<std::string, std::string> libraryVersions();

}  // namespace vitrine::render

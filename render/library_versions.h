#pragma once

#include <map>
#include <string>

namespace vitrine::render {

/// The libraries that this layer is built on, by name, with their versions: that of the library which was loaded where
/// it can be asked, else that of the headers.
[[nodiscard]] std::map<std::string, std::string> libraryVersions();

}  // namespace vitrine::render

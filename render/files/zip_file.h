#pragma once

#include <string>
#include <utility>
#include <vector>

namespace vitrine::render {

/// Returns the bytes of a ZIP file (PKWARE APPNOTE 6.3) with these entries, each a name and its content, deflated. The
/// same entries give the same bytes: the date of all of them is 1 January 1980. Throws Failure if the file would have
/// 4 GiB or more.
[[nodiscard]] std::string zipFile(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace vitrine::render

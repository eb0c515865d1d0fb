#pragma once

#include <string>
#include <string_view>

namespace vitrine::render {

/// Sets the commit that the program was built from, as `git describe` names it. Empty: unknown. Call it once, at the
/// start of the program, so that only the program and none of the libraries depends on the commit.
void setProgramCommit(std::string_view commit);

/// Returns the version with the commit, if it is known: "0.2.0+1a2b3c4d", as semantic versioning writes it. With
/// changes that are not committed: "0.2.0+1a2b3c4d-dirty".
[[nodiscard]] const std::string& programVersion();

}  // namespace vitrine::render

#pragma once

#include "exhibits/museum/museum.h"

#include <string>
#include <vector>

namespace vitrine {

/// Returns the names of the hall and of all exhibits.
[[nodiscard]] std::vector<std::string> namesOf(const Museum&);

/// Makes several assignments "name=value". Files that add parameters are set first, whatever the order.
void applySets(const Museum&, SceneState&, std::size_t subject, const std::vector<std::string>& assignments,
               std::vector<std::string>& notes);

/// Makes one assignment "name=value". A name without a dot belongs to `subject`. Plain numbers are in SI units, as in
/// `list --json` and presets; "30deg" and "12mm" give their own unit.
void applySet(const Museum&, SceneState&, std::size_t subject, const std::string& assignment,
              std::vector<std::string>& notes);

/// Parameter index and the subject that it belongs to.
struct NamedParameter {
    std::size_t owner, row;
};
/// Finds the parameter "name" of the subject, or "exhibit.name". Throws Failure (ErrorKind::usage) naming `option`.
[[nodiscard]] NamedParameter namedParameter(const Museum&, const SceneState&, std::size_t subject,
                                            const std::string& name, const std::string& option);

/// Animates one parameter: "name=motion", in the notation of `typedMotion`. Throws Failure (ErrorKind::usage) naming
/// the option.
void applyMotion(const Museum&, SceneState&, std::size_t subject, const std::string& assignment);

}  // namespace vitrine

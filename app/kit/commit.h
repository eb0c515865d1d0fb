#pragma once

namespace vitrine::app {

/// Commit that the program was built from, as `git describe` names it; empty if it is unknown. The build writes its
/// value.
extern const char* const commit;

}  // namespace vitrine::app

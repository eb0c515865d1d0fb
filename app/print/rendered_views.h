#pragma once

#include "app/print/gathered_views.h"

namespace vitrine::app {

/// Renders the views of --exhibit. Throws like `gatherViews`.
[[nodiscard]] GatheredViews renderedViews(const ViewOptions&);

}  // namespace vitrine::app

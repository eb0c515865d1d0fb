#pragma once

#include "app/print/gathered_views.h"

namespace vitrine::app {

/// Renders the views that --exhibit asks for. Throws as `gatherViews`.
[[nodiscard]] GatheredViews renderedViews(const ViewOptions&);

}  // namespace vitrine::app

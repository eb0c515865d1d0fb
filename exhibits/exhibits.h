#pragma once

#include "exhibits/framework/scene/exhibit.h"

namespace vitrine {

/// The exhibits in the order visitors meet them. exhibits.cpp is the only place that names them all.
[[nodiscard]] std::vector<std::unique_ptr<Exhibit>> allExhibits();

}  // namespace vitrine

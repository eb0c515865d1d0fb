#pragma once

#include "exhibits/framework/exhibit.h"
#include "exhibits/printing/print_desk.h"

namespace vitrine {

/// The exhibits in the order visitors meet them. exhibits.cpp is the only place that names them all.
[[nodiscard]] std::vector<std::unique_ptr<Exhibit>> allExhibits();

/// The desk that makes lenticular prints.
[[nodiscard]] std::unique_ptr<PrintDesk> makePrintDesk();

}  // namespace vitrine

#pragma once

#include "exhibits/printing/print_preview.h"
#include "exhibits/printing/print_table.h"
#include "exhibits/printing/print_views.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Plan of a print or chart, or the reason why it is impossible.
struct PrintPlan {
    std::string refusal{};                ///< A full sentence with the limit; empty if the print is possible.
    std::vector<std::string> warnings{};  ///< Full sentences on expected defects.
    std::optional<PrintLayout> layout{};  ///< Unset if the print is impossible.
    PrintNumbers numbers{};               ///< Numbers of the print, with the resolution stored in the file.
    double bytes = 0;                     ///< Size of the file, uncompressed.
};
/// Returns the plan. The file's name determines the format. Impossible settings do not throw, they become `refusal`.
/// Without views, their number is that in the values.
[[nodiscard]] PrintPlan printPlan(const ParameterValues&, const PrintViews*, bool chart, const std::filesystem::path&);

/// Returns a preview of the print, or of the chart if there are no views. Throws Failure if `printPlan` refuses.
[[nodiscard]] std::shared_ptr<const PrintPreview> printPreview(const ParameterValues&,
                                                               std::shared_ptr<const PrintViews>);

/// Writes the print, or the chart if there are no views, and its JSON beside it. Returns the picture files. Throws
/// Failure naming file and cause, also if stopped; then no new files are left and old ones are unchanged.
std::vector<std::filesystem::path> exportPrint(const ParameterValues&, const PrintViews*,
                                               const std::vector<std::string>& sources, const std::filesystem::path&,
                                               const Progress&);

}  // namespace vitrine::printing

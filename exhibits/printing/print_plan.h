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

/// What a print, or a chart, will be, or why it cannot be.
struct PrintPlan {
    std::string refusal{};                ///< A full sentence with the limit; empty when the print can be made.
    std::vector<std::string> warnings{};  ///< Full sentences on what will disappoint.
    std::optional<PrintLayout> layout{};  ///< None where it is refused.
    PrintNumbers numbers{};               ///< With the dpi that the file stores.
    double bytes = 0;                     ///< Of the file, uncompressed.
};
/// The name of the file decides the format. Never throws for settings that cannot be: they are its refusal. Without
/// views, of as many as the values ask for.
[[nodiscard]] PrintPlan printPlan(const ParameterValues&, const PrintViews*, bool chart, const std::filesystem::path&);

/// Throws Failure as `printPlan` refuses. Without views, a preview of the chart.
[[nodiscard]] std::shared_ptr<const PrintPreview> printPreview(const ParameterValues&,
                                                               std::shared_ptr<const PrintViews>);

/// Writes the print, or without views the chart, and its JSON beside it. Returns the picture files. Throws Failure
/// naming file and cause, also when it was stopped; then nothing is left behind and old files stand.
std::vector<std::filesystem::path> exportPrint(const ParameterValues&, const PrintViews*,
                                               const std::vector<std::string>& sources, const std::filesystem::path&,
                                               const Progress&);

}  // namespace vitrine::printing

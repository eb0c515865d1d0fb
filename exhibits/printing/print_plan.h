#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_numbers.h"
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
/// Reads the ICC profile into which the values convert the print; empty if there is none. Throws Failure naming the
/// file.
[[nodiscard]] std::string outputProfile(const ParameterValues&);

/// Returns the plan of a print, or of a chart where that is the origin. The file's name determines the format.
/// Impossible settings do not throw, they become `refusal`. Without views, their number is that in the values.
/// `profile` is what `outputProfile` returns; it is read here if it is null.
[[nodiscard]] PrintPlan printPlan(const ParameterValues&, const PrintViews*, const std::filesystem::path&,
                                  const std::string* profile = nullptr);

/// Returns the values for a chart, which has its own border and views.
[[nodiscard]] ParameterValues chartValues(ParameterValues);

/// Returns path and format of the files of such a print; the description is still missing.
/// `profile`: as for `printPlan`. Throws Failure if it cannot be read.
[[nodiscard]] PrintFile printFile(const ParameterValues&, const std::filesystem::path&,
                                  const std::string* profile = nullptr);

/// Returns a preview of the print, or of the chart if there are no views. Throws Failure if `printPlan` refuses.
[[nodiscard]] std::shared_ptr<const PrintPreview> printPreview(const ParameterValues&,
                                                               std::shared_ptr<const PrintViews>);

/// Returns the description of a print of these views, or of a chart without views, with the effect of compensation.
[[nodiscard]] std::string printText(const ParameterValues&, const PrintViews*, const std::filesystem::path&,
                                    std::optional<CrossTalk>* compensated = nullptr);

/// Writes the print, or the chart if there are no views, and its description beside it. `file` is that of `printFile`
/// with its description. Throws Failure naming file and cause, also if stopped.
[[nodiscard]] StagedPrint stagedPrint(const ParameterValues&, const PrintViews*, PrintFile);

}  // namespace vitrine::printing

#pragma once

#include "exhibits/printing/print_plan.h"

namespace vitrine::printing {

/// Writes a print of these views. Returns the picture files.
inline std::vector<std::filesystem::path> writePrint(const PrintLayout& layout, const ViewSet& views,
                                                     const PrintFile& file)
{
    const StagedPrint staged = stagedPrint(layout, views, file);
    staged.publish();
    return staged.pictures;
}

/// Writes the print of these values, or the chart if there are no views, with its description.
inline std::vector<std::filesystem::path> exportPrint(const ParameterValues& values, const PrintViews* views,
                                                      const std::filesystem::path& path, const Progress& progress = {})
{
    PrintFile file = printFile(values, path);
    file.json = printText(values, views, path);
    file.progress = progress;
    const StagedPrint staged = stagedPrint(values, views, file);
    staged.publish();
    return staged.pictures;
}

}  // namespace vitrine::printing

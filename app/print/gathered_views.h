#pragma once

#include "app/print/view_folder.h"
#include "app/print/view_options.h"

#include "exhibits/printing/print_json.h"
#include "exhibits/printing/view_set.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::app {

/// Views of a print, and their origin.
struct GatheredViews {
    printing::ViewSet views;
    printing::PrintSources sources;      ///< Sources of the views, for the description of the print.
    std::string profile;                 ///< ICC profile of the pictures; empty when they have none.
    std::vector<std::string> notes;      ///< Messages for standard error.
    std::vector<std::string> numbers;    ///< Lines for standard output.
    std::string renderer;                ///< Name of the GPU that drew the views; empty if they were read from files.
    std::unique_ptr<ViewFolder> folder;  ///< Folder of --save-views, not yet published.
};

/// Returns the layout of a print with this number of views. Throws Failure if it is impossible.
[[nodiscard]] printing::PrintLayout layoutOf(const ViewOptions&, int views);

/// Reads or renders the views. All checks that need neither come first. Throws Failure naming the option or file, and
/// also if it was stopped (StopSignal).
[[nodiscard]] GatheredViews gatherViews(const ViewOptions&);

}  // namespace vitrine::app

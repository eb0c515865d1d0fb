#pragma once

#include "app/print/view_folder.h"
#include "app/print/view_options.h"

#include "exhibits/printing/print_json.h"
#include "exhibits/printing/view_set.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::app {

/// The views of a print and where they came from.
struct GatheredViews {
    printing::ViewSet views;
    printing::PrintSources sources;      ///< For the print's description.
    std::string profile;                 ///< ICC profile of the pictures; empty when they have none.
    std::vector<std::string> notes;      ///< For standard error.
    std::vector<std::string> numbers;    ///< For standard output.
    std::string renderer;                ///< That drew them; empty where none were drawn.
    std::unique_ptr<ViewFolder> folder;  ///< Of --save-views, not yet published.
};

/// The layout of a print of so many views. Throws Failure when it cannot be made.
using LayoutOf = std::function<printing::PrintLayout(int views)>;

/// Reads or renders the views that the options ask for; everything that can be refused without reading or
/// rendering is refused first. Throws Failure naming the option or file; also when stopped (StopSignal).
[[nodiscard]] GatheredViews gatherViews(const ViewOptions&, const LayoutOf&);

}  // namespace vitrine::app

#pragma once

#include "app/kit/picture_options.h"
#include "exhibits/printing/print_table.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

class Parts;

/// Options of `print` about its views, as typed.
struct ViewOptions {
    std::vector<std::string> files;  ///< --views: folders and files.
    std::vector<std::string> quilt;  ///< "8x6" and a file; empty: none.
    std::string quiltOrder = "bottom-left";
    std::vector<std::string> places;  ///< Such as "3:1.5,2,-0.5".
    int count = 0;                    ///< 0: all there are, or as many as the print can tell apart.
    int every = 1;
    bool pingPong = false;

    ParameterValues values{printing::printTable()};  ///< Values of the print table, set by `readPrintOptions`.
    PictureOptions scene;                            ///< Options of --exhibit; `subject` is empty without it.
    std::string viewSize;                            ///< Empty: of the print's shape.
    std::string baselineScale;                       ///< A number or "fit"; empty: 1, or 0 where something else moves.
    double turnDegrees = 0;
    std::vector<std::string> sweeps;  ///< "name=a..b".
    Parts* makes = nullptr;           ///< Only a part of the views is rendered, into this.
    const Parts* made = nullptr;      ///< The views were rendered before, in parts.
    std::string saveViews;            ///< A folder; empty: the views are not kept.
    std::string viewFormat = "png";
};

/// Adds the options. Call it after those of the print table were added.
void addViewOptions(CLI::App&, ViewOptions&);

}  // namespace vitrine::app

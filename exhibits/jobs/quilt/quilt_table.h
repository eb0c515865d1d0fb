#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::jobs {

/// Parameters of a quilt. The initial ones are those of a portrait display with 48 views.
struct QuiltTable final : Parameters {
    Group viewsGroup = group("Views");
    Count columns = count("columns", 8, {1, 64}, "Number of columns of views in a quilt.");
    Count rows = count("rows", 6, {1, 64}, "Number of rows of views in a quilt; the first row is at the bottom.");
    Real cone =
        real("cone", degrees(40), degree, Range{0, degrees(150)}.soft(degrees(10), degrees(60)),
             "Angle between the directions to the first and the last camera, seen from the point that the camera "
             "looks at. 0: all views are the same.",
             typedIn(degree));
    Real convergence =
        real("convergence", 0, meter, Range{0.02, 1e6, logarithmic}.soft(0.1, 20),
             "Distance along the view axis to the plane that the display shows sharp. Auto: to the point "
             "that the camera looks at.",
             reads(0, "auto"));

    Group pictureGroup = group("Picture");
    Count width = count("width", 420, Range{1, 8192, logarithmic}.soft(64, 1024), "Size of a view in pixels.",
                        tuple("size", 'x'));
    Count height = count("height", 560, Range{1, 8192, logarithmic}.soft(64, 1024), "Size of a view in pixels.",
                         tuple("size", 'x'));
    Count samples = count("samples", 0, Range{1, 4096, logarithmic}.soft(1, 64),
                          "Samples per pixel: 1 leaves jagged edges, 16 gives smooth ones. Auto: as in the picture "
                          "whose settings are used, else the hall's supersamples if they are set, else 4.",
                          reads(0, "auto"));
};

[[nodiscard]] const QuiltTable& quiltTable();

}  // namespace vitrine::jobs

#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::jobs {

/// Parameters of a picture.
struct PictureTable final : Parameters {
    Group pictureGroup = group("Picture");
    Count width = side("width");
    Count height = side("height");
    Count samples =
        count("samples", 0, Range{1, 4096, logarithmic}.soft(1, 64),
              "Samples per pixel: 1 leaves jagged edges, 16 gives smooth ones, 64 is for prints. Auto: as in "
              "the picture whose settings are used, else the hall's supersamples if they are set, else 4.",
              reads(0, "auto"));
    Toggle transparent =
        toggle("transparent", false,
               "Draw only the exhibit, in the hall's light, and leave everything around it transparent (alpha 0).",
               labeled("Only the exhibit"));
    Toggle runEverything =
        toggle("runEverything", false,
               "Run all passes, even those that can be skipped. The picture stays the same; this is a check.");

    Group fileGroup = group("File");
    Toggle sixteenBit =
        toggle("sixteenBit", false,
               "Write 16 bits per channel: integers in PNG and TIFF, half floats for the color in OpenEXR.",
               labeled("16 bits per channel"));
    Text channels =
        text("channels", "Channels of an OpenEXR file, separated by commas: color, depth, normal, evaluations, "
                         "albedo (base color before light), position, object (which exhibit, as Cryptomatte), motion "
                         "(of the camera since the frame before). Empty: those of the picture whose settings are used, "
                         "else color only.");

private:
    Count side(std::string_view name)
    {
        return count(
            name, 0, Range{1, 1000000, logarithmic}.soft(64, 7680),
            "Width x height in pixels. Auto: as in the window, or as the picture whose settings are used, else "
            "640 x 360; if only one side is given, the aspect ratio stays.",
            tuple("size", 'x'), reads(0, "auto"));
    }
};

[[nodiscard]] const PictureTable& pictureTable();

}  // namespace vitrine::jobs

#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::jobs {

enum class RecordPath : int { automatic, turntable, still, tour, bookmarks };
enum class RecordPace : int { automatic, constant, eased };

/// Parameters of a recording.
struct RecordTable final : Parameters {
    Group cameraGroup = group("Camera");
    Choice<RecordPath> path =
        choice("path", RecordPath::automatic, {"auto", "turntable", "still", "tour", "bookmarks"},
               "Path of the camera: around its target (turntable), none (still), along a tour, or along the bookmarks "
               "set in the window. Auto: around an exhibit; along a tour in the hall.");
    File tour = file("tour", "File of the tour that the camera follows. Empty: a tour past all exhibits.",
                     extensions("json"), when(path, RecordPath::tour), implies(path, RecordPath::tour));
    Real turn = real("turn", 0, degree, Range{degrees(-36000), degrees(36000)}.soft(degrees(-360), degrees(360)),
                     "Angle by which the camera turns around its target, counter-clockwise from above. Auto: once "
                     "around an exhibit that is shown alone, 60° in the hall.",
                     reads(0, "auto"), typedIn(degree), when(path, {RecordPath::turntable, RecordPath::automatic}),
                     implies(path, RecordPath::turntable));
    Choice<RecordPace> pace = choice("pace", RecordPace::automatic, {"auto", "constant", "eased"},
                                     "Speed of the camera: constant, or slower at start and end (eased). Auto: as in "
                                     "the file of the tour; otherwise constant in a loop, else eased.",
                                     whenNot(path, RecordPath::still));

    Group timeGroup = group("Time");
    Real seconds = real("seconds", 8, second, Range{0.001, 36000, logarithmic}.soft(1, 120), "Length of the recording.",
                        labeled("Length"));
    Real framesPerSecond = real("framesPerSecond", 30, hertz, Range{0.1, 240}.soft(1, 60),
                                "Number of frames per second.", labeled("Frame rate"), option("fps", hertz));
    Real shutter = real("shutter", 0, none, {0, 1},
                        "Motion blur: fraction of a frame's time for which it is exposed. 0 is without blur.",
                        labeled("Motion blur"));
    Count shutterSamples = count("shutterSamples", 8, Range{1, 4096, logarithmic}.soft(2, 64),
                                 "Number of points in time within the exposure whose pictures are averaged.",
                                 labeled("Times in the exposure"), whenAbove(shutter, 0));

    Group pictureGroup = group("Picture");
    Count width = count("width", 1280, Range{1, 1000000, logarithmic}.soft(64, 3840), "Size of a frame in pixels.",
                        tuple("size", 'x'));
    Count height = count("height", 720, Range{1, 1000000, logarithmic}.soft(64, 3840), "Size of a frame in pixels.",
                         tuple("size", 'x'));
    Count samples = count("samples", 0, Range{1, 4096, logarithmic}.soft(1, 64),
                          "Samples per pixel: 1 leaves jagged edges, 16 gives smooth ones. Auto: as in the picture "
                          "whose settings are used, else the hall's supersamples if they are set, else 4.",
                          reads(0, "auto"));
    Text channels =
        text("channels", "Channels of OpenEXR frames, separated by commas: color, depth, normal, evaluations, albedo "
                         "(base color before light), position, object (which exhibit, as Cryptomatte), motion (of the "
                         "camera since the frame before). Empty: color only.");
};

[[nodiscard]] const RecordTable& recordTable();

}  // namespace vitrine::jobs

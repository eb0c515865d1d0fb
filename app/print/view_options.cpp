#include "app/print/view_options.h"

#include "app/kit/number_option.h"
#include "app/print/view_folder.h"
#include "exhibits/printing/print_table.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {

namespace {

void addPictureViews(CLI::App& command, ViewOptions& o)
{
    const char* pictures = "Views from pictures";
    command.get_option("--fit")->group(pictures);
    command
        .add_option("--views", o.files,
                    "Views to print: a folder of pictures, or the picture files, in order from left to right. "
                    "Unrelated pictures make a flip")
        ->group(pictures);
    CLI::Option* quilt = command.add_option(
        "--quilt", o.quilt,
        "Picture with a grid of views, as COLUMNSxROWS and file, such as --quilt 8x6 quilt.png. If its size is not "
        "divisible, the size of a view is rounded down and the remainder is cut off");
    quilt->expected(2)->group(pictures);
    addChoice(command, "--quilt-order", o.quiltOrder, {"bottom-left", "top-left"},
              "Position of the first view in the quilt: bottom-left (next to the right, rows upwards, as for Looking "
              "Glass) or top-left (next to the right, rows downwards)")
        ->capture_default_str()
        ->needs(quilt)
        ->group(pictures);
    command
        .add_option(
            "--place", o.places,
            "Turn and shift of single pictures, as PICTURE:TURN,RIGHT,DOWN: the picture's number in viewing order, "
            "degrees clockwise, and percent of the view's width and height, such as 3:1.5,2,-0.5")
        ->allow_extra_args(true)
        ->group(pictures);
    addNumber(command, "--every", o.every, {1, 1e6},
              "Interval at which pictures of --views are taken: 3 takes every third, for example of a video's frames")
        ->capture_default_str()
        ->group(pictures);
    command
        .add_flag("--ping-pong", o.pingPong,
                  "Append the pictures in reverse order (1 2 3 4 3 2), so that the views repeat without a jump")
        ->group(pictures);
}

void addRenderedViews(CLI::App& command, ViewOptions& o)
{
    const char* rendered = "Views of an exhibit";
    CLI::Option* exhibit =
        command.add_option("--exhibit", o.scene.subject, "Name of the exhibit, or hall, whose views are rendered");
    exhibit->group(rendered);
    command
        .add_option("--view-size", o.viewSize,
                    "Width x height of a view in pixels. Default: the print's aspect ratio, at most 1200 on a side")
        ->group(rendered);
    command
        .add_option("--baseline-scale", o.baselineScale,
                    "Distance between the cameras: 1 gives true depth (the default), less is flatter, 0 is a single "
                    "camera (the default with --turn or --sweep), fit is the largest without doubled contours")
        ->group(rendered);
    addNumber(command, "--turn", o.turnDegrees, {-36000, 36000, Unit::degree},
              "Angle in degrees by which the exhibit turns from the first to the last view, as seen when walking "
              "around it to the right; 360 repeats without a jump")
        ->group(rendered);
    command
        .add_option("--sweep", o.sweeps,
                    "Parameter that changes from the first to the last view, as NAME=FROM..TO, such as morph=0..1, or "
                    "time=0..2 in seconds")
        ->take_all()
        ->allow_extra_args(true)
        ->group(rendered);
    command
        .add_option("--save-views", o.saveViews,
                    "Folder into which the views are written, too: view_00.png, view_01.png, ...")
        ->group(rendered);
    addChoice(command, "--view-format", o.viewFormat, viewFormats(), "Format of the files of --save-views")
        ->capture_default_str()
        ->group(rendered);
    addSceneOptions(command, o.scene, rendered);
    for (CLI::Option* option : command.get_options()) {
        if (option->get_group() == rendered && option != exhibit) option->needs(exhibit);
        const std::string name = option->get_name();
        const bool ofPictures = name == "--fit" || name == "--place" || name == "--every" || name == "--ping-pong";
        if (ofPictures) option->excludes(exhibit);
    }
    command.get_option("--convergence")->group(rendered);
}

}  // namespace

void addViewOptions(CLI::App& command, ViewOptions& o)
{
    addPictureViews(command, o);
    addNumber(command, "--count", o.count, {1, printing::mostViews},
              "Number of views. Of pictures: chosen evenly (default: all). Of an exhibit: rendered (default: as many "
              "as are distinguishable in the print, at most 24)");
    addRenderedViews(command, o);
}

}  // namespace vitrine::app

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
                    "A folder of pictures, or the pictures, in the order seen from left to right; two or more of "
                    "anything make a flip")
        ->group(pictures);
    CLI::Option* quilt = command.add_option("--quilt", o.quilt,
                                            "A picture of many views in a grid: COLUMNSxROWS and the file, such as "
                                            "--quilt 8x6 quilt.png. Where it does not "
                                            "divide evenly, views are rounded down and the rest is left out");
    quilt->expected(2)->group(pictures);
    addChoice(command, "--quilt-order", o.quiltOrder, {"bottom-left", "top-left"},
              "Where the quilt's first view is: bottom-left (then rightwards and up, as Looking Glass quilts "
              "have it) or top-left (then rightwards and down)")
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
    addNumber(command, "--every", o.every, {1, 1e6}, "Take every so many of them, as from the frames of a video")
        ->capture_default_str()
        ->group(pictures);
    command
        .add_flag("--ping-pong", o.pingPong,
                  "After the last, back to the first: 1 2 3 4 3 2, so that nothing jumps where the views start again")
        ->group(pictures);
}

void addRenderedViews(CLI::App& command, ViewOptions& o)
{
    const char* rendered = "Views of an exhibit";
    CLI::Option* exhibit =
        command.add_option("--exhibit", o.scene.subject, "Render the views: an exhibit's name, or hall");
    exhibit->group(rendered);
    command
        .add_option("--view-size", o.viewSize,
                    "Width x height of a view in pixels; by default of the print's shape, at most 1200 on a side")
        ->group(rendered);
    command
        .add_option("--baseline-scale", o.baselineScale,
                    "Of the cameras' line: 1 shows depth in its true measure (the default), less is flatter, 0 is one "
                    "camera (the default with --turn or --sweep), fit is the most that shows no doubled contours")
        ->group(rendered);
    addNumber(command, "--turn", o.turnDegrees, {-36000, 36000, Unit::degree},
              "Turn the exhibit on its vertical axis by so many degrees over all views, as if one walked around "
              "it to the right; 360 meets itself")
        ->group(rendered);
    command
        .add_option("--sweep", o.sweeps,
                    "Let a parameter run over the views: name=a..b, such as morph=0..1, or time=0..2 in seconds")
        ->take_all()
        ->allow_extra_args(true)
        ->group(rendered);
    command
        .add_option("--save-views", o.saveViews, "Also write the views into this folder: view_00.png, view_01.png, ...")
        ->group(rendered);
    addChoice(command, "--view-format", o.viewFormat, viewFormats(), "Format of these")
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
              "How many views: of pictures, spread evenly (by default all); of an exhibit, rendered (by "
              "default as many as the print can tell apart, 24 at most)");
    addRenderedViews(command, o);
}

}  // namespace vitrine::app

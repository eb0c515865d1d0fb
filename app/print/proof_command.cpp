#include "app/command.h"
#include "app/number_option.h"
#include "app/print/print_options.h"

#include "exhibits/printing/proof.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"
#include "render/image/image_io.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

namespace fs = std::filesystem;

struct ProofOptions {
    std::string print, out;
    double angle = 0, angleY = 0;
    std::string distance = "inf";
};

int makeProof(const ProofOptions& options)
{
    const bool png = fs::path(options.out).extension() == ".png";
    if (!png && fs::path(options.out).extension() != ".tif")
        throw Failure(Blame::usage, "--out " + options.out + ": give a name that ends in .png or .tif.");
    const printing::Eye eye{options.angle * printing::radiansPerDegree, options.angleY * printing::radiansPerDegree,
                            distanceOf("--distance-mm", options.distance)};
    printing::PrintRaster print = printing::readPrint(options.print);
    if (!print.doubt().empty()) std::fprintf(stderr, "vitrine: %s\n", print.doubt().c_str());
    const render::Image seen = printing::lookThrough(print, eye);
    render::writePicture(options.out, seen, png ? render::PictureFormat::png8 : render::PictureFormat::tiff8,
                         {.pixelsPerInch = print.layout().settings().sheet.lpi()});
    return 0;
}

}  // namespace

void addProofCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("proof", "Show an interlaced print as it looks through its sheet");
    auto options = std::make_shared<ProofOptions>();
    command->add_option("print", options->print, "A file that vitrine print wrote; of a print in tiles, any of them")
        ->required();
    addNumber(*command, "--angle", options->angle, {-85, 85, Unit::degree},
              "Angle of the eye across the lenses, in degrees; positive to the right, or below")
        ->required();
    addNumber(*command, "--angle-y", options->angleY, {-85, 85, Unit::degree},
              "Angle of the eye along the lenses, in degrees; positive above, or to the right");
    command->add_option("--distance-mm", options->distance, "Of the eye, or inf")->capture_default_str();
    command->add_option("--out", options->out, "The picture: .png or .tif, one pixel for each lens")->required();
    command->callback([&chosen, options] { chosen = [options] { return makeProof(*options); }; });
}

}  // namespace vitrine::app

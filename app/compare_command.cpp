#include "app/command.h"

#include "app/picture_options.h"
#include "app/study/study_options.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/image/image_io.h"
#include "render/measure/distance.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

namespace vitrine::app {
namespace {

using render::Metric;

struct CompareOptions {
    std::string reference, test;
    std::string metric;
    std::string heatMap;
    std::optional<double> limit;
    double pixelsPerDegree = render::flipPixelsPerDegree;
};

std::string numberText(double x)
{
    return std::isfinite(x) ? render::shortestNumber(x) : "infinite";
}

int compare(const CompareOptions& options)
{
    const Metric metric = metricOption("--metric", options.metric);
    const std::optional<render::PictureFormat> format =
        options.heatMap.empty() ? std::nullopt : std::optional(pictureFormat("--heatmap", options.heatMap, false));
    const render::Image a = render::readImage(options.reference);
    const render::Image b = render::readImage(options.test);
    if (a.width != b.width || a.height != b.height)
        throw Failure(Blame::usage, options.reference + " is " + std::to_string(a.width) + " × " +
                                        std::to_string(a.height) + " pixels and " + options.test + " " +
                                        std::to_string(b.width) + " × " + std::to_string(b.height) +
                                        "; give two pictures of one size.");
    const std::optional<double> value = render::distance(metric, a, b, options.pixelsPerDegree);
    if (!value)
        throw Failure(Blame::usage, "--metric " + options.metric +
                                        ": both pictures need the channel for it; make them with `vitrine render ... "
                                        "--channels color,depth,normal --out NAME.exr`.");
    if (format) {
        const render::Image errors = *render::errorMap(metric, a, b, options.pixelsPerDegree);
        render::writePicture(options.heatMap, render::heatMap(errors, render::fullScale(metric, errors)), *format);
    }
    // The metric that was asked for comes first, so that a script finds it in the first line.
    std::printf("%-8s %s\n", std::string(toString(metric)).c_str(), numberText(*value).c_str());
    for (const Metric other : render::allMetrics) {
        if (other == metric) continue;
        if (const std::optional<double> also = render::distance(other, a, b, options.pixelsPerDegree))
            std::printf("%-8s %s\n", std::string(toString(other)).c_str(), numberText(*also).c_str());
    }
    if (!options.limit || !render::isBeyond(metric, *value, *options.limit)) return 0;
    std::fprintf(stderr, "vitrine: %s and %s differ by %s %s, beyond the limit of %s.\n", options.reference.c_str(),
                 options.test.c_str(), std::string(toString(metric)).c_str(), numberText(*value).c_str(),
                 numberText(*options.limit).c_str());
    return static_cast<int>(Blame::check);
}

}  // namespace

void addCompareCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("compare", "Say how far a picture is from its reference");
    auto options = std::make_shared<CompareOptions>();
    options->metric = "rmse";
    command->add_option("reference", options->reference, "A picture: PNG, TIFF, OpenEXR, JPEG or HDR")->required();
    command->add_option("test", options->test, "Another of the same size")->required();
    command->add_option("--metric", options->metric, "rmse, psnr, max, beyond, flip, normal or depth")
        ->capture_default_str();
    command->add_option("--heatmap", options->heatMap, "Where they differ, as a picture: .png, .exr or .tif");
    command->add_option("--max", options->limit, "Exit with 1 when the distance is beyond this (for psnr: below it)");
    command->add_option("--pixels-per-degree", options->pixelsPerDegree, "For flip: how large a pixel looks")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 1000.0));
    command->callback([&chosen, options] { chosen = [options] { return compare(*options); }; });
}

}  // namespace vitrine::app

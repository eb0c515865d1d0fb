#include "app/compare/compared_files.h"
#include "app/kit/command.h"
#include "app/kit/findings.h"

#include "app/kit/number_option.h"
#include "app/kit/picture_options.h"
#include "app/kit/say.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/image/color_channels.h"
#include "render/image/image_io.h"
#include "render/measure/distance.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <map>
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
    bool asJson = false;
};

std::string numberText(double x)
{
    return std::isfinite(x) ? render::shortestNumber(x) : "infinite";
}

/// Throws Failure if the metric needs color and the picture has none.
void requireColor(const std::string& file, const render::Image& image, Metric metric)
{
    if (!render::metricInfo(metric).ofColor || image.channelNames.empty()) return;
    if (const std::string why = render::colorChannels(image.channelNames).problem; !why.empty())
        throw Failure(ErrorKind::file, "Cannot compare " + file + ": " + why + ".");
}

render::PictureFormat heatMapFormat(const std::string& file)
{
    if (const auto format = render::writtenFormat(file)) return *format;
    throw Failure(ErrorKind::usage,
                  "--heatmap " + file + ": give a name that ends in " + render::writtenExtensions() + '.');
}

/// Distances of two pictures: the requested one, and all that the pictures have channels for.
struct MeasuredDistances {
    Metric metric;
    double value;
    std::map<Metric, double> all;
};

/// Returns the document of `--json` (assets/schemas/distances.schema.json). An infinite distance is null.
render::Json distancesJson(const CompareOptions& options, const MeasuredDistances& measured, bool isWithin)
{
    const auto number = [](double x) { return std::isfinite(x) ? render::Json(x) : render::Json(nullptr); };
    render::Json document = newDocument("vitrine-distances");
    document["reference"] = options.reference;
    document["test"] = options.test;
    document["metric"] = std::string(toString(measured.metric));
    document["limit"] = options.limit ? render::Json(*options.limit) : render::Json(nullptr);
    document["within"] = isWithin;
    document["distances"] = render::Json{{std::string(toString(measured.metric)), number(measured.value)}};
    for (const auto& [metric, value] : measured.all)
        document["distances"][std::string(toString(metric))] = number(value);
    return document;
}

void printDistances(const MeasuredDistances& measured)
{
    // The requested metric is printed first, so that scripts find it in the first line.
    std::printf("%-8s %s\n", std::string(toString(measured.metric)).c_str(), numberText(measured.value).c_str());
    for (const auto& [other, also] : measured.all)
        if (other != measured.metric)
            std::printf("%-8s %s\n", std::string(toString(other)).c_str(), numberText(also).c_str());
}

int compare(const CompareOptions& options)
{
    const Metric metric = render::metricNamed(options.metric).value();
    const std::optional<render::PictureFormat> format =
        options.heatMap.empty() ? std::nullopt : std::optional(heatMapFormat(options.heatMap));
    std::vector<std::string> warnings;
    const auto [a, b] = comparedFiles(options.reference, options.test, warnings);
    for (const std::string& warning : warnings) say(warning);
    requireColor(options.reference, a, metric);
    requireColor(options.test, b, metric);
    const std::optional<double> value = render::distance(metric, a, b, options.pixelsPerDegree);
    if (!value)
        throw Failure(ErrorKind::usage,
                      "--metric " + options.metric +
                          ": both pictures need the channel for it; make them with `vitrine render ... "
                          "--channels color,depth,normal --out NAME.exr`.");
    if (format) {
        const render::Image errors = *render::errorMap(metric, a, b, options.pixelsPerDegree);
        render::writePicture(options.heatMap, render::heatMap(errors, render::fullScale(metric, errors)), *format);
    }
    const MeasuredDistances measured{metric, *value, render::distances({a, b, options.pixelsPerDegree})};
    const bool isWithin = !options.limit || !render::isBeyond(metric, *value, *options.limit);
    if (options.asJson)
        std::fputs(render::writeJson(distancesJson(options, measured, isWithin)).c_str(), stdout);
    else
        printDistances(measured);
    if (isWithin) return 0;
    say(options.reference + " and " + options.test + " differ by " + std::string(toString(metric)) + ' ' +
        numberText(*value) + ", beyond the limit of " + numberText(*options.limit) + '.');
    return static_cast<int>(ErrorKind::check);
}

}  // namespace

void addCompareCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("compare", "Measure the difference between a picture and its reference");
    auto options = std::make_shared<CompareOptions>();
    options->metric = "rmse";
    command->add_option("reference", options->reference, "Reference picture: " + render::readFormats())->required();
    command->add_option("test", options->test, "Picture to compare with the reference; of the same size")->required();
    std::vector<std::string> metrics;
    for (const render::MetricInfo& each : render::allMetrics()) metrics.emplace_back(each.name);
    addChoice(*command, "--metric", options->metric, metrics, "Measure of the difference that is printed first");
    command->add_option("--heatmap", options->heatMap,
                        "Output file for a picture of the differences: " + render::writtenExtensions());
    addNumber(*command, "--max", options->limit, {},
              "Largest distance allowed (for psnr: the smallest); beyond it, the exit code is 1");
    addPixelsPerDegree(*command, options->pixelsPerDegree)->capture_default_str();
    command->add_flag("--json", options->asJson, "Print the distances as JSON");
    command->callback([&chosen, options] { chosen = [options] { return compare(*options); }; });
}

}  // namespace vitrine::app

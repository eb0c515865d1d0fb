#include "app/command.h"
#include "app/print_options.h"

#include "exhibits/lenticular/chart.h"
#include "exhibits/lenticular/numbers.h"
#include "exhibits/lenticular/print_file.h"
#include "exhibits/lenticular/print_json.h"
#include "render/failure.h"
#include "render/image/image_io.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

namespace vitrine::app {
namespace {

namespace fs = std::filesystem;
using lenticular::PrintLayout;

int threadCount()
{
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
}

/// Evenly spread, the first and the last included.
std::vector<fs::path> chosenViews(std::vector<fs::path> files, int count)
{
    if (count == 0) return files;
    if (count < 0 || static_cast<std::size_t>(count) > files.size()) {
        throw Failure(Blame::usage, "--count " + std::to_string(count) + ": there are " + std::to_string(files.size()) + " views.");
    }
    std::vector<fs::path> chosen;
    for (int i = 0; i < count; ++i) {
        const double at = count == 1 ? 0.5 * static_cast<double>(files.size() - 1) : static_cast<double>(files.size() - 1) * i / (count - 1);
        chosen.push_back(files[static_cast<std::size_t>(at + 0.5)]);
    }
    return chosen;
}

void warnOfShapes(const PrintLayout& layout, const lenticular::ViewSet& views)
{
    const lenticular::PrintSettings& s = layout.settings();
    const double wanted = (s.width + 2 * s.bleed) / (s.height + 2 * s.bleed);
    for (int k = 0; k < views.count(); ++k) {
        const double shape = static_cast<double>(views.view(k).width) / views.height();
        if (shape / wanted > 1.02 || shape / wanted < 0.98) {
            std::fprintf(stderr, "vitrine: The views are not shaped as the print is and are stretched to it.\n");
            return;
        }
    }
}

lenticular::PrintFile printFile(const PrintOptions& options, const PrintLayout& layout, const std::vector<std::string>& sources)
{
    lenticular::PrintFile file;
    file.path = options.out;
    file.bits = options.bits;
    file.compression = streamCompression(options.compression);
    file.tileWidth = options.tileMm;
    file.threads = threadCount();
    file.json = render::writeJson(lenticular::printJson(layout, render::storedDpi(options.out, layout.settings().dpiX), sources));
    return file;
}

void say(const PrintLayout& layout, const PrintOptions& options, const std::vector<fs::path>& written)
{
    for (const std::string& warning : lenticular::warningsOf(layout)) std::fprintf(stderr, "vitrine: %s\n", warning.c_str());
    const lenticular::PrintNumbers numbers = lenticular::numbersOf(layout, render::storedDpi(options.out, layout.settings().dpiX));
    for (const fs::path& path : written) std::printf("%s\n", path.c_str());
    std::printf("%lld x %lld pixels, %.4f pixels per lens, %.6f LPI as stored\n", static_cast<long long>(layout.width()),
                static_cast<long long>(layout.height()), numbers.pixelsPerLens, numbers.effectiveLpi);
    const auto [least, most] = std::minmax_element(numbers.ownShare.begin(), numbers.ownShare.end());
    std::printf("zone %.1f degrees, depth %.1f mm, cross-talk %.0f to %.0f %%, %.0f views can be told apart\n", numbers.zoneDegrees, numbers.depthBudget,
                100 * (1 - *most), 100 * (1 - *least), numbers.effectiveViews);
}

int makeChart(const PrintOptions& options)
{
    using lenticular::ChartKind;
    const ChartKind kind = options.chart == "pitch"   ? ChartKind::pitch
                           : options.chart == "phase" ? ChartKind::phase
                           : options.chart == "views" ? ChartKind::views
                                                      : ChartKind::rotation;
    const PrintLayout layout(printSettings(options, options.count == 0 ? 12 : options.count));
    const lenticular::Chart chart(layout, kind, options.chartSpan / 100);
    const lenticular::PrintFile file = printFile(options, layout, {options.chart + " chart"});
    const std::vector<fs::path> written = lenticular::writeRaster(
        layout,
        {[&](const lenticular::Region& region, std::uint8_t* out) { chart.fill(region, out); },
         [&](const lenticular::Region& region, std::uint16_t* out) { chart.fill(region, out); }},
        file);
    if (!options.report.empty()) render::atomicWrite(options.report, file.json);
    for (const fs::path& path : written) std::printf("%s\n", path.c_str());
    return 0;
}

int makePrint(const PrintOptions& options)
{
    if (!options.chart.empty()) return makeChart(options);
    if (options.views.empty()) throw Failure(Blame::usage, "There are no views; give a folder or files with --views.");
    const std::vector<fs::path> files = chosenViews(lenticular::viewFiles(options.views), options.count);
    // Everything that can be refused without reading a picture is refused first.
    const PrintLayout layout(printSettings(options, static_cast<int>(files.size())));
    std::vector<std::string> sources;
    for (const fs::path& file : files) sources.push_back(file.filename().string());
    const lenticular::ViewSet views = lenticular::readViews(files);
    warnOfShapes(layout, views);
    lenticular::PrintFile file = printFile(options, layout, sources);
    file.profile = render::embeddedProfile(files.front());
    if (layout.settings().compensate) {
        const lenticular::ViewMatrix mixing = lenticular::viewMixing(layout);
        const lenticular::CrossTalk talk = lenticular::crossTalkOf(views, mixing, lenticular::compensation(mixing));
        file.json = lenticular::withCrossTalk(file.json, talk);
        std::printf("cross-talk %.4f before, %.4f after compensation (root mean square, simulated); %.1f %% beyond black or white\n", talk.before,
                    talk.after, 100 * talk.clipped);
    }
    const std::vector<fs::path> written = lenticular::writePrint(layout, views, file);
    if (!options.report.empty()) render::atomicWrite(options.report, file.json);
    say(layout, options, written);
    return 0;
}

}  // namespace

void addPrintCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("print", "Interlace views into a print for a lenticular sheet");
    auto options = std::make_shared<PrintOptions>();
    addPrintOptions(*command, *options);
    command->callback([&chosen, options] { chosen = [options] { return makePrint(*options); }; });
}

}  // namespace vitrine::app

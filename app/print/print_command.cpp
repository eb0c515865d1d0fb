#include "app/kit/command.h"
#include "app/kit/progress.h"
#include "app/kit/say.h"
#include "app/print/gathered_views.h"
#include "app/print/print_options.h"
#include "app/queue/parts.h"

#include "exhibits/framework/table/value_text.h"
#include "exhibits/printing/chart.h"
#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"
#include "render/image/picture_formats.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

namespace vitrine::app {
namespace {

namespace fs = std::filesystem;
using printing::PrintLayout;

/// Returns path and file format of the print; its description is added later.
printing::PrintFile target(const PrintOptions& options)
{
    printing::PrintFile file;
    file.path = options.out;
    file.report = options.report;
    const printing::PrintTable& table = printing::printTable();
    file.bits = printing::bitsOf(options.views.values);
    file.compression = options.views.values[table.compression];
    file.tileWidth = options.views.values[table.tileWidth] * 1000;
    file.threads = printing::interlacingThreads();
    return file;
}

printing::PrintFile printFile(const PrintOptions& options, const PrintLayout& layout,
                              const printing::PrintSources& sources)
{
    printing::PrintFile file = target(options);
    file.json = render::writeJson(printing::printJson(options.views.values, layout,
                                                      render::storedDpi(options.out, layout.settings().dpiX), sources));
    return file;
}

void describe(const PrintLayout& layout, const PrintOptions& options, const std::vector<fs::path>& written)
{
    for (const std::string& warning : printing::warningsOf(layout)) say(warning);
    const printing::PrintNumbers numbers =
        printing::numbersOf(layout, render::storedDpi(options.out, layout.settings().dpiX));
    for (const fs::path& path : written) std::printf("%s\n", path.c_str());
    std::printf("%lld x %lld pixels, %.4f pixels per lens, %.6f LPI as stored\n",
                static_cast<long long>(layout.width()), static_cast<long long>(layout.height()), numbers.pixelsPerLens,
                numbers.effectiveLpi);
    const auto [least, most] = std::minmax_element(numbers.ownShare.begin(), numbers.ownShare.end());
    std::printf("zone %.1f degrees, depth %.1f mm, cross-talk %.0f to %.0f %%, %.0f views can be told apart\n",
                numbers.zoneDegrees, numbers.depthBudget, 100 * (1 - *most), 100 * (1 - *least),
                numbers.effectiveViews);
}

/// Throws Failure if the print cannot be written. Called before the views are rendered, which takes minutes.
void checkTarget(const PrintOptions& options)
{
    const std::string& out = options.out;
    const render::PictureFileFormat* format = render::formatNamed(out);
    if (!format || !format->isStreamed)
        throw Failure(ErrorKind::usage,
                      "--out " + out + ": give a name that ends in " + render::streamedExtensions() + '.');
    const fs::path folder = render::PartFile(out).target().parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0)
        throw Failure(ErrorKind::file,
                      "Cannot write " + out + ": " + std::strerror(errno) + "; choose another folder.");
    printing::requireRoom(layoutOf(options.views, 1), target(options));
}

int makeChart(const PrintOptions& options)
{
    const printing::PrintTable& table = printing::printTable();
    const ParameterValues& values = options.views.values;
    const PrintLayout layout = layoutOf(options.views, options.views.count == 0 ? 12 : options.views.count);
    const printing::Chart chart(layout, values[table.chart], values[table.chartSpan]);
    const std::string kind = formatValue(values.rows()[table.chart.row], values.row(table.chart.row));
    const printing::PrintFile file = printFile(options, layout, {{kind + " chart"}});
    const std::vector<fs::path> written = printing::writeChart(layout, chart, file);
    for (const fs::path& path : written) std::printf("%s\n", path.c_str());
    return 0;
}

int makePart(const PrintOptions& options)
{
    if (options.views.scene.subject.empty() || options.out.empty())
        throw Failure(ErrorKind::usage,
                      "--shard " + options.part.shard +
                          ": only views that are rendered are made in parts; give an --exhibit and --out.");
    checkTarget(options);
    return runPart(options.out, parseShard(options.part.shard), [&](Parts& parts) -> std::optional<std::string> {
        ViewOptions views = options.views;
        views.makes = &parts;
        const GatheredViews made = gatherViews(views);
        for (const std::string& note : made.notes) say(note);
        return made.renderer;
    });
}

int makePrint(const PrintOptions& options)
{
    if (options.out.empty() && (options.views.saveViews.empty() || options.isChart))
        throw Failure(ErrorKind::usage, "--out is missing: say where the print goes, to a name that ends in " +
                                            render::streamedExtensions() + '.');
    if (!options.part.shard.empty()) return makePart(options);
    if (options.isChart) return makeChart(options);
    if (!options.out.empty()) checkTarget(options);
    std::optional<Parts> parts;
    if (options.part.fromParts) parts.emplace(fs::path(options.out));
    ViewOptions views = options.views;
    views.made = parts ? &*parts : nullptr;
    GatheredViews made = gatherViews(views);
    for (const std::string& note : made.notes) say(note);
    const PrintLayout layout = layoutOf(views, made.views.count());
    if (const std::string stretched = printing::stretchWarning(layout, made.views); !stretched.empty()) say(stretched);
    std::vector<fs::path> written;
    printing::PrintFile file = printFile(options, layout, made.sources);
    if (!options.out.empty()) {
        file.profile = made.profile;
        if (layout.settings().compensate) {
            const printing::ViewMatrix mixing = printing::viewMixing(layout);
            const printing::CrossTalk talk = printing::crossTalkOf(made.views, mixing, printing::compensation(mixing));
            file.json = printing::withCrossTalk(file.json, talk);
            std::printf("cross-talk %.4f before, %.4f after compensation (root mean square, simulated); %.1f %% beyond "
                        "black or white\n",
                        talk.before, talk.after, 100 * talk.clipped);
        }
        ProgressLine line("interlacing");
        file.progress = [&](double part) { return line.show(part); };
        written = printing::writePrint(layout, made.views, file);
    }
    if (options.out.empty() && !options.report.empty()) render::atomicWrite(options.report, file.json);
    if (made.folder) {
        made.folder->publish();
        std::printf("%d views in %s\n", made.views.count(), options.views.saveViews.c_str());
    }
    if (!written.empty()) describe(layout, options, written);
    for (const std::string& line : made.numbers) std::printf("%s\n", line.c_str());
    return 0;
}

/// Makes the print. Ctrl-C stops it in an orderly way: unfinished files are removed, and the message is that of the
/// stopped step.
int makeStoppably(const PrintOptions& options)
{
    const StopSignal signal;
    try {
        return makePrint(options);
    } catch (const Failure& failure) {
        if (!StopSignal::stopped()) throw;
        say(failure.what());
        return StopSignal::exitCode;
    }
}

}  // namespace

void addPrintCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("print", "Interlace views into a print for a lenticular sheet");
    auto options = std::make_shared<PrintOptions>();
    addPrintOptions(*command, *options);
    addPartOptions(*command, options->part);
    command->callback([&chosen, options, command] {
        chosen = [options, command] {
            readPrintOptions(*command, *options);
            return makeStoppably(*options);
        };
    });
}

}  // namespace vitrine::app
